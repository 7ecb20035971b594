/*
 * What photons of other kinds say about a sheet: where light of the same lamp went another way,
 * the sheet has a gap, however small. Unless both ways start at the same places, as where a surface
 * splits light: such strangers say nothing.
 */
#ifndef DENSITY_FOOTPRINT_STRANGERS_H
#define DENSITY_FOOTPRINT_STRANGERS_H

#include "density/footprint_mesh.h"

/* Over photons sorted by kind: kinds[i] of photons[i], equal ones and those of a light together.
 * The arrays stay the caller's and must outlive it. */
Strangers *footprint_strangers_create(const PhotonMap *map, const uint32_t *photons,
				      const uint32_t *kinds);
void footprint_strangers_destroy(Strangers *strangers);

/* Sets gaps[t] of the triangles that are in a gap. The sheet's rings hold triangles. */
void footprint_strangers_find(const Sheet *sheet, bool *gaps);

#endif
