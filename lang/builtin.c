#include "lang/builtin.h"

#include <math.h>

#include "lang/expression_tree.h"

static const BuiltinRow rows[W_COUNT] = {
	[W_abs] = {"f", true, fabs, NULL, NULL},
	[W_acos] = {"f", true, NULL, NULL, builtin_acos},
	[W_acosh] = {"f", true, acosh, NULL, NULL},
	[W_asc] = {"s", false, NULL, NULL, builtin_asc},
	[W_asin] = {"f", true, NULL, NULL, builtin_asin},
	[W_asinh] = {"f", true, asinh, NULL, NULL},
	[W_atan] = {"f", true, atan, NULL, NULL},
	[W_atan2] = {"ff", true, NULL, NULL, builtin_atan2},
	[W_atanh] = {"f", true, atanh, NULL, NULL},
	[W_bitwise_and] = {"ff+", false, NULL, NULL, builtin_bitwise},
	[W_bitwise_or] = {"ff+", false, NULL, NULL, builtin_bitwise},
	[W_bitwise_xor] = {"ff+", false, NULL, NULL, builtin_bitwise},
	[W_ceil] = {"f", true, ceil, NULL, NULL},
	[W_chr] = {"f", false, NULL, NULL, builtin_chr},
	[W_concat] = {"s+", false, NULL, NULL, builtin_concat},
	[W_cos] = {"f", true, cos, NULL, NULL},
	[W_cosh] = {"f", true, cosh, NULL, NULL},
	[W_datetime] = {"fs?", false, NULL, NULL, builtin_datetime},
	[W_defined] = {"*", false, NULL, NULL, builtin_defined},
	[W_degrees] = {"f", true, builtin_degrees, NULL, NULL},
	[W_dimension_size] = {"af", false, NULL, NULL, builtin_dimension_size},
	[W_dimensions] = {"a", false, NULL, NULL, builtin_dimensions},
	[W_div] = {"ff", true, NULL, builtin_div, NULL},
	[W_exp] = {"f", true, exp, NULL, NULL},
	[W_file_exists] = {"s", false, NULL, NULL, builtin_file_exists},
	[W_floor] = {"f", true, floor, NULL, NULL},
	[W_inside] = {"ov", false, NULL, NULL, builtin_inside},
	[W_int] = {"f", true, builtin_int, NULL, NULL},
	[W_ln] = {"f", true, NULL, NULL, builtin_logarithm},
	[W_log] = {"f", true, NULL, NULL, builtin_logarithm},
	[W_max] = {"f+", true, NULL, NULL, builtin_extreme},
	[W_max_extent] = {"o", false, NULL, NULL, builtin_extent},
	[W_min] = {"f+", true, NULL, NULL, builtin_extreme},
	[W_min_extent] = {"o", false, NULL, NULL, builtin_extent},
	[W_mod] = {"ff", true, NULL, fmod, NULL},
	[W_pow] = {"ff", true, NULL, NULL, builtin_pow},
	[W_radians] = {"f", true, builtin_radians, NULL, NULL},
	[W_rand] = {"f", false, NULL, NULL, builtin_rand},
	[W_seed] = {"f", false, NULL, NULL, builtin_seed},
	[W_select] = {"ffff?", true, NULL, NULL, builtin_select},
	[W_sin] = {"f", true, sin, NULL, NULL},
	[W_sinh] = {"f", true, sinh, NULL, NULL},
	[W_sqr] = {"f", true, builtin_sqr, NULL, NULL},
	[W_sqrt] = {"f", true, NULL, NULL, builtin_sqrt},
	[W_str] = {"fff", false, NULL, NULL, builtin_str},
	[W_strcmp] = {"ss", false, NULL, NULL, builtin_strcmp},
	[W_strlen] = {"s", false, NULL, NULL, builtin_strlen},
	[W_strlwr] = {"s", false, NULL, NULL, builtin_case},
	[W_strupr] = {"s", false, NULL, NULL, builtin_case},
	[W_substr] = {"sff", false, NULL, NULL, builtin_substr},
	[W_tan] = {"f", true, tan, NULL, NULL},
	[W_tanh] = {"f", true, tanh, NULL, NULL},
	[W_trace] = {"ovv*?", false, NULL, NULL, builtin_trace},
	[W_val] = {"s", false, NULL, NULL, builtin_val},
	[W_vaxis_rotate] = {"vvf", false, NULL, NULL, builtin_vaxis_rotate},
	[W_vcross] = {"vv", false, NULL, NULL, builtin_vcross},
	[W_vdot] = {"vv", false, NULL, NULL, builtin_vdot},
	[W_vlength] = {"v", false, NULL, NULL, builtin_vlength},
	[W_vnormalize] = {"v", false, NULL, NULL, builtin_vnormalize},
	[W_vrotate] = {"vv", false, NULL, NULL, builtin_vrotate},
	[W_vstr] = {"fvsff", false, NULL, NULL, builtin_vstr},
	[W_vturbulence] = {"fffv", false, NULL, NULL, builtin_vturbulence},
};

