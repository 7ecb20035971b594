/*
 * How lights weaken with direction and distance: POV-Ray 3.7's manual, sections 3.4.4.1.2
 * (spotlight), .3 (cylinder), .4 (parallel) and .9 (fading).
 */
#include "light/light.h"

Light light_default(void)
{
	return (Light){
		.kind = LIGHT_POINT, .color = {1, 1, 1}, .point_at = {0, 0, 1},
		.adaptive = -1, .media_interaction = true, .media_attenuation = false,
		.photons_refraction = true, .photons_reflection = true, .photons_share = 1,
	};
}

/* The spline 3t^2 - 2t^3 from 0 at low to 1 at high. */
static double smooth_step(double low, double high, double at)
{
	if (at >= high) /* first: a spot whose radius exceeds its falloff is all radius */
		return 1;
	if (at <= low)
		return 0;
	double t = (at - low) / (high - low);
	return t * t * (3 - 2 * t);
}

/* axis: unit, from the light to what it points at. */
static double spot_share(const Light *light, Vec3 axis, Vec3 to_light)
{
	double cosine = -vec3_dot(axis, to_light);
	if (cosine <= 0)
		return 0;
	double share = light->tightness != 0 ? pow(cosine, light->tightness) : 1;
	return light->falloff > 0 ? share * smooth_step(light->falloff, light->radius, cosine)
				  : share;
}

static double cylinder_share(const Light *light, Vec3 from, Vec3 axis, Vec3 p)
{
	Vec3 offset = vec3_sub(p, from);
	double along = vec3_dot(offset, axis);
	if (along <= 0 || light->falloff <= 0)
		return 0;
	double across = sqrt(fmax(vec3_length2(offset) - along * along, 0));
	double inward = 1 - across / light->falloff;
	if (inward <= 0)
		return 0;
	double share = light->tightness != 0 ? pow(inward, light->tightness) : 1;
	return share * smooth_step(0, 1 - light->radius / light->falloff, inward);
}

double light_fade(const Light *light, double distance)
{
	if (light->fade_power <= 0 || light->fade_distance <= 0)
		return 1;
	return 2 / (1 + pow(distance / light->fade_distance, light->fade_power));
}

static Vec3 light_axis(const Light *light)
{
	return vec3_normalize(vec3_sub(light->point_at, light->position));
}

/* From everywhere along one axis. */
static Rgb arrival_along_axis(const Light *light, Vec3 from, Vec3 p, Vec3 *direction,
			      double *distance)
{
	Vec3 axis = light_axis(light);
	*direction = vec3_neg(axis);
	*distance = fabs(vec3_dot(vec3_sub(from, p), axis));
	double share = light_fade(light, *distance);
	if (light->kind == LIGHT_SPOT) {
		Vec3 to_light = vec3_normalize(vec3_sub(from, p));
		share *= spot_share(light, axis, to_light);
	} else if (light->kind == LIGHT_CYLINDER) {
		share *= cylinder_share(light, from, axis, p);
	}
	return rgb_scale(light->color, (float)share);
}

Rgb light_arrival(const Light *light, Vec3 from, Vec3 p, Vec3 *direction, double *distance)
{
	if (light->parallel || light->kind == LIGHT_CYLINDER)
		return arrival_along_axis(light, from, p, direction, distance);
	Vec3 offset = vec3_sub(from, p);
	double length = vec3_length(offset);
	*direction = vec3_scale(offset, length > 0 ? 1 / length : 0);
	*distance = length;
	double share = light_fade(light, length);
	if (light->kind == LIGHT_SPOT)
		share *= spot_share(light, light_axis(light), *direction);
	return rgb_scale(light->color, (float)share);
}
