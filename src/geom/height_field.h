/* A height field: a grid of heights over the unit square of x and z, two triangles a cell. */
#ifndef GEOM_HEIGHT_FIELD_H
#define GEOM_HEIGHT_FIELD_H

#include "base/arena.h"
#include "geom/shape.h"

typedef struct HeightFieldDesc {
	int width, depth;     /* samples along x and z, at least 2 each */
	const float *heights; /* width x depth, x fastest, row 0 at z = 0; 0..1 */
	bool smooth;
	double water_level;   /* triangles wholly below are left out; 0: none */
} HeightFieldDesc;

/* NULL with *error set for too few samples. The heights must outlive it. */
const void *height_field_create(Arena *arena, const HeightFieldDesc *desc, const char **error);
extern const ShapeClass height_field_class, smooth_height_field_class;

#endif
