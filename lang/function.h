/*
 * function { } : from the tree of an expression, or a pigment, a pattern, a transform or a spline,
 * to a compiled function.
 */
#ifndef LANG_FUNCTION_H
#define LANG_FUNCTION_H

#include "lang/context.h"
#include "lang/node.h"

/* The words a function body reads as arguments: declared parameters, or x y z (u v name the first
 * two) when count is 0. Between function_open and function_define the expressions are trees where
 * they depend on arguments. Nests. */
void function_open(Context *context, const char *const *parameters, int count);
/* The number of the argument that name stands for in the innermost open function, or -1. */
int function_argument(const Context *context, const char *name, size_t length);
Value function_argument_value(Context *context, int argument);
/* sum(i, from, to, body) and prod(...), inside an open function only: open after the name was read,
 * so that the name is an argument (function_argument finds it) until close. Both report outside a
 * function; close then gives float 0. */
void function_loop_open(Context *context, const char *name, Location where);
Value function_loop_close(Context *context, Word word, const Value range[2], Value body,
			  Location where);
/* internal(n) inside function { }: the whole body. n is one of POV-Ray's built-in functions, 0
 * to 78. */
Value function_internal(Context *context, Value number, Location where);
/* Ends the innermost open function: body is one NODE_VALUE (an expression) or one NODE_BLOCK
 * pigment, pattern, transform or spline. VALUE_FUNCTION or VALUE_VECTOR_FUNCTION; VALUE_NONE after
 * a reported error. */
Value function_define(Context *context, const Node *body, Location where);

#endif
