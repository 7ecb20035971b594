#include "lang/function.h"

#include <string.h>

#include "lang/build.h"
#include "lang/build_pattern.h"
#include "lang/build_transform.h"
#include "lang/expression_tree.h"
#include "lang/function_compile.h"
#include "lang/spline.h"
#include "surface/function_natives.h"

/* One open function body. Names of arguments come first, those of open sums and products after
 * them. */
struct FunctionScope {
	struct FunctionScope *outer;
	const char *names[FUNCTION_MAX_ARGUMENTS];
	int count, arity;
	int excess; /* loops that found no room */
};

void function_open(Context *context, const char *const *parameters, int count)
{
	static const char *const usual[3] = {"x", "y", "z"};
	struct FunctionScope *scope = ARENA_NEW(context->parse, struct FunctionScope);
	if (count == 0) {
		parameters = usual;
		count = 3;
	}
	if (count > FUNCTION_MAX_ARGUMENTS) {
		diag_error(context->diag, (Location){0}, "a function takes at most %d arguments",
			   FUNCTION_MAX_ARGUMENTS);
		count = FUNCTION_MAX_ARGUMENTS;
	}
	for (int i = 0; i < count; i++)
		scope->names[i] = parameters[i];
	scope->count = scope->arity = count;
	scope->outer = context->functions;
	context->functions = scope;
}

static int name_index(const struct FunctionScope *scope, const char *name, size_t length)
{
	for (int i = scope->count - 1; i >= 0; i--)
		if (strlen(scope->names[i]) == length && memcmp(scope->names[i], name, length) == 0)
			return i;
	return -1;
}

int function_argument(const Context *context, const char *name, size_t length)
{
	static const char synonyms[][2] = {{'x', 'u'}, {'u', 'x'}, {'y', 'v'}, {'v', 'y'}};
	if (!context->functions)
		return -1;
	int index = name_index(context->functions, name, length);
	for (int i = 0; i < 4 && index < 0 && length == 1; i++)
		if (name[0] == synonyms[i][0])
			index = name_index(context->functions, &synonyms[i][1], 1);
	return index;
}

Value function_argument_value(Context *context, int argument)
{
	Expression *tree = ARENA_NEW(context->parse, Expression);
	*tree = (Expression){.kind = EXPRESSION_ARGUMENT, .number = argument};
	return (Value){.kind = VALUE_EXPRESSION, .expression = tree};
}

void function_loop_open(Context *context, const char *name, Location where)
{
	struct FunctionScope *scope = context->functions;
	if (!scope) {
		diag_error(context->diag, where,
			   "sums and products can only be used in a function");
	} else if (scope->count == FUNCTION_MAX_ARGUMENTS) {
		diag_error(context->diag, where, "too many nested sums and products");
		scope->excess++;
	} else {
		scope->names[scope->count++] = name;
	}
}

Value function_loop_close(Context *context, Word word, const Value range[2], Value body,
			  Location where)
{
	struct FunctionScope *scope = context->functions;
	if (!scope)
		return value_float(0);
	if (scope->excess > 0) {
		scope->excess--;
		return value_float(0);
	}
	scope->count--;
	Value parts[3] = {range[0], range[1], body};
	Expression root = {.kind = EXPRESSION_LOOP, .word = word, .number = scope->count};
	return expression_tree(context, root, parts, 3, where);
}

Value function_internal(Context *context, Value number, Location where)
{
	int generator = context->builder->settings.noise_generator;
	const Function *function = NULL;
	if (number.kind == VALUE_FLOAT && number.number >= 0 && number.number < 1000)
		function = function_internal_find(context->builder->arena, (int)number.number,
						  generator);
	if (function)
		return value_item(VALUE_FUNCTION, function);
	diag_error(context->diag, where, "no such internal function");
	return value_none();
}

/* ---- defining ---- */

static Value define_expression(Context *context, Value body, int arity, Location where)
{
	if (body.kind == VALUE_FUNCTION)
		return body;
	if (body.kind != VALUE_FLOAT && body.kind != VALUE_EXPRESSION) {
		if (body.kind != VALUE_NONE)
			diag_error(context->diag, where, "a function computes a float, found %s",
				   value_describe(body));
		return value_none();
	}
	const Expression *tree = expression_of(context->parse, body);
	if (tree->kind == EXPRESSION_VECTOR) {
		diag_error(context->diag, where,
			   "a function computes a float: name a member of the vector function");
		return value_none();
	}
	const Function *function = function_compile(tree, arity, context->parse,
						    context->builder->arena);
	if (function)
		return value_item(VALUE_FUNCTION, function);
	diag_error(context->diag, where, "the function is too long");
	return value_none();
}

static void eval_spline(const void *data, const double *args, double out[5])
{
	spline_eval(data, args[0], out);
}

