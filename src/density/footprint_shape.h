/*
 * The shapes of all photons' footprints, from their neighbours in emitter space.
 */
#ifndef DENSITY_FOOTPRINT_SHAPE_H
#define DENSITY_FOOTPRINT_SHAPE_H

#include "density/estimator.h"
#include "density/footprint_kernel.h"

/* One for each photon, in the map's order; the caller's to free. */
Footprint *footprint_shapes(const EstimatorSetup *setup);

#endif
