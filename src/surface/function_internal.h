/*
 * POV-Ray's internal functions, `function { internal(N) }`, which functions.inc gives names:
 * formulas as its manual and its output tell. A row a function; each family has a file.
 *
 * Every one gets x, y, z and then its own parameters.
 */
#ifndef SURFACE_FUNCTION_INTERNAL_H
#define SURFACE_FUNCTION_INTERNAL_H

#include "surface/function.h"

typedef struct InternalFunction {
	int number;     /* of internal() */
	int parameters; /* beside x, y, z */
	FunctionNative *eval;
	bool approximate; /* not what POV-Ray computes, only near it */
} InternalFunction;

/* Each ends with a row whose eval is NULL. */
extern const InternalFunction function_internal_shapes[];  /* distances and simple solids */
extern const InternalFunction
	function_internal_curves[]; /* helixes, spirals, tubes, weaves, hexagons */
extern const InternalFunction function_internal_algebra[]; /* algebraic surfaces */
extern const InternalFunction function_internal_plane[];   /* plane curves, extruded or swept */
extern const InternalFunction function_internal_blobs[];   /* sums of exponentials */
extern const InternalFunction
	function_internal_noise[]; /* noise and fractals; data is the default generator, an int */

/* The usual bounds of a field: POV-Ray keeps these functions within 10. */
double function_internal_limit(double value);

#endif
