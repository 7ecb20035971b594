/*
 * Arrays: up to five dimensions of values of any kind, an element may be an array again. They live
 * in the parse arena; elements are changed in place, so `#declare B = A` copies (array_copy).
 */
#ifndef LANG_ARRAY_H
#define LANG_ARRAY_H

#include "lang/context.h"
#include "lang/value.h"

enum { ARRAY_MAX_DIMENSIONS = 5 };

struct Array {
	int dimensions;
	int size[ARRAY_MAX_DIMENSIONS];
	long length;     /* product of the sizes */
	ValueKind kind;  /* of the first element set; NONE before */
	Value *elements; /* row by row: the last subscript runs fastest; VALUE_NONE where not set */
};

/* NULL after a reported error: a size below 1, too many dimensions, too large. */
Array *array_create(Context *context, const double *sizes, int dimensions, Location where);
Array *array_copy(Arena *arena, const Array *array);
/* The element under the subscripts. Where they outnumber the dimensions the rest go into an element
 * that is an array. NULL after a reported error: out of bounds, too few or too many. The element
 * may be VALUE_NONE. */
Value *array_element(Context *context, Array *array, const double *subscripts, int count,
		     Location where);
/* `array[2][2] { {1,2}, {3,4} }`: checks that value can stand beside what is there (one kind an
 * array, floats, vectors and colours mixing as POV-Ray allows) and sets it. False after a reported
 * error. */
bool array_set(Context *context, Array *array, Value *element, Value value, Location where);

#endif
