/* Maps from emitter to surface that are known, and what footprints make of them. */
#ifndef TESTS_UNIT_FOOTPRINT_CHECK_H
#define TESTS_UNIT_FOOTPRINT_CHECK_H

#include "density/estimator.h"
#include "tests/bench/known_map.h"
#include "tests/unit/check.h"

static inline void even_way(double u, double v, double to[2])
{
	to[0] = u;
	to[1] = v;
}

static inline void straight_way(double u, double v, double to[2])
{
	to[0] = 2 * u + 0.3 * v;
	to[1] = 0.5 * v - 0.1 * u;
}

/* count photons of flux 1 / count, Halton's points of the unit square of a plane emitter. */
static inline PhotonMap *map_by_way(uint32_t count, uint64_t first, KnownWay *way)
{
	return known_map_make(&(KnownMap){way, 0, 1}, count, first);
}

/* radius: of a progressive pass, or 0. */
static inline DensityEstimator *footprint_estimator(const PhotonMap *map, double radius)
{
	Diag *diag = diag_create(NULL);
	PhotonSettings settings = photon_settings_default();
	Estimator method = {.kind = ESTIMATOR_FOOTPRINT};
	EstimatorSetup setup = {&method, &settings, map, radius, NULL};
	DensityEstimator *estimator = estimator_create(&setup, diag);
	CHECK(estimator && diag_errors(diag) == 0);
	diag_destroy(diag);
	return estimator;
}

/* What the floor receives at a place, of a pixel so wide. */
static inline double footprint_light(const DensityEstimator *estimator, double x, double z,
				     double pixel)
{
	GatherPoint point = {
		.position = vec3(x, 0, z), .normal = vec3(0, 1, 0), .footprint = pixel};
	GatherResult result;
	estimator_gather(estimator, &point, known_map_white, NULL, &result);
	return result.radiance.g;
}

/* A sheet's light in a square of windows that leaves nothing out. */
static inline double footprint_total(const DensityEstimator *estimator, double low, double width,
				     int side)
{
	double sum = 0, step = width / side;
	for (int j = 0; j < side; j++)
		for (int i = 0; i < side; i++)
			sum += footprint_light(estimator, low + (i + 0.5) * step,
				       low + (j + 0.5) * step, step);
	return sum * step * step;
}

#endif