static Value define_spline(Context *context, const Node *body)
{
	Value spline = spline_build(context, body);
	if (spline.kind != VALUE_SPLINE)
		return value_none();
	VectorFunction function = {1, spline.spline->size, false, eval_spline, spline.spline};
	return value_item(VALUE_VECTOR_FUNCTION,
			  arena_copy(context->builder->arena, &function, sizeof function));
}

static Value define_block(Context *context, const Node *body, Location where)
{
	Arena *arena = context->builder->arena;
	switch (body->word) {
	case W_pattern: {
		const Pattern *pattern = build_pattern_block(context, body);
		return pattern ? value_item(VALUE_FUNCTION, function_of_pattern(arena, pattern))
			       : value_none();
	}
	case W_pigment: {
		Value pigment = build_value(context, body);
		return pigment.kind == VALUE_PIGMENT
			       ? value_item(VALUE_VECTOR_FUNCTION,
					    function_of_pigment(arena, pigment.item))
			       : value_none();
	}
	case W_transform: {
		Transform transform = build_transform(context, body);
		return value_item(VALUE_VECTOR_FUNCTION, function_of_transform(arena, &transform));
	}
	case W_spline:
		return define_spline(context, body);
	default:
		diag_error(context->diag, where,
			   "expected an expression, a pigment, a pattern, a transform or a spline, "
			   "found '%s'",
			   word_text(body->word));
		return value_none();
	}
}

Value function_define(Context *context, const Node *body, Location where)
{
	struct FunctionScope *scope = context->functions;
	if (!scope)
		return value_none();
	/* What a block reads has nothing to do with the arguments. */
	context->functions = scope->outer;
	if (!body) {
		diag_error(context->diag, where, "the function is empty");
		return value_none();
	}
	return body->kind == NODE_BLOCK ? define_block(context, body, where) :
	       define_expression(context, body->value, scope->arity, where);
}

/* ---- calling ---- */

static Value apply_function(const Function *function, const Value *args, int count)
{
	double numbers[FUNCTION_MAX_ARGUMENTS];
	for (int i = 0; i < count; i++)
		numbers[i] = args[i].number;
	return value_float(function_eval(function, numbers));
}

static Value apply_vector(const VectorFunction *vector, const Value *args, int count)
{
	double numbers[FUNCTION_MAX_ARGUMENTS];
	Value result = {.kind = vector->color ? VALUE_COLOR : VALUE_VECTOR, .size = vector->size};
	for (int i = 0; i < count; i++)
		numbers[i] = args[i].number;
	vector->eval(vector->data, numbers, result.v);
	return result;
}

/* A spline called inside a function body becomes a vector function. */
static Value as_callee(Context *context, Value callee)
{
	if (callee.kind != VALUE_SPLINE)
		return callee;
	VectorFunction function = {1, callee.spline->size, false, eval_spline, callee.spline};
	return value_item(VALUE_VECTOR_FUNCTION,
			  arena_copy(context->builder->arena, &function, sizeof function));
}

static int callee_arity(Value callee)
{
	switch (callee.kind) {
	case VALUE_FUNCTION: return function_arity(callee.item);
	case VALUE_VECTOR_FUNCTION: return ((const VectorFunction *)callee.item)->arity;
	case VALUE_SPLINE: return 1;
	default: return -1;
	}
}

static Value apply_spline(const Spline *spline, double at)
{
	Value result = {.kind = VALUE_VECTOR, .size = spline->size};
	spline_eval(spline, at, result.v);
	return result;
}

Value expression_apply(Context *context, Value callee, const Value *args, int count, Location where)
{
	int arity = callee_arity(callee), trees = 0;
	if (arity < 0) {
		diag_error(context->diag, where, "%s cannot be called", value_describe(callee));
		return value_float(0);
	}
	if (arity != count) {
		diag_error(context->diag, where, "this function takes %d argument%s, not %d", arity,
			   arity == 1 ? "" : "s", count);
		return value_float(0);
	}
	for (int i = 0; i < count; i++) {
		trees += args[i].kind == VALUE_EXPRESSION;
		if (args[i].kind != VALUE_EXPRESSION && args[i].kind != VALUE_FLOAT) {
			diag_error(context->diag, where, "argument %d must be a float, found %s",
				   i + 1, value_describe(args[i]));
			return value_float(0);
		}
	}
	if (callee.kind == VALUE_FUNCTION && function_is_approximate(callee.item))
		diag_warning(context->diag, where, "this internal function is only approximated");
	if (trees) {
		bool vector = callee.kind != VALUE_FUNCTION;
		Expression root = {.kind = vector ? EXPRESSION_VECTOR : EXPRESSION_FUNCTION,
				   .callee = as_callee(context, callee)};
		return expression_tree(context, root, args, count, where);
	}
	if (callee.kind == VALUE_FUNCTION)
		return apply_function(callee.item, args, count);
	return callee.kind == VALUE_SPLINE ? apply_spline(callee.spline, args[0].number)
					   : apply_vector(callee.item, args, count);
}
