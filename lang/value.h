/*
 * Values of the scene language: what an expression gives and what an identifier holds. Small,
 * copied by value; what they point to lives in the parse arena (strings, arrays) or the scene arena
 * (objects, textures...) and is never changed after others can see it, arrays excepted.
 */
#ifndef LANG_VALUE_H
#define LANG_VALUE_H

#include <stdbool.h>

#include "base/color.h"
#include "base/vec.h"

typedef enum ValueKind {
	VALUE_NONE, /* uninitialised: an array's empty element */
	VALUE_FLOAT,
	VALUE_VECTOR, /* 2 to 5 components */
	VALUE_COLOR, /* 5 components: red green blue filter transmit */
	VALUE_STRING,
	VALUE_ARRAY,
	VALUE_SPLINE,
	VALUE_FUNCTION,
	VALUE_VECTOR_FUNCTION, /* function { transform {...} } or { spline {...} } */
	VALUE_EXPRESSION, /* inside function { }: not a value yet but a tree that depends on
			     arguments */
	VALUE_FILE,
	VALUE_MACRO,
	/* Items: things with braces that can be named. */
	VALUE_OBJECT,
	VALUE_TEXTURE, /* the head of a list of layers */
	VALUE_PIGMENT,
	VALUE_NORMAL,
	VALUE_FINISH,
	VALUE_INTERIOR,
	VALUE_MATERIAL,
	VALUE_MEDIA,
	VALUE_DENSITY,
	VALUE_CAMERA,
	VALUE_FOG,
	VALUE_RAINBOW,
	VALUE_SKY_SPHERE,
	VALUE_TRANSFORM,
	VALUE_COLOR_MAP,
	VALUE_PIGMENT_MAP,
	VALUE_NORMAL_MAP,
	VALUE_SLOPE_MAP,
	VALUE_TEXTURE_MAP,
	VALUE_DENSITY_MAP,
	VALUE_ESTIMATOR,
	VALUE_KIND_COUNT
} ValueKind;

typedef struct Array Array;       /* lang/array.h */
typedef struct Spline Spline;     /* lang/spline.h */
typedef struct Macro Macro;       /* parser/macro.h */
typedef struct SceneFile SceneFile; /* lang/files.h */
typedef struct Expression Expression; /* lang/expression.h: tree inside a function body */

typedef struct Value {
	ValueKind kind;
	int size; /* VECTOR: components */
	union {
		double number;
		double v[5]; /* VECTOR, COLOR */
		const char *string; /* UTF-8, NUL at the end */
		Array *array;
		const Spline *spline;
		const Macro *macro;
		SceneFile *file;
		const Expression *expression;
		const void *item; /* FUNCTION: const Function *; OBJECT: const Object *; TEXTURE:
				     const Texture *; ... */
	};
} Value;

static inline Value value_none(void) { return (Value){.kind = VALUE_NONE}; }
static inline Value value_float(double x)
{
	return (Value){.kind = VALUE_FLOAT, .size = 1, .number = x};
}
static inline Value value_vec3(Vec3 p)
{
	return (Value){.kind = VALUE_VECTOR, .size = 3, .v = {p.x, p.y, p.z}};
}
static inline Value value_string(const char *s)
{
	return (Value){.kind = VALUE_STRING, .string = s};
}
static inline Value value_item(ValueKind kind, const void *item)
{
	return (Value){.kind = kind, .item = item};
}

static inline bool value_is_numeric(Value a)
{
	return a.kind == VALUE_FLOAT || a.kind == VALUE_VECTOR || a.kind == VALUE_COLOR;
}

/* Of numeric values only. A float stands for a vector of equal components; missing components are
 * 0. */
double value_to_float(Value a); /* a vector gives its x */
Vec3 value_to_vec3(Value a);
Vec2 value_to_vec2(Value a);
/* rgbft by components; a float f gives <f, f, f, f, f> as POV-Ray's promotion does for `rgbft f`; a
 * colour keeps its own. */
Rgbft value_to_rgbft(Value a);

/* "a float", "a vector of 3", "a texture": for messages. */
const char *value_describe(Value a);

#endif
