/*
 * A slice through a four-dimensional Julia set: points h whose iterates f(h) + p stay within radius
 * 4. Found by stepping along the ray with an estimated distance.
 */
#ifndef GEOM_JULIA_FRACTAL_H
#define GEOM_JULIA_FRACTAL_H

#include "base/arena.h"
#include "geom/shape.h"

typedef enum JuliaFunction {
	JULIA_SQR,
	JULIA_CUBE,
	JULIA_EXP,
	JULIA_RECIPROCAL,
	JULIA_SIN,
	JULIA_ASIN,
	JULIA_SINH,
	JULIA_ASINH,
	JULIA_COS,
	JULIA_ACOS,
	JULIA_COSH,
	JULIA_ACOSH,
	JULIA_TAN,
	JULIA_ATAN,
	JULIA_TANH,
	JULIA_ATANH,
	JULIA_LN,
	JULIA_PWR,
} JuliaFunction;

typedef struct JuliaDesc {
	double parameter[4];
	bool hypercomplex; /* else quaternion, with sqr and cube only */
	JuliaFunction function;
	Vec2 exponent; /* of pwr(x, y) */
	int max_iteration; /* 20 */
	double precision; /* 20 */
	double slice_normal[4]; /* 0, 0, 0, 1 */
	double slice_distance;
} JuliaDesc;

JuliaDesc julia_default(void);
/* NULL with *error set when the slice's fourth component is zero or the algebra has no such
 * function. */
const void *julia_create(Arena *arena, const JuliaDesc *desc, const char **error);
extern const ShapeClass julia_fractal_class;

#endif
