/*
 * Spheres and planes as they stand in the world, asked without calls: what their classes answer,
 * for loops that ask so often that a call would be a good part of the work.
 */
#ifndef GEOM_PLAIN_H
#define GEOM_PLAIN_H

#include "geom/plane.h"
#include "geom/sphere.h"

/* Shapes without transform, clips and bounds, of classes that have `quick`: spheres first, up to
 * sphere_end, then planes, up to plane_end, then others. */
typedef struct PlainShapes {
	const Shape *const *shapes;
	int sphere_end, plane_end, count;
} PlainShapes;

/* What the search for the nearest crossing has found: a crossing of `first`, or with first NULL and
 * found true one that is already in the caller's Hit. */
typedef struct PlainSearch {
	double end;
	const Shape *first;
	bool found;
} PlainSearch;

static inline void plain_take(PlainSearch *search, const Ray *ray, const Shape *shape, double t)
{
	if (!(t > ray->tmin && t < search->end))
		return;
	search->end = t;
	search->first = shape;
	search->found = true;
}

static inline void plain_search_others(const PlainShapes *plain, const Ray *ray,
				       PlainSearch *search, Hit *best)
{
	for (int i = plain->plane_end; i < plain->count; i++) {
		const Shape *shape = plain->shapes[i];
		Ray cut = {ray->origin, ray->direction, ray->tmin, search->end};
		if (shape->class->nearest(shape, &cut, best))
			*search = (PlainSearch){best->t, NULL, true};
	}
}

/* The nearest crossing of all; *best is left alone when there is none. */
static inline bool plain_nearest(const PlainShapes *plain, const Ray *ray, Hit *best)
{
	PlainSearch search = {ray->tmax, NULL, false};
	double t[2];
	for (int i = 0; i < plain->sphere_end; i++) {
		const Sphere *sphere = plain->shapes[i]->data;
		if (sphere_cross(sphere->center, sphere->radius, ray, t))
			plain_take(&search, ray, plain->shapes[i],
				   t[0] > ray->tmin ? t[0] : t[1]);
	}
	for (int i = plain->sphere_end; i < plain->plane_end; i++)
		if (plane_cross(plain->shapes[i]->data, ray, t))
			plain_take(&search, ray, plain->shapes[i], t[0]);
	plain_search_others(plain, ray, &search, best);
	if (search.first)
		*best = (Hit){.t = search.end, .shape = search.first};
	return search.found;
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
