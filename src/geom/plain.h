/*
 * Spheres and planes as they stand in the world, asked without calls: what their classes answer,
 * for loops that ask so often that a call would be a good part of the work.
 */
#ifndef GEOM_PLAIN_H
#define GEOM_PLAIN_H

#include "geom/plane.h"
#include "geom/sphere.h"

/* Where a ray that starts at tmin crosses one first; NaN where it does not. */
static inline double plain_sphere(const Sphere *sphere, const Ray *ray)
{
	double t[2];
	if (!sphere_cross(sphere->center, sphere->radius, ray, t))
		return NAN;
	return t[0] > ray->tmin ? t[0] : t[1];
}

static inline double plain_plane(const Plane *plane, const Ray *ray)
{
	double t;
	return plane_cross(plane, ray, &t) ? t : NAN;
}

/* The nearest crossing of all of some shapes without transform, clips and bounds, of classes that
 * have `quick`; *best is left alone when there is none. */
static inline bool plain_nearest(const Shape *const *shapes, int count, const Ray *ray, Hit *best)
{
	double end = ray->tmax, t;
	const Shape *first = NULL;
	bool other = false; /* *best is it */
	for (int i = 0; i < count; i++) {
		const Shape *shape = shapes[i];
		if (shape->class == &sphere_class) {
			t = plain_sphere(shape->data, ray);
		} else if (shape->class == &plane_class) {
			t = plain_plane(shape->data, ray);
		} else {
			Ray cut = {ray->origin, ray->direction, ray->tmin, end};
			if (shape->class->nearest(shape, &cut, best)) {
				end = best->t;
				first = NULL;
				other = true;
			}
			continue;
		}
		if (t > ray->tmin && t < end) {
			end = t;
			first = shape;
		}
	}
	if (first)
		*best = (Hit){.t = end, .shape = first};
	return first || other;
}

/* hit_shading_normal, for any shape. */
static inline Vec3 plain_shading_normal(const Hit *hit, Vec3 world)
{
	const Shape *shape = hit->shape;
	if (!shape->transform && !shape->inverted) {
		if (shape->class == &sphere_class)
			return sphere_normal_at(shape->data, world);
		if (shape->class == &plane_class)
			return ((const Plane *)shape->data)->normal;
	}
	return hit_shading_normal(hit, world);
}

#endif
