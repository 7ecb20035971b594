/* Cylinders, cones and frusta. hit.part: 0 the side, 1 the base, 2 the cap. */
#ifndef GEOM_CONE_H
#define GEOM_CONE_H

#include "base/arena.h"
#include "geom/shape.h"

typedef struct ConeDesc {
	Vec3 base, cap;
	double base_radius, cap_radius;
	bool open; /* no end discs */
} ConeDesc;

/* NULL with *error set when base and cap coincide. Equal radii make a cylinder, radii of
 * different sign two cones that touch. Data for cone_class and cylinder_class alike: they differ
 * in name only. */
const void *cone_create(Arena *arena, const ConeDesc *desc, const char **error);
extern const ShapeClass cone_class, cylinder_class;

#endif
