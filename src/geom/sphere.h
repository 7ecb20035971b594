/* A sphere. */
#ifndef GEOM_SPHERE_H
#define GEOM_SPHERE_H

#include "base/arena.h"
#include "geom/shape.h"

typedef struct Sphere {
	Vec3 center;
	double radius, inverse_radius;
} Sphere;

/* A negative radius counts as positive; a sphere of radius 0 is never hit. */
const void *sphere_create(Arena *arena, Vec3 center, double radius);
extern const ShapeClass sphere_class;

/* Where a ray crosses a sphere: two parameters, rising; false when it misses. From the point of the
 * line nearest to the centre, which keeps far origins exact. */
static inline bool sphere_cross(Vec3 center, double radius, const Ray *ray, double t[2])
{
	Vec3 from = vec3_sub(ray->origin, center);
	double inverse2 = 1 / vec3_length2(ray->direction),
	       middle = -vec3_dot(from, ray->direction) * inverse2;
	Vec3 nearest = vec3_mad(from, middle, ray->direction);
	double left = radius * radius - vec3_length2(nearest);
	if (!(left > 0))
		return false;
	double half = sqrt(left * inverse2);
	t[0] = middle - half;
	t[1] = middle + half;
	return true;
}

/* The outward normal at a point of the sphere: unit. */
static inline Vec3 sphere_normal_at(const Sphere *sphere, Vec3 p)
{
	return vec3_unit_again(
		vec3_scale(vec3_sub(p, sphere->center), sphere->inverse_radius));
}

/* POV-Ray's spherical coordinates of a direction of any length: u its turn, v from the south pole
 * (0) to the north (1). */
Vec2 sphere_uv_of(Vec3 direction);

#endif
