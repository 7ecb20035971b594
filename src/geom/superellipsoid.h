/* A superquadric ellipsoid: (|x|^(2/e) + |y|^(2/e))^(e/n) + |z|^(2/n) = 1. */
#ifndef GEOM_SUPERELLIPSOID_H
#define GEOM_SUPERELLIPSOID_H

#include "base/arena.h"
#include "geom/shape.h"

/* Exponents of 0 or less count as nearly 0: a box. */
const void *superellipsoid_create(Arena *arena, double e, double n);
extern const ShapeClass superellipsoid_class;

#endif
