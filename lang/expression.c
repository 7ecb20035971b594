#include "lang/expression.h"

#include <string.h>
#include <time.h>

#include "lang/expression_tree.h"
#include "lang/function.h"

/* How near two numbers are that the language calls equal. */
#define EQUAL_TOLERANCE 1e-10

static bool nearly_equal(double a, double b)
{
	return fabs(a - b) <= EQUAL_TOLERANCE || a == b;
}

static double apply_binary(Operator op, double a, double b)
{
	switch (op) {
	case OP_ADD: return a + b;
	case OP_SUB: return a - b;
	case OP_MUL: return a * b;
	case OP_DIV: return a / b;
	case OP_LESS: return a < b;
	case OP_LESS_EQUAL: return a < b || nearly_equal(a, b);
	case OP_EQUAL: return nearly_equal(a, b);
	case OP_NOT_EQUAL: return !nearly_equal(a, b);
	case OP_GREATER_EQUAL: return a > b || nearly_equal(a, b);
	case OP_GREATER: return a > b;
	case OP_AND: return expression_is_true(a) && expression_is_true(b);
	case OP_OR: return expression_is_true(a) || expression_is_true(b);
	default: return 0;
	}
}

static double apply_unary(Operator op, double a)
{
	return op == OP_NEG ? -a : op == OP_NOT ? !expression_is_true(a) : a;
}

static double component(const Value *value, int i)
{
	return value->kind == VALUE_FLOAT ? value->number : value->v[i];
}

static bool is_numeric_or_tree(Value a)
{
	return value_is_numeric(a) || a.kind == VALUE_EXPRESSION;
}

static Value report_operand(Context *context, Value bad, Location where)
{
	diag_error(context->diag, where, "expected a number, a vector or a colour, found %s",
		   value_describe(bad));
	return value_float(0);
}

Value expression_unary(Context *context, Operator op, Value a, Location where)
{
	if (a.kind == VALUE_FLOAT)
		return value_float(apply_unary(op, a.number));
	if (a.kind == VALUE_EXPRESSION)
		return op == OP_PLUS
			       ? a
			       : expression_tree(context,
						 (Expression){.kind = EXPRESSION_UNARY, .op = op},
						 &a, 1, where);
	if (!value_is_numeric(a))
		return report_operand(context, a, where);
	for (int i = 0; i < a.size; i++)
		a.v[i] = apply_unary(op, a.v[i]);
	return a;
}

static Value compare_strings(Context *context, Operator op, const Value operands[2], Location where)
{
	if (operands[0].kind != VALUE_STRING || operands[1].kind != VALUE_STRING)
		return report_operand(context, operands[operands[0].kind == VALUE_STRING ? 0 : 1],
				      where);
	if (op < OP_LESS || op > OP_GREATER) {
		diag_error(context->diag, where, "strings can only be compared");
		return value_float(0);
	}
	return value_float(apply_binary(op, strcmp(operands[0].string, operands[1].string), 0));
}

static void warn_division(Context *context, const Value *by, int size, Location where)
{
	for (int i = 0; i < size; i++)
		if (component(by, i) == 0) {
			diag_warning(context->diag, where, "division by zero");
			return;
		}
}

/* Vectors and colours, component by component; a float stands for equal components, what a shorter
 * vector lacks is 0. */
static Value binary_vectors(Context *context, Operator op, const Value *a, const Value *b,
			    Location where)
{
	int size = a->size > b->size ? a->size : b->size;
	bool color = a->kind == VALUE_COLOR || b->kind == VALUE_COLOR;
	Value result = {.kind = color ? VALUE_COLOR : VALUE_VECTOR, .size = size};
	if (op == OP_DIV)
		warn_division(context, b, b->size < size ? b->size : size, where);
	for (int i = 0; i < size; i++) {
		double divisor = component(b, i);
		bool missing = op == OP_DIV && b->kind != VALUE_FLOAT && i >= b->size;
		result.v[i] = missing ? 0 : apply_binary(op, component(a, i), divisor);
	}
	return result;
}

Value expression_binary(Context *context, Operator op, Value a, Value b, Location where)
{
	if (a.kind == VALUE_FLOAT && b.kind == VALUE_FLOAT) {
		if (op == OP_DIV && b.number == 0)
			diag_warning(context->diag, where, "division by zero");
		return value_float(apply_binary(op, a.number, b.number));
	}
	Value operands[2] = {a, b};
	if (a.kind == VALUE_STRING || b.kind == VALUE_STRING)
		return compare_strings(context, op, operands, where);
	if (!is_numeric_or_tree(a) || !is_numeric_or_tree(b))
		return report_operand(context, is_numeric_or_tree(a) ? b : a, where);
	if (a.kind == VALUE_EXPRESSION || b.kind == VALUE_EXPRESSION)
		return expression_tree(context, (Expression){.kind = EXPRESSION_BINARY, .op = op},
				       operands, 2, where);
	return binary_vectors(context, op, &a, &b, where);
}

