#include "geom/sphere.h"

const void *sphere_create(Arena *arena, Vec3 center, double radius)
{
	Sphere *sphere = ARENA_NEW(arena, Sphere);
	*sphere = (Sphere){center, fabs(radius), 1 / fabs(radius)};
	return sphere;
}

/* Only where the uv axes stay what they are. */
static const void *sphere_placed(Arena *arena, const void *data, const Transform *transform)
{
	const Sphere *sphere = data;
	double scale;
	if (!transform_is_upright(transform) || !transform_is_similarity(transform, &scale))
		return NULL;
	return sphere_create(arena, transform_point(transform, sphere->center),
			     sphere->radius * scale);
}

static bool sphere_bounds(const void *data, Box3 *box)
{
	const Sphere *sphere = data;
	Vec3 half = vec3_all(sphere->radius);
	*box = (Box3){vec3_sub(sphere->center, half), vec3_add(sphere->center, half)};
	return true;
}

static void sphere_intersect(const Shape *self, const Ray *ray, HitList *out)
{
	const Sphere *sphere = self->data;
	double t[2];
	if (!sphere_cross(sphere->center, sphere->radius, ray, t))
		return;
	hit_list_add(out, ray, self, t[0], 0);
	hit_list_add(out, ray, self, t[1], 0);
}

static bool sphere_nearest(const Shape *self, const Ray *ray, Hit *out)
{
	const Sphere *sphere = self->data;
	double t[2];
	if (!sphere_cross(sphere->center, sphere->radius, ray, t))
		return false;
	return hit_take(out, ray, self, t[0] > ray->tmin ? t[0] : t[1], 0);
}

static bool sphere_inside(const void *data, Vec3 p)
{
	const Sphere *sphere = data;
	return vec3_length2(vec3_sub(p, sphere->center)) < sphere->radius * sphere->radius;
}

static Vec3 sphere_normal(const void *data, const Hit *hit, Vec3 p)
{
	(void)hit;
	return sphere_normal_at(data, p);
}

Vec2 sphere_uv_of(Vec3 direction)
{
	Vec3 at = vec3_normalize(direction);
	return (Vec2){vec3_turn(at), 0.5 + asin(fmax(-1, fmin(1, at.y))) / M_PI};
}

static Vec2 sphere_uv(const void *data, const Hit *hit, Vec3 p)
{
	(void)hit;
	return sphere_uv_of(vec3_sub(p, ((const Sphere *)data)->center));
}

const ShapeClass sphere_class = {
	.name = "sphere",
	.bounds = sphere_bounds,
	.intersect = sphere_intersect,
	.inside = sphere_inside,
	.normal = sphere_normal,
	.uv = sphere_uv,
	.nearest = sphere_nearest,
	.placed = sphere_placed,
	.quick = true,
	.unit_normal = true,
	.closed = shape_class_is_closed,
};
