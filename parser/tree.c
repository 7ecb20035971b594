/* What the grammar's actions call: nodes, and the values of items. */
#include "lang/array.h"
#include "lang/build.h"
#include "lang/function.h"
#include "lang/spline.h"
#include "parser/state.h"

Node *tree_value(Reader *reader, NodeKind kind, Value value, Location where)
{
	Node *node = arena_alloc(reader->context.items, sizeof *node);
	node->kind = kind == NODE_VALUE && !value_is_numeric(value) && value.kind != VALUE_STRING &&
	             value.kind != VALUE_EXPRESSION ? NODE_ITEM : kind;
	node->value = value;
	node->where = where;
	return node;
}

/* A vector literal of any length; more than five components only a matrix and polynomials have. */
Value tree_vector(Reader *reader, ValueRun components, Location where)
{
	const Value *values = reader->values + components.start;
	reader->value_count = components.start;
	if (components.count <= 5)
		return expression_vector(&reader->context, values, components.count, where);
	double *numbers = ARENA_ARRAY(reader->context.items, double, components.count);
	for (int i = 0; i < components.count; i++) {
		if (!value_is_numeric(values[i])) {
			diag_error(reader->context.diag, where,
				   "component %d must be a float, found %s", i + 1,
				   value_describe(values[i]));
			return value_float(0);
		}
		numbers[i] = value_to_float(values[i]);
	}
	return (Value){.kind = VALUE_NONE, .size = components.count, .item = numbers};
}

Node *tree_expression(Reader *reader, Value value, Location where)
{
	if (value.kind != VALUE_NONE || value.size <= 5)
		return tree_value(reader, NODE_VALUE, value, where);
	const double *numbers = value.item;
	NodeList list = {0};
	for (int done = 0; done < value.size; done += 5) {
		int count = value.size - done < 5 ? value.size - done : 5;
		Value part = {.kind = count > 1 ? VALUE_VECTOR : VALUE_FLOAT, .size = count};
		for (int i = 0; i < count; i++)
			part.v[i] = numbers[done + i];
		list = tree_append(list, tree_value(reader, NODE_VALUE, part, where));
	}
	return list.first;
}

Node *tree_word(Reader *reader, NodeKind kind, Word word, Node *children, Location where)
{
	Node *node = arena_alloc(reader->context.items, sizeof *node);
	node->kind = kind;
	node->word = word;
	node->children = children;
	node->where = where;
	return node;
}

NodeList tree_append(NodeList list, Node *node)
{
	if (list.last)
		list.last->next = node;
	else
		list.first = node;
	for (list.last = node; list.last->next; list.last = list.last->next)
		;
	return list;
}

void tree_push(Reader *reader, Value value)
{
	if (reader->value_count == reader->value_capacity) {
		reader->value_capacity = reader->value_capacity ? 2 * reader->value_capacity : 256;
		reader->values = memory_resize(reader->values,
					       (size_t)reader->value_capacity * sizeof(Value));
	}
	reader->values[reader->value_count++] = value;
}

/* Nothing is built from what had a mistake, and a mistake while building spoils what it is part of.
 */
static Value spoil(Reader *reader, Value value)
{
	if (value.kind == VALUE_NONE)
		reader->frame->failed = true;
	return value;
}

Value tree_build(Reader *reader, Node *nodes)
{
	if (reader->frame->failed)
		return value_none();
	if (nodes->kind == NODE_BLOCK && nodes->word == W_spline)
		return spoil(reader, spline_build(&reader->context, nodes));
	return spoil(reader, build_value(&reader->context, nodes));
}

Value tree_function(Reader *reader, Node *body, Location where)
{
	Context *context = &reader->context;
	Node nothing = {.kind = NODE_VALUE, .value = value_float(0), .where = where};
	bool is_block = body && body->kind == NODE_BLOCK;
	if (is_block && reader->frame->failed)
		return value_none();
	if (is_block)
		function_open(context, NULL, 0);
	else
		reader->function_depth--;
	return spoil(reader, function_define(context, body ? body : &nothing, where));
}

/* Sets elements from offset on; length is how many one entry of this dimension spans. */
static void fill_array(Reader *reader, Array *array, int dimension, long offset,
		       const Node *elements)
{
	long length = 1, index = 0;
	for (int i = dimension + 1; i < array->dimensions; i++)
		length *= array->size[i];
	for (; elements; elements = elements->next, index++) {
		long at = offset + index * length;
		bool nested = elements->kind == NODE_ENTRY;
		if (index >= array->size[dimension]) {
			diag_error(reader->context.diag, elements->where,
				   "more values than the array has elements (%d)",
				   array->size[dimension]);
			return;
		}
		if (nested != (dimension + 1 < array->dimensions)) {
			diag_error(reader->context.diag, elements->where,
				   nested ? "the array has fewer dimensions"
					  : "expected '{' for the next dimension");
			return;
		}
		if (nested)
			fill_array(reader, array, dimension + 1, at, elements->children);
		else if (elements->value.kind != VALUE_NONE)
			array_set(&reader->context, array, &array->elements[at], elements->value,
				  elements->where);
	}
}

Value tree_array(Reader *reader, ValueRun sizes, const Node *elements, Location where)
{
	double size[ARRAY_MAX_DIMENSIONS + 1];
	reader->value_count = sizes.start;
	if (sizes.count > ARRAY_MAX_DIMENSIONS) {
		diag_error(reader->context.diag, where, "an array has at most %d dimensions",
			   (int)ARRAY_MAX_DIMENSIONS);
		return spoil(reader, value_none());
	}
	for (int i = 0; i < sizes.count; i++)
		size[i] = value_to_float(reader->values[sizes.start + i]);
	Array *array = array_create(&reader->context, size, sizes.count, where);
	if (!array)
		return spoil(reader, value_none());
	fill_array(reader, array, 0, 0, elements);
	return (Value){.kind = VALUE_ARRAY, .array = array};
}

Value tree_trace(Reader *reader, ValueRun arguments, Location where)
{
	Value normal, *values = reader->values + arguments.start;
	reader->value_count = arguments.start;
	if (arguments.count != 3 && arguments.count != 4) {
		diag_error(reader->context.diag, where,
			   "trace takes an object, a point, a direction and a variable");
		return value_float(0);
	}
	Value *target = arguments.count == 4 ? reader->target : NULL;
	Value point = expression_trace(&reader->context, values, &normal, where);
	if (target)
		*target = normal;
	return point;
}
