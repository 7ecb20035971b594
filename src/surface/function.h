/*
 * User functions, compiled: float functions of up to 56 arguments. A program works on an array of double registers, has no
 * global state and may run in any number of threads at once.
 */
#ifndef SURFACE_FUNCTION_H
#define SURFACE_FUNCTION_H

typedef struct Function Function;

int function_arity(const Function *function);
/* args holds function_arity values. */
double function_eval(const Function *function, const double *args);

#endif