Value expression_conditional(Context *context, Value test, Value yes, Value no, Location where)
{
	if (test.kind == VALUE_EXPRESSION) {
		Value parts[3] = {test, yes, no};
		return expression_tree(context, (Expression){.kind = EXPRESSION_CONDITIONAL}, parts,
				       3, where);
	}
	if (!value_is_numeric(test))
		return report_operand(context, test, where);
	return expression_is_true(value_to_float(test)) ? yes : no;
}

Value expression_vector(Context *context, const Value *parts, int count, Location where)
{
	Value result = {.kind = VALUE_VECTOR, .size = count};
	if (count < 2 || count > 5) {
		diag_error(context->diag, where, "a vector has 2 to 5 components, not %d", count);
		return value_vec3(vec3_all(0));
	}
	for (int i = 0; i < count; i++) {
		if (parts[i].kind != VALUE_FLOAT) {
			diag_error(context->diag, where,
				   "component %d of a vector must be a float, found %s", i + 1,
				   value_describe(parts[i]));
			return value_vec3(vec3_all(0));
		}
		result.v[i] = parts[i].number;
	}
	return result;
}

static const struct MemberRow {
	const char *name;
	int index;
} member_rows[] = {
	{"x", 0},        {"y", 1},    {"z", 2},     {"t", 3},    {"u", 0},
	{"v", 1},        {"red", 0},  {"green", 1}, {"blue", 2}, {"filter", 3},
	{"transmit", 4}, {"gray", 5}, {"grey", 5},
};

/* 0 to 4, 5 for the grey value, -1 when there is no such member. */
static int member_index(const char *name)
{
	for (size_t i = 0; i < sizeof member_rows / sizeof member_rows[0]; i++)
		if (strcmp(member_rows[i].name, name) == 0)
			return member_rows[i].index;
	return -1;
}

Value expression_member(Context *context, Value of, const char *member, Location where)
{
	int index = member_index(member);
	if (index < 0) {
		diag_error(context->diag, where,
			   "no member '%s': expected x, y, z, t, u, v, red, green, blue, filter, "
			   "transmit or gray",
			   member);
		return value_float(0);
	}
	if (of.kind == VALUE_EXPRESSION && of.expression->kind == EXPRESSION_VECTOR)
		return expression_tree(context,
				       (Expression){.kind = EXPRESSION_COMPONENT, .number = index},
				       &of, 1, where);
	if (of.kind != VALUE_VECTOR && of.kind != VALUE_COLOR) {
		diag_error(context->diag, where, "%s has no member '%s'", value_describe(of),
			   member);
		return value_float(0);
	}
	if (index == 5)
		return value_float(0.297 * of.v[0] + 0.589 * of.v[1] + 0.114 * of.v[2]);
	if (index >= of.size) {
		diag_error(context->diag, where, "%s has no member '%s'", value_describe(of),
			   member);
		return value_float(0);
	}
	return value_float(of.v[index]);
}

/* The transfer function of IEC 61966-2-1, from the encoded to the linear value. */
static double srgb_to_linear(double c)
{
	return c <= 0.04045 ? c / 12.92 : pow((c + 0.055) / 1.055, 2.4);
}

/* An sRGB-coded component in the scene's own colours: coded by assumed_gamma, linear when it is 1
 * or not given. */
static double srgb_to_scene(const Context *context, double c)
{
	double gamma = context->builder->settings.assumed_gamma;
	if (gamma < 0)
		return c;
	double linear = srgb_to_linear(c);
	return gamma == 0 || gamma == 1 || linear <= 0 ? linear : pow(linear, 1 / gamma);
}

/* How many components a colour keyword reads, whether the fourth of four is transmit, and whether
 * they are sRGB-coded. */
typedef struct ColorForm {
	int size;
	bool transmit_fourth, srgb;
} ColorForm;

static ColorForm color_form(Word keyword)
{
	switch (keyword) {
	case W_rgb: return (ColorForm){3, false, false};
	case W_rgbf: return (ColorForm){4, false, false};
	case W_rgbt: return (ColorForm){4, true, false};
	case W_srgb: return (ColorForm){3, false, true};
	case W_srgbf: return (ColorForm){4, false, true};
	case W_srgbt: return (ColorForm){4, true, true};
	case W_srgbft: return (ColorForm){5, false, true};
	default: return (ColorForm){5, false, false};
	}
}

