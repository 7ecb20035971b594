/* A half space: all points with dot(normal, p) <= distance. */
#ifndef GEOM_PLANE_H
#define GEOM_PLANE_H

#include "base/arena.h"
#include "geom/shape.h"

/* The normal may have any length, distance counts in units of space. NULL with *error set for a
 * zero normal. */
const void *plane_create(Arena *arena, Vec3 normal, double distance, const char **error);
extern const ShapeClass plane_class;

#endif
