/* Operators, built-in functions, arrays and splines against what POV-Ray 3.7 prints. */
#include "lang/expression.h"

#include "check.h"
#include "lang/array.h"
#include "lang/function.h"
#include "lang/spline.h"

static Context context;
static SceneBuilder builder;
static const Location nowhere;

static Value number(double x) { return value_float(x); }

static Value call(Word word, int count, ...)
{
	Value args[6];
	va_list list;
	va_start(list, count);
	for (int i = 0; i < count; i++)
		args[i] = va_arg(list, Value);
	va_end(list);
	return expression_call(&context, word, args, count, nowhere);
}

static Value vector(double x, double y, double z)
{
	return value_vec3(vec3(x, y, z));
}

static void check_vector(Value v, double x, double y, double z)
{
	CHECK(v.kind == VALUE_VECTOR || v.kind == VALUE_COLOR);
	CHECK_NEAR(v.v[0], x, 1e-9);
	CHECK_NEAR(v.v[1], y, 1e-9);
	CHECK_NEAR(v.v[2], z, 1e-9);
}

static double binary(Operator op, double a, double b)
{
	return expression_binary(&context, op, number(a), number(b), nowhere).number;
}

static void test_operators(void)
{
	CHECK_NEAR(binary(OP_EQUAL, 1, 1.00000000001), 1, 0);
	CHECK_NEAR(binary(OP_EQUAL, 1, 1.000000001), 0, 0);
	CHECK_NEAR(binary(OP_LESS, 0, 1e-11), 1, 0);
	CHECK_NEAR(binary(OP_LESS_EQUAL, 1, 0.99999999999), 1, 0);
	CHECK_NEAR(binary(OP_AND, 1e-11, 1), 0, 0);
	CHECK_NEAR(expression_unary(&context, OP_NOT, number(1e-11), nowhere).number, 1, 0);
	check_vector(expression_binary(&context, OP_ADD, vector(1, 2, 3), number(1), nowhere), 2, 3,
		     4);
	Value pair = {.kind = VALUE_VECTOR, .size = 2, .v = {2, 3}};
	check_vector(expression_binary(&context, OP_MUL, pair, vector(1, 2, 3), nowhere), 2, 6, 0);
	Value text[2] = {value_string("a"), value_string("b")};
	CHECK_NEAR(expression_binary(&context, OP_LESS, text[0], text[1], nowhere).number, 1, 0);
	CHECK(isinf(binary(OP_DIV, 1, 0)));
	CHECK(diag_errors(context.diag) == 0);
	expression_binary(&context, OP_ADD, text[0], number(1), nowhere);
	CHECK(diag_errors(context.diag) == 1);
}

static void test_colors(void)
{
	Value parts[4] = {number(0.5), number(0.2), number(0.3), number(0.4)};
	Value four = expression_vector(&context, parts, 4, nowhere);
	Value c = expression_color(&context, W_rgbt, four, nowhere);
	CHECK(c.kind == VALUE_COLOR && c.v[3] == 0 && c.v[4] == 0.4);
	c = expression_color(&context, W_srgb, vector(0.5, 0.2, 0.03), nowhere);
	CHECK_NEAR(c.v[0], 0.214041, 1e-6);
	CHECK_NEAR(c.v[1], 0.033105, 1e-6);
	builder.settings.assumed_gamma = 2.2; /* POV-Ray's own values */
	c = expression_color(&context, W_srgb, vector(0.3, 0.5, 0.6), nowhere);
	CHECK_NEAR(c.v[0], 0.304771, 1e-6);
	CHECK_NEAR(c.v[2], 0.594524, 1e-6);
	builder.settings.assumed_gamma = -1;
	CHECK(expression_color(&context, W_srgb, vector(0.3, 0.5, 0.6), nowhere).v[1] == 0.5);
	builder.settings.assumed_gamma = 0;
	c = expression_color(&context, W_rgb, number(0.5), nowhere);
	CHECK(c.v[2] == 0.5 && c.v[3] == 0 && c.v[4] == 0);
	CHECK_NEAR(expression_member(&context, vector(1, 2, 3), "gray", nowhere).number, 1.817,
		   1e-12);
	c = expression_color_part(&context, c, W_filter, number(0.7), nowhere);
	CHECK(c.v[3] == 0.7 && c.v[0] == 0.5);
}