Value expression_color(Context *context, Word keyword, Value of, Location where)
{
	Value result = {.kind = VALUE_COLOR, .size = 5};
	ColorForm form = color_form(keyword);
	if (!value_is_numeric(of)) {
		report_operand(context, of, where);
		return result;
	}
	bool named = keyword == W_color || keyword == W_colour;
	if (of.size > form.size && !named && of.kind != VALUE_COLOR)
		diag_warning(context->diag, where, "'%s' takes %d components, not %d",
			     word_text(keyword), form.size, of.size);
	int size = of.kind == VALUE_FLOAT                ? form.size
		   : form.transmit_fourth && of.size > 4 ? 4
							 : of.size;
	for (int i = 0; i < size; i++)
		result.v[i] = component(&of, i);
	if (form.transmit_fourth) {
		result.v[4] = result.v[3];
		result.v[3] = 0;
	}
	for (int i = 0; form.srgb && i < 3; i++)
		result.v[i] = srgb_to_scene(context, result.v[i]);
	return result;
}

Value expression_color_part(Context *context, Value color, Word part, Value of, Location where)
{
	int index = member_index(word_text(part));
	if (!value_is_numeric(color))
		color = value_float(0);
	if (color.kind != VALUE_COLOR)
		/* `rgb 0.5 transmit 0.2` comes as rgb of this: the float spreads over red, green
		 * and blue alone. */
		color = expression_color(context, color.kind == VALUE_FLOAT ? W_rgb : W_color,
					 color, where);
	if (of.kind != VALUE_FLOAT || index < 0 || index > 4) {
		diag_error(context->diag, where, "expected a float after '%s', found %s",
			   word_text(part), value_describe(of));
		return color;
	}
	color.v[index] = of.number;
	return color;
}

/* The axis words; 0 when word is none of them. */
static Value axis_constant(Word word)
{
	switch (word) {
	case W_x: return value_vec3(vec3(1, 0, 0));
	case W_y: return value_vec3(vec3(0, 1, 0));
	case W_z: return value_vec3(vec3(0, 0, 1));
	case W_t: return (Value){.kind = VALUE_VECTOR, .size = 4, .v = {0, 0, 0, 1}};
	case W_u: return (Value){.kind = VALUE_VECTOR, .size = 2, .v = {1, 0}};
	case W_v: return (Value){.kind = VALUE_VECTOR, .size = 2, .v = {0, 1}};
	default: return value_none();
	}
}

/* Days since the year 2000 began, UTC. */
static double days_now(void)
{
	return ((double)time(NULL) - 946684800.0) / 86400.0;
}

Value expression_constant(Context *context, Word word, Location where)
{
	int argument = context->functions ? function_argument(context, word_text(word),
							      strlen(word_text(word)))
					  : -1;
	if (argument >= 0)
		return function_argument_value(context, argument);
	switch (word) {
	case W_pi: return value_float(M_PI);
	case W_yes: case W_on: case W_true: return value_float(1);
	case W_no: case W_off: case W_false: return value_float(0);
	case W_clock: return value_float(context->clock);
	case W_clock_delta: return value_float(context->clock_delta);
	case W_clock_on: return value_float(context->clock_on);
	case W_initial_clock: return value_float(context->initial_clock);
	case W_final_clock: return value_float(context->final_clock);
	case W_frame_number: return value_float(context->frame_number);
	case W_initial_frame: return value_float(context->initial_frame);
	case W_final_frame: return value_float(context->final_frame);
	case W_image_width: return value_float(context->image_width);
	case W_image_height: return value_float(context->image_height);
	case W_version: return value_float(context->version > 0 ? context->version : 3.7);
	case W_now: return value_float(days_now());
	case W_input_file_name:
		return value_string(context->input_file_name ? context->input_file_name : "");
	default: break;
	}
	Value axis = axis_constant(word);
	if (axis.kind != VALUE_NONE)
		return axis;
	diag_error(context->diag, where, "'%s' is not a value", word_text(word));
	return value_float(0);
}

const Expression *expression_of(Arena *arena, Value value)
{
	if (value.kind == VALUE_EXPRESSION)
		return value.expression;
	Expression *constant = ARENA_NEW(arena, Expression);
	*constant = (Expression){.kind = EXPRESSION_CONSTANT, .constant = value_to_float(value)};
	return constant;
}

Value expression_tree(Context *context, Expression root, const Value *parts, int count,
		      Location where)
{
	const Expression **list = ARENA_ARRAY(context->parse, const Expression *, count);
	for (int i = 0; i < count; i++) {
		bool vector = parts[i].kind == VALUE_EXPRESSION &&
			      parts[i].expression->kind == EXPRESSION_VECTOR;
		bool fits = parts[i].kind == VALUE_FLOAT ||
			    (parts[i].kind == VALUE_EXPRESSION &&
			     vector == (root.kind == EXPRESSION_COMPONENT));
		if (!fits) {
			diag_error(context->diag, where,
				   "a function computes with floats, found %s",
				   vector ? "a vector function without a member"
					  : value_describe(parts[i]));
			return value_float(0);
		}
		list[i] = expression_of(context->parse, parts[i]);
	}
	Expression *tree = arena_copy(context->parse, &root, sizeof root);
	tree->parts = list;
	tree->part_count = count;
	return (Value){.kind = VALUE_EXPRESSION, .expression = tree};
}
