/* An egg: a bottom sphere at the origin, a top sphere whose centre lies on the bottom sphere's
 * top, a lemon between. */
#ifndef GEOM_OVUS_H
#define GEOM_OVUS_H

#include "base/arena.h"
#include "geom/shape.h"

/* NULL with *error set when a radius is negative. */
const void *ovus_create(Arena *arena, double bottom_radius, double top_radius, const char **error);
extern const ShapeClass ovus_class;

#endif