static void test_random(void)
{
	Value stream = call(W_seed, 1, number(42));
	CHECK_NEAR(call(W_rand, 1, stream).number, 0.723582911241, 1e-12);
	CHECK_NEAR(call(W_rand, 1, stream).number, 0.329979259598, 1e-12);
	Value second = call(W_seed, 1, number(-7.6));
	CHECK_NEAR(call(W_rand, 1, second).number, 0.046072868175, 1e-12);
	CHECK_NEAR(call(W_rand, 1, stream).number, 0.755761670357, 1e-12);
}

static void test_functions(void)
{
	CHECK_NEAR(call(W_mod, 2, number(-5), number(3)).number, -2, 0);
	CHECK_NEAR(call(W_div, 2, number(-7), number(2)).number, -3, 0);
	CHECK_NEAR(call(W_int, 1, number(-1e12)).number, -2147483648.0, 0);
	CHECK_NEAR(call(W_select, 3, number(0), number(1), number(2)).number, 2, 0);
	CHECK_NEAR(call(W_select, 4, number(1e-11), number(1), number(2), number(3)).number, 3, 0);
	CHECK_NEAR(call(W_max, 3, number(3), number(1), number(2)).number, 3, 0);
	CHECK_NEAR(call(W_bitwise_xor, 3, number(12), number(10), number(3)).number, 5, 0);
	check_vector(call(W_vrotate, 2, vector(1, 2, 3), vector(30, 40, 50)), 1.801281062,
		     2.507690147, 2.113498678);
	Value turned = call(W_vaxis_rotate, 3, vector(1, 2, 3), vector(1, 1, 0), number(30));
	check_vector(turned, 2.127647470, 0.872352530, 2.951629602);
	Value t = call(W_vturbulence, 4, number(2), number(0.5), number(6), vector(0.3, 1.7, 2.9));
	CHECK_NEAR(t.v[0], 0.516474415, 1e-6);
	CHECK_NEAR(t.v[1], -0.197254043, 1e-6);
	int before = diag_errors(context.diag);
	call(W_sqrt, 1, number(-1));
	call(W_sin, 1, value_string("a"));
	call(W_sin, 2, number(1), number(1));
	call(W_ln, 1, number(0));
	CHECK(diag_errors(context.diag) == before + 4);
}

static void test_strings(void)
{
	CHECK_STRING(call(W_str, 3, number(1.5), number(-8), number(2)).string, "00001.50");
	CHECK_STRING(call(W_str, 3, number(-2.5), number(-8), number(0)).string, "-0000002");
	CHECK_STRING(call(W_str, 3, number(1.5), number(0), number(-1)).string, "1.500000");
	Value v = call(W_vstr, 5, number(2), vector(1, 2, 3), value_string(" "), number(6),
		       number(1));
	CHECK_STRING(v.string, "   1.0    2.0");
	CHECK_STRING(call(W_substr, 3, value_string("ABCDEFGHI"), number(4), number(2)).string,
		     "DE");
	CHECK_STRING(
		call(W_concat, 3, value_string("a"), value_string(""), value_string("bc")).string,
		"abc");
	CHECK_STRING(call(W_chr, 1, number(8364)).string, "\xe2\x82\xac");
	CHECK_NEAR(call(W_asc, 1, value_string("\xe2\x82\xac")).number, 8364, 0);
	CHECK_NEAR(call(W_strlen, 1, value_string("a\xc3\xa9")).number, 2, 0);
	CHECK_NEAR(call(W_strcmp, 2, value_string("aa"), value_string("ab")).number, -1, 0);
	CHECK_NEAR(call(W_val, 1, value_string("12abc")).number, 12, 0);
	CHECK_STRING(call(W_datetime, 1, number(0)).string, "2000-01-01 00:00:00Z");
	int before = diag_errors(context.diag);
	call(W_substr, 3, value_string("abc"), number(3), number(2));
	CHECK(diag_errors(context.diag) == before + 1);
}

static void test_arrays(void)
{
	Array *array = array_create(&context, (const double[]){2, 3}, 2, nowhere);
	Value *element = array_element(&context, array, (const double[]){1, 2.9}, 2, nowhere);
	CHECK(element == &array->elements[5]);
	CHECK(array_set(&context, array, element, number(7), nowhere));
	CHECK(array_copy(context.parse, array)->elements[5].number == 7);
	int before = diag_errors(context.diag);
	CHECK(!array_set(&context, array, element, value_string("x"), nowhere));
	CHECK(!array_element(&context, array, (const double[]){2, 0}, 2, nowhere));
	CHECK(!array_element(&context, array, (const double[]){-1, 0}, 2, nowhere));
	CHECK(!array_element(&context, array, (const double[]){1}, 1, nowhere));
	CHECK(!array_create(&context, (const double[]){0}, 1, nowhere));
	CHECK(diag_errors(context.diag) == before + 5);
}

