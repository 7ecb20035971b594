/* A half space: all points with dot(normal, p) <= distance. */
#ifndef GEOM_PLANE_H
#define GEOM_PLANE_H

#include "base/arena.h"
#include "geom/shape.h"

typedef struct Plane {
	Vec3 normal; /* unit */
	double distance;
} Plane;

/* The normal may have any length, distance counts in units of space. NULL with *error set for a
 * zero normal. */
const void *plane_create(Arena *arena, Vec3 normal, double distance, const char **error);
extern const ShapeClass plane_class;

/* Where a ray crosses the plane; false when it runs along. */
static inline bool plane_cross(const Plane *plane, const Ray *ray, double *t)
{
	double slope = vec3_dot(plane->normal, ray->direction);
	*t = (plane->distance - vec3_dot(plane->normal, ray->origin)) / slope;
	return slope != 0;
}

#endif
