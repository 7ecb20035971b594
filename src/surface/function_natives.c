#include "surface/function_natives.h"

static SurfacePoint point_at(const double *args)
{
	Vec3 p = vec3(args[0], args[1], args[2]);
	return (SurfacePoint){
		.p = p, .world = p, .normal = vec3(0, 1, 0), .direction = vec3(0, 0, 1)};
}

static double eval_pattern(const void *data, const double *args)
{
	SurfacePoint at = point_at(args);
	return pattern_value(data, &at);
}

const Function *function_of_pattern(Arena *arena, const Pattern *pattern)
{
	return function_native(arena, 3, eval_pattern, pattern);
}

static void eval_pigment(const void *data, const double *args, double out[5])
{
	SurfacePoint at = point_at(args);
	Rgbft color = pigment_color(data, &at);
	out[0] = color.r;
	out[1] = color.g;
	out[2] = color.b;
	out[3] = color.filter;
	out[4] = color.transmit;
}

static double eval_gray(const void *data, const double *args)
{
	const VectorFunction *vector = data;
	double c[5];
	vector->eval(vector->data, args, c);
	return 0.297 * c[0] + 0.589 * c[1] + 0.114 * c[2];
}

const Function *function_of_gray(Arena *arena, const VectorFunction *vector)
{
	return function_native(arena, vector->arity, eval_gray, vector);
}

static void eval_transform(const void *data, const double *args, double out[5])
{
	Vec3 p = transform_point(data, vec3(args[0], args[1], args[2]));
	out[0] = p.x;
	out[1] = p.y;
	out[2] = p.z;
	out[3] = out[4] = 0;
}

static const VectorFunction *make_vector_function(Arena *arena, VectorFunction function)
{
	return arena_copy(arena, &function, sizeof function);
}

const VectorFunction *function_of_pigment(Arena *arena, const Pigment *pigment)
{
	return make_vector_function(arena, (VectorFunction){3, 5, true, eval_pigment, pigment});
}

const VectorFunction *function_of_transform(Arena *arena, const Transform *transform)
{
	const Transform *copy = arena_copy(arena, transform, sizeof *transform);
	return make_vector_function(arena, (VectorFunction){3, 3, false, eval_transform, copy});
}
