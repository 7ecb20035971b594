/*
 * What all photons of a map give: patches of the sheets they sample, and discs for those that
 * belong to none.
 */
#ifndef DENSITY_FOOTPRINT_PARTS_H
#define DENSITY_FOOTPRINT_PARTS_H

#include "density/estimator.h"
#include "density/footprint_sheet.h"

/* A photon's light over the disc that holds the nearest photons on the surface, with
 * Epanechnikov's kernel. */
typedef struct Disc {
	float at[3], radius;
	Rgb flux;
	uint32_t photon;
} Disc;

/* The blocks are the caller's to free. */
typedef struct FootprintParts {
	PatchList patches;
	Disc *discs;
	uint32_t disc_count;
} FootprintParts;

/* Parts of them when it is stopped. */
FootprintParts footprint_parts(const EstimatorSetup *setup);

#endif