static const double spline_points[6][3] = {{0, 1, 2}, {1, 3, -1}, {1.5, 2, 2},
					   {3, 0, 1}, {4, 1, 1},  {5.5, -2, 0}};

static const Spline *make_spline(Word kind)
{
	Node *nodes = ARENA_ARRAY(context.parse, Node, 13);
	nodes[0] = (Node){.kind = NODE_WORD, .word = kind, .next = &nodes[1]};
	for (int i = 0; i < 6; i++) {
		Value point = {.kind = VALUE_VECTOR,
			       .size = 2,
			       .v = {spline_points[i][1], spline_points[i][2]}};
		nodes[1 + 2 * i] = (Node){.kind = NODE_VALUE,
					  .value = number(spline_points[i][0]),
					  .next = &nodes[2 + 2 * i]};
		nodes[2 + 2 * i] = (Node){.kind = NODE_VALUE,
					  .value = point,
					  .next = i < 5 ? &nodes[3 + 2 * i] : NULL};
	}
	Node block = {.kind = NODE_BLOCK, .word = W_spline, .children = nodes};
	return spline_build(&context, &block).spline;
}

static void check_spline(Word kind, double at, double x, double y)
{
	double out[5];
	spline_eval(make_spline(kind), at, out);
	CHECK_NEAR(out[0], x, 1e-9);
	CHECK_NEAR(out[1], y, 1e-9);
}

static void test_splines(void)
{
	check_spline(W_linear_spline, 2.25, 1, 1.5);
	check_spline(W_linear_spline, 9, -2, 0);
	check_spline(W_quadratic_spline, 0.25, 2, 0.125);
	check_spline(W_quadratic_spline, 2, 1.166666666667, 3.333333333333);
	check_spline(W_cubic_spline, 0.5, 3, -1);
	check_spline(W_cubic_spline, 1.25, 2.604166666667, 0.427083333333);
	check_spline(W_cubic_spline, 5, 1, 1);
	check_spline(W_natural_spline, 0.25, 1.817220543807, 0.451520015106);
	check_spline(W_natural_spline, 5.25, -1.239443465369, 0.283054296744);
}

/* function(x) { select(x, sin(x), 2) + sum(i, 1, 4.5, i*i*x) } */
static void test_user_function(void)
{
	const char *const names[1] = {"x"};
	function_open(&context, names, 1);
	CHECK(function_argument(&context, "u", 1) == 0 &&
	      function_argument(&context, "y", 1) == -1);
	Value x = expression_constant(&context, W_x, nowhere);
	CHECK(x.kind == VALUE_EXPRESSION);
	Value choice = call(W_select, 3, x, call(W_sin, 1, x), number(2));
	function_loop_open(&context, "i", nowhere);
	Value i = function_argument_value(&context, function_argument(&context, "i", 1));
	Value square = expression_binary(&context, OP_MUL, i, i, nowhere);
	Value range[2] = {number(1), number(4.5)};
	Value body = expression_binary(&context, OP_MUL, square, x, nowhere);
	Value total = function_loop_close(&context, W_sum, range, body, nowhere);
	Node node = {.kind = NODE_VALUE,
		     .value = expression_binary(&context, OP_ADD, choice, total, nowhere)};
	Value function = function_define(&context, &node, nowhere);
	CHECK(function.kind == VALUE_FUNCTION && context.functions == NULL);
	Value at[2] = {number(-0.5), number(2)};
	CHECK_NEAR(expression_apply(&context, function, &at[0], 1, nowhere).number, sin(-0.5) - 15,
		   1e-12);
	CHECK_NEAR(expression_apply(&context, function, &at[1], 1, nowhere).number, 62, 1e-12);
	int before = diag_errors(context.diag);
	expression_apply(&context, function, at, 2, nowhere);
	CHECK(diag_errors(context.diag) == before + 1);
}

int main(void)
{
	context.diag = diag_create(NULL);
	context.parse = context.items = arena_create();
	builder.arena = arena_create();
	builder.settings.noise_generator = 2;
	context.builder = &builder;
	test_operators();
	test_colors();
	test_random();
	test_functions();
	test_strings();
	test_arrays();
	test_splines();
	test_user_function();
	arena_destroy(context.parse);
	arena_destroy(builder.arena);
	diag_destroy(context.diag);
	return CHECK_RESULT();
}
