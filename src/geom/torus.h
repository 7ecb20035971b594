/* A torus around the y axis. */
#ifndef GEOM_TORUS_H
#define GEOM_TORUS_H

#include "base/arena.h"
#include "geom/shape.h"

/* major: from the axis to the middle of the tube; minor: the tube's radius; without a positive
 * one the torus is never hit. */
const void *torus_create(Arena *arena, double major, double minor);
extern const ShapeClass torus_class;

#endif
