#include "lang/array.h"

/* More elements than this are a mistake, or a scene that would not fit into memory. */
#define MAX_LENGTH 100000000L

Array *array_create(Context *context, const double *sizes, int dimensions, Location where)
{
	if (dimensions < 1 || dimensions > ARRAY_MAX_DIMENSIONS) {
		diag_error(context->diag, where, "an array has 1 to %d dimensions, not %d",
			   ARRAY_MAX_DIMENSIONS, dimensions);
		return NULL;
	}
	Array *array = ARENA_NEW(context->parse, Array);
	array->dimensions = dimensions;
	array->length = 1;
	for (int i = 0; i < dimensions; i++) {
		if (!(sizes[i] >= 1) || !(sizes[i] * (double)array->length <= MAX_LENGTH)) {
			diag_error(context->diag, where, "an array cannot have size %g", sizes[i]);
			return NULL;
		}
		array->size[i] = (int)sizes[i];
		array->length *= array->size[i];
	}
	array->elements = ARENA_ARRAY(context->parse, Value, array->length);
	return array;
}

Array *array_copy(Arena *arena, const Array *array)
{
	Array *copy = arena_copy(arena, array, sizeof *array);
	copy->elements = arena_copy(arena, array->elements,
				    sizeof *array->elements * (size_t)array->length);
	for (long i = 0; i < copy->length; i++)
		if (copy->elements[i].kind == VALUE_ARRAY)
			copy->elements[i].array = array_copy(arena, copy->elements[i].array);
	return copy;
}

/* The place of as many subscripts as the array has dimensions; -1 after a reported error. */
static long element_index(Context *context, const Array *array, const double *subscripts,
			  Location where)
{
	long index = 0;
	for (int i = 0; i < array->dimensions; i++) {
		if (!(subscripts[i] > -1 && subscripts[i] < array->size[i])) {
			diag_error(context->diag, where,
				   "array subscript %g is out of range: dimension %d goes from "
				   "0 to %d",
				   subscripts[i], i + 1, array->size[i] - 1);
			return -1;
		}
		index = index * array->size[i] + (long)subscripts[i];
	}
	return index;
}

Value *array_element(Context *context, Array *array, const double *subscripts, int count,
		     Location where)
{
	for (;;) {
		if (count < array->dimensions) {
			diag_error(context->diag, where, "this array needs %d subscripts, not %d",
				   array->dimensions, count);
			return NULL;
		}
		long index = element_index(context, array, subscripts, where);
		if (index < 0)
			return NULL;
		Value *element = &array->elements[index];
		subscripts += array->dimensions;
		count -= array->dimensions;
		if (count == 0)
			return element;
		if (element->kind != VALUE_ARRAY) {
			diag_error(context->diag, where, "too many subscripts: the element is %s",
				   value_describe(*element));
			return NULL;
		}
		array = element->array;
	}
}

static bool kinds_mix(ValueKind a, ValueKind b)
{
	return a == b ||
	       (value_is_numeric((Value){.kind = a}) && value_is_numeric((Value){.kind = b}));
}

bool array_set(Context *context, Array *array, Value *element, Value value, Location where)
{
	if (value.kind == VALUE_NONE)
		return false;
	if (array->kind != VALUE_NONE && !kinds_mix(array->kind, value.kind)) {
		diag_error(context->diag, where, "the array holds %s, not %s",
		           value_describe((Value){.kind = array->kind}), value_describe(value));
		return false;
	}
	array->kind = value.kind;
	*element = value;
	return true;
}
