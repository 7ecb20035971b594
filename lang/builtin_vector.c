#include "base/transform.h"
#include "lang/builtin.h"
#include "surface/noise.h"

static Vec3 vector_argument(const BuiltinCall *call, int i)
{
	return value_to_vec3(call->args[i]);
}

Value builtin_vlength(const BuiltinCall *call)
{
	return value_float(vec3_length(vector_argument(call, 0)));
}

Value builtin_vdot(const BuiltinCall *call)
{
	return value_float(vec3_dot(vector_argument(call, 0), vector_argument(call, 1)));
}

Value builtin_vcross(const BuiltinCall *call)
{
	return value_vec3(vec3_cross(vector_argument(call, 0), vector_argument(call, 1)));
}

Value builtin_vnormalize(const BuiltinCall *call)
{
	Vec3 v = vector_argument(call, 0);
	if (vec3_length2(v) == 0) {
		diag_warning(call->context->diag, call->where,
			     "a vector of no length cannot be normalized");
		return value_vec3(v);
	}
	return value_vec3(vec3_normalize(v));
}

Value builtin_vrotate(const BuiltinCall *call)
{
	Transform turn = transform_rotate(vector_argument(call, 1));
	return value_vec3(transform_point(&turn, vector_argument(call, 0)));
}

Value builtin_vaxis_rotate(const BuiltinCall *call)
{
	Vec3 axis = vector_argument(call, 1);
	if (vec3_length2(axis) == 0) {
		diag_warning(call->context->diag, call->where,
			     "the axis of 'vaxis_rotate' has no length");
		return value_vec3(vector_argument(call, 0));
	}
	Transform turn = transform_rotate_axis(axis, call->args[2].number);
	return value_vec3(transform_point(&turn, vector_argument(call, 0)));
}

/* vturbulence(lambda, omega, octaves, p) */
Value builtin_vturbulence(const BuiltinCall *call)
{
	Turbulence t = turbulence_default();
	double octaves = call->args[2].number;
	t.lambda = call->args[0].number;
	t.omega = call->args[1].number;
	t.octaves = turbulence_octaves(octaves);
	return value_vec3(turbulence_vector(vector_argument(call, 3), &t,
					    call->context->builder->settings.noise_generator));
}