static bool argument_fits(char letter, Value value)
{
	switch (letter) {
	case 'f': return value.kind == VALUE_FLOAT;
	case 'v': return value_is_numeric(value);
	case 's': return value.kind == VALUE_STRING;
	case 'o': return value.kind == VALUE_OBJECT;
	case 'a': return value.kind == VALUE_ARRAY;
	default: return true;
	}
}

static const char *argument_name(char letter)
{
	switch (letter) {
	case 'f': return "a float";
	case 'v': return "a vector";
	case 's': return "a string";
	case 'o': return "an object";
	case 'a': return "an array";
	default: return "something";
	}
}

static bool wrong_count(const BuiltinCall *call)
{
	diag_error(call->context->diag, call->where, "'%s' cannot take %d argument%s",
		   word_text(call->word), call->count, call->count == 1 ? "" : "s");
	return false;
}

/* Checks the arguments against the signature; *trees counts those that are trees where a float
 * should be. */
static bool arguments_fit(const BuiltinCall *call, const char *signature, int *trees)
{
	const char *letter = signature;
	for (int i = 0; i < call->count; i++) {
		if (!*letter)
			return wrong_count(call);
		if (call->args[i].kind == VALUE_EXPRESSION && *letter == 'f') {
			++*trees;
		} else if (!argument_fits(*letter, call->args[i])) {
			diag_error(call->context->diag, call->where,
				   "argument %d of '%s' must be %s, found %s", i + 1,
				   word_text(call->word), argument_name(*letter),
				   value_describe(call->args[i]));
			return false;
		}
		if (letter[1] == '?')
			letter += 2;
		else if (letter[1] != '+' || i + 1 == call->count)
			letter += letter[1] == '+' ? 2 : 1;
	}
	if (*letter && letter[1] != '?')
		return wrong_count(call);
	return true;
}

static Value call_tree(const BuiltinCall *call, const BuiltinRow *row)
{
	if (!row->in_function) {
		diag_error(call->context->diag, call->where, "'%s' cannot be used in a function",
			   word_text(call->word));
		return value_float(0);
	}
	Expression root = {.kind = EXPRESSION_CALL, .word = call->word};
	return expression_tree(call->context, root, call->args, call->count, call->where);
}

Value expression_call(Context *context, Word function, const Value *args, int count, Location where)
{
	const BuiltinRow *row = (unsigned)function < W_COUNT ? &rows[function] : &rows[0];
	BuiltinCall call = {context, function, args, count, where};
	int trees = 0;
	if (!row->signature) {
		diag_error(context->diag, where, "'%s' is not a function", word_text(function));
		return value_float(0);
	}
	if (!arguments_fit(&call, row->signature, &trees))
		return value_float(0);
	if (trees)
		return call_tree(&call, row);
	if (row->one)
		return value_float(row->one(args[0].number));
	if (row->two)
		return value_float(row->two(args[0].number, args[1].number));
	return row->run(&call);
}
