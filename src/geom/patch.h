/* Flat polygons and bicubic patches. */
#ifndef GEOM_PATCH_H
#define GEOM_PATCH_H

#include "base/arena.h"
#include "geom/mesh.h"
#include "geom/shape.h"

/* Points of a plane polygon; a point that repeats the first of its part closes the part, further
 * parts are holes (even-odd). NULL with *error set when the points do not lie in a plane. */
const void *polygon_create(Arena *arena, const Vec3 *points, int count, const char **error);
extern const ShapeClass polygon_class;

/* A bicubic Bezier patch of 16 control points, row by row, as a smooth mesh of 2^u_steps x
 * 2^v_steps cells (mesh_class). uv: the texture coordinates of its four corners, or NULL for the
 * patch's own. */
typedef struct PatchDesc {
	Vec3 control[16];
	int u_steps, v_steps;
	double flatness; /* finer steps stop when a cell is this flat; 0: never */
	const Vec2 *uv;
} PatchDesc;

/* In the arena; never fails. */
Mesh *bicubic_patch_create(Arena *arena, const PatchDesc *desc);

#endif
