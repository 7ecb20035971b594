/*
 * A patch of a sheet: a triangle of emitter space as a quadratic map takes it to the surface, in
 * Bézier's form, with the flux that lands on it, even over the emitter's side.
 */
#ifndef DENSITY_FOOTPRINT_PATCH_H
#define DENSITY_FOOTPRINT_PATCH_H

#include <stdint.h>

#include "base/color.h"
#include "base/vec.h"
#include "density/window.h"

/* Control points 0 to 2 are the corners, 3 to 5 those of the edges 0 1, 1 2, 2 0. */
typedef struct Patch {
	float control[6][3]; /* world */
	float sweep[3];      /* the patch's light is smeared this far, half to either side: hues */
	Rgb flux;
	uint32_t photon;     /* one at a corner: says direction and surface */
} Patch;

/* The part of a patch between three points, given as barycentric coordinates of the corners; may
 * lie beyond the corners. Flux stays. */
void footprint_patch_cut(const Patch *patch, const double corners[3][3], Patch *out);
/* How far from a footprint of this size along the normal points may lie that see it, as
 * gather_accepts has it: the sides of a box from there. */
Vec3 footprint_depth(double size, Vec3 normal);
/* All of it and its depth. */
Box3 footprint_patch_box(const Patch *patch, Vec3 normal);
/* How far the longest side reaches. */
double footprint_patch_extent(const Patch *patch);

/* The share of a patch's light that falls into the window. */
double footprint_patch_share(const Patch *patch, const Window *window);

#endif
