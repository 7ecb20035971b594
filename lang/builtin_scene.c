#include "lang/builtin.h"

#include <stdint.h>
#include <stdio.h>

#include "geom/shape.h"
#include "lang/array.h"
#include "lang/files.h"
#include "scene/flatten.h"

/* What POV-Ray gives for the sides where an object has no end. */
#define UNBOUNDED 1e10
/* Hits nearer than this to the start of a traced ray do not count. */
#define TRACE_START 1e-6

/* The shapes of objects that were asked lately. Objects never change, so an address stands for one.
 */
enum { SHAPE_CACHE_SIZE = 256 };

struct ShapeCache {
	struct {
		const Object *object;
		const Shape *shape;
	} entries[SHAPE_CACHE_SIZE];
};

static const Shape *shape_of(Context *context, const Object *object)
{
	if (!context->shapes)
		context->shapes = ARENA_NEW(context->parse, struct ShapeCache);
	size_t slot = ((uintptr_t)object >> 4) % SHAPE_CACHE_SIZE;
	if (context->shapes->entries[slot].object != object) {
		context->shapes->entries[slot].object = object;
		context->shapes->entries[slot].shape = object_shape(context->builder->arena,
								    object);
	}
	return context->shapes->entries[slot].shape;
}

Value builtin_inside(const BuiltinCall *call)
{
	const Shape *shape = shape_of(call->context, call->args[0].item);
	return value_float(shape && shape_inside(shape, value_to_vec3(call->args[1])));
}

static Value trace_object(Context *context, const Value args[3], Value *normal)
{
	const Shape *shape = shape_of(context, args[0].item);
	Ray ray = {value_to_vec3(args[1]), vec3_normalize(value_to_vec3(args[2])), TRACE_START,
		   UNBOUNDED};
	Hit hit;
	*normal = value_vec3(vec3_all(0));
	if (!shape || vec3_length2(ray.direction) == 0 || !shape_nearest(shape, &ray, &hit))
		return value_vec3(vec3_all(0));
	Vec3 p = ray_at(&ray, hit.t);
	*normal = value_vec3(hit_shading_normal(&hit, p));
	return value_vec3(p);
}

Value builtin_trace(const BuiltinCall *call)
{
	Value normal;
	return trace_object(call->context, call->args, &normal);
}

Value expression_trace(Context *context, const Value args[3], Value *normal, Location where)
{
	Value ignored;
	bool fits = args[0].kind == VALUE_OBJECT && value_is_numeric(args[1]) &&
		    value_is_numeric(args[2]);
	if (fits)
		return trace_object(context, args, normal ? normal : &ignored);
	if (normal)
		*normal = value_vec3(vec3_all(0));
	return expression_call(context, W_trace, args, 3, where);
}

static double limited(double x)
{
	return x < -UNBOUNDED ? -UNBOUNDED : x > UNBOUNDED ? UNBOUNDED : x;
}

Value builtin_extent(const BuiltinCall *call)
{
	const Shape *shape = shape_of(call->context, call->args[0].item);
	Vec3 corner = vec3_all(0);
	if (shape)
		corner = call->word == W_min_extent ? shape->box.lo : shape->box.hi;
	return value_vec3(vec3(limited(corner.x), limited(corner.y), limited(corner.z)));
}

Value builtin_dimensions(const BuiltinCall *call)
{
	return value_float(call->args[0].array->dimensions);
}

/* Counting from 1; a dimension that the array lacks has size 0. */
Value builtin_dimension_size(const BuiltinCall *call)
{
	const Array *array = call->args[0].array;
	double which = call->args[1].number;
	return value_float(which >= 1 && which < array->dimensions + 1 ? array->size[(int)which - 1]
								       : 0);
}

Value builtin_defined(const BuiltinCall *call)
{
	return value_float(call->args[0].kind != VALUE_NONE);
}

Value builtin_file_exists(const BuiltinCall *call)
{
	const char *path = files_find(call->context, call->args[0].string);
	return value_float(path && files_may_read(call->context, path, call->where));
}
