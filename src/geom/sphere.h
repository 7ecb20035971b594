/* A sphere. */
#ifndef GEOM_SPHERE_H
#define GEOM_SPHERE_H

#include "base/arena.h"
#include "geom/shape.h"

/* A negative radius counts as positive; a sphere of radius 0 is never hit. */
const void *sphere_create(Arena *arena, Vec3 center, double radius);
extern const ShapeClass sphere_class;

/* Where a ray crosses a sphere: two parameters, rising; false when it misses. */
bool sphere_cross(Vec3 center, double radius, const Ray *ray, double t[2]);

/* POV-Ray's spherical coordinates of a direction: u goes round from the x axis towards z, v from
 * the south pole to the north. */
Vec2 sphere_uv_of(Vec3 direction);

#endif
