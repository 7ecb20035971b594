/*
 * The shapes of all photons' footprints, from their neighbours in emitter space.
 */
#ifndef DENSITY_FOOTPRINT_SHAPE_H
#define DENSITY_FOOTPRINT_SHAPE_H

#include "density/estimator.h"
#include "density/footprint_kernel.h"

/* The block is the caller's to free. */
typedef struct FootprintList {
	Footprint *all;
	uint32_t count;
} FootprintList;

/* One for each photon, several where hues part. */
FootprintList footprint_shapes(const EstimatorSetup *setup);

#endif
