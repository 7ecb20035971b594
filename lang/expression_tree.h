/*
 * The trees that expressions become inside function { } when they depend on its arguments. Built in
 * the parse arena, read by the compiler (lang/function_compile.c), immutable.
 */
#ifndef LANG_EXPRESSION_TREE_H
#define LANG_EXPRESSION_TREE_H

#include "lang/expression.h"

typedef enum ExpressionKind {
	EXPRESSION_CONSTANT,
	EXPRESSION_ARGUMENT, /* number: which */
	EXPRESSION_UNARY, /* op, parts[0] */
	EXPRESSION_BINARY, /* op, parts[0], parts[1] */
	EXPRESSION_CONDITIONAL, /* parts: test, yes, no */
	EXPRESSION_CALL, /* a built-in: word, parts */
	EXPRESSION_FUNCTION, /* a user's: callee, parts */
	EXPRESSION_VECTOR, /* a vector function's result, allowed under COMPONENT only: callee,
			      parts */
	EXPRESSION_COMPONENT, /* number: 0..4 of parts[0], a VECTOR; 5: its grey value */
	EXPRESSION_LOOP, /* sum or prod (word): number is the variable's argument; parts: from, to,
			    body */
} ExpressionKind;

struct Expression {
	ExpressionKind kind;
	Operator op;
	Word word;
	int number;
	double constant;
	Value callee;
	const Expression *const *parts;
	int part_count;
};

/* A tree over values, each a float or a tree; reports and gives float 0 when one is something else.
 */
Value expression_tree(Context *context, Expression root, const Value *parts, int count,
		      Location where);
/* The tree of a float or tree value. */
const Expression *expression_of(Arena *arena, Value value);

#endif
