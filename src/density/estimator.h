/*
 * Estimators of photon density: from a gather point and the photons around it to the light that the surface shows. An estimator
 * knows photons and the point, not the scene. One method a file, a row in the table in estimator.c; which one is used is
 * said in the scene language, globally and per receiving object.
 */
#ifndef DENSITY_ESTIMATOR_H
#define DENSITY_ESTIMATOR_H

#include "base/color.h"
#include "base/vec.h"
#include "photon/map.h"
#include "scene/photon_settings.h"

/* Where light is gathered. */
typedef struct GatherPoint {
	Vec3 position;
	Vec3 normal;      /* unit, geometric, on the side that is seen */
	double footprint; /* width of a pixel there, scene units; 0: unknown */
	uint16_t object;  /* Surface.id */
} GatherPoint;

/* How a photon that arrives from direction (unit, away from the surface) counts at the point: the smooth lobes' value. */
typedef Rgb GatherBsdf(void *data, Vec3 direction);

typedef struct GatherResult {
	Rgb radiance;   /* sum of kernel * flux * bsdf */
	int photons;    /* that were found */
	double radius;  /* of the search */
	Rgb parameter;  /* mean emitter coordinates as a colour (SJ13 Fig. 6e) */
	float edges;    /* mean number of path edges (Fig. 6f) */
} GatherResult;

typedef struct DensityEstimator DensityEstimator;

/* An estimator ready for one map: checks and prepares what the method needs (networks, ellipses). radius: the scene's bound on search
 * radii, 0 none. NULL on failure, reported. */
DensityEstimator *estimator_create(const Estimator *settings, const PhotonMap *map, double radius, Diag *diag);
void estimator_destroy(DensityEstimator *estimator);
/* Thread-safe. */
void estimator_gather(const DensityEstimator *estimator, const GatherPoint *point, GatherBsdf *bsdf, void *data,
                      GatherResult *result);

#endif
