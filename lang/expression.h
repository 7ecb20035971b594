/*
 * Expressions: operators and built-in functions over values. Constants fold at once; inside
 * function { } a tree (VALUE_EXPRESSION) is built instead and later compiled (lang/function.h).
 *
 * Every function reports mistakes with the location and returns a float 0 then, so the parse goes
 * on.
 */
#ifndef LANG_EXPRESSION_H
#define LANG_EXPRESSION_H

#include "base/diag.h"
#include "lang/context.h"
#include "lang/value.h"
#include "lang/word.h"

/* A boolean of the language: true when the number is not within 1e-10 of 0. */
static inline bool expression_is_true(double x) { return fabs(x) > 1e-10; }

typedef enum Operator {
	OP_ADD,
	OP_SUB,
	OP_MUL,
	OP_DIV,
	OP_NEG,
	OP_PLUS,
	OP_NOT,
	OP_LESS,
	OP_LESS_EQUAL,
	OP_EQUAL,
	OP_NOT_EQUAL,
	OP_GREATER_EQUAL,
	OP_GREATER,
	OP_AND,
	OP_OR
} Operator;

Value expression_unary(Context *context, Operator op, Value a, Location where);
Value expression_binary(Context *context, Operator op, Value a, Value b, Location where);
Value expression_conditional(Context *context, Value test, Value yes, Value no, Location where);
/* A built-in function's word with its arguments: sin(x), vrotate(v, r), concat(...), str(...),
 * trace(...). */
Value expression_call(Context *context, Word function, const Value *args, int count,
		      Location where);
/* trace(object, from, direction [, variable]): the point hit, and in *normal the vector to store in
 * the variable (<0,0,0> when nothing was hit); normal may be NULL. */
Value expression_trace(Context *context, const Value args[3], Value *normal, Location where);
/* A user's function, spline or vector function. */
Value expression_apply(Context *context, Value callee, const Value *args, int count,
		       Location where);
/* < a, b, ... > of 2 to 5 components. */
Value expression_vector(Context *context, const Value *parts, int count, Location where);
/* v.x, c.red, v.u ...; member is the word's spelling. */
Value expression_member(Context *context, Value of, const char *member, Location where);
/* rgb e, rgbft e, srgb e ...; the keyword's word. */
Value expression_color(Context *context, Word keyword, Value of, Location where);
/* c filter e, c red e: c with one component replaced. */
Value expression_color_part(Context *context, Value color, Word part, Value of, Location where);
/* x, pi, clock, image_width, yes ... In a function body x, y, z, u, v become arguments where the
 * function has them. */
Value expression_constant(Context *context, Word word, Location where);

#endif
