/*
 * User functions, compiled: float functions of up to 56 arguments, and vector functions (a
 * pigment's colour, a transformed point, a spline). No global state: any number of threads may
 * evaluate one at once; nothing is allocated.
 *
 * A float function is native (an internal one, a pattern) or a program for a register machine, made
 * by surface/function_program.h.
 */
#ifndef SURFACE_FUNCTION_H
#define SURFACE_FUNCTION_H

#include <stdbool.h>

#include "base/arena.h"

enum { FUNCTION_MAX_ARGUMENTS = 56 };

typedef struct Function Function;

int function_arity(const Function *function);
/* args holds function_arity values. */
double function_eval(const Function *function, const double *args);

/* True for the internal functions that are known to differ from POV-Ray's. */
bool function_is_approximate(const Function *function);

typedef double FunctionNative(const void *data, const double *args);

/* data must outlive the function. */
const Function *function_native(Arena *arena, int arity, FunctionNative *native, const void *data);

typedef void VectorFunctionEval(const void *data, const double *args, double out[5]);

typedef struct VectorFunction {
	int arity;
	int size;     /* components that mean something; the rest of out is 0 */
	bool color;   /* out is red, green, blue, filter, transmit */
	VectorFunctionEval *eval;
	const void *data;
} VectorFunction;

#endif
