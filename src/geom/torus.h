/* A torus around the y axis. */
#ifndef GEOM_TORUS_H
#define GEOM_TORUS_H

#include "base/arena.h"
#include "geom/shape.h"

/* major: from the axis to the middle of the tube; minor: the tube's radius. NULL with *error set when either is not positive. */
const void *torus_create(Arena *arena, double major, double minor, const char **error);
extern const ShapeClass torus_class;

#endif
