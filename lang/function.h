/*
 * function { } : from the tree of an expression, or a pigment, a pattern, a transform or a spline, to a compiled function.
 */
#ifndef LANG_FUNCTION_H
#define LANG_FUNCTION_H

#include "lang/context.h"
#include "lang/node.h"

/* The words a function body reads as arguments: declared parameters, or x y z (u v name the first two) when count is 0.
 * Between function_open and function_define the expressions are trees where they depend on arguments. Nests. */
void function_open(Context *context, const char *const *parameters, int count);
/* The number of the argument that name stands for in the innermost open function, or -1. */
int function_argument(const Context *context, const char *name, size_t length);
Value function_argument_value(Context *context, int argument);
/* Ends the innermost open function: body is one NODE_VALUE (an expression) or one NODE_BLOCK pigment, pattern, transform or
 * spline. VALUE_FUNCTION or VALUE_VECTOR_FUNCTION; VALUE_NONE after a reported error. */
Value function_define(Context *context, const Node *body, Location where);

#endif
