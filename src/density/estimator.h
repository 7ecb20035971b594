/*
 * Estimators of photon density: from a gather point and the photons around it to the light that
 * the surface shows. An estimator knows photons and the point, not the scene. One method a file, a
 * row in the table in estimator.c; which one is used is said in the scene language, globally and
 * per receiving object.
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
	/* Unit, from the eye to here, and the picture's horizontal, which need not be unit or at
	 * right angles to it: they say how the pixel lies on the surface. Zero: a square there. */
	Vec3 view, across;
	uint16_t object;  /* Surface.id */
	bool both_sides;  /* photons on the far side count as well (double_illuminate) */
} GatherPoint;

/* How a photon that arrives from direction (unit, away from the surface) counts at the point:
 * the smooth lobes' value. */
typedef Rgb GatherBsdf(void *data, Vec3 direction);

typedef struct GatherResult {
	Rgb radiance;   /* sum of kernel * flux * bsdf */
	int photons;    /* that were found */
	double radius;  /* of the search */
	Rgb parameter;  /* mean emitter coordinates as a colour (SJ13 Fig. 6e); black: no photons */
	float edges;    /* mean number of path edges (Fig. 6f) */
	float constraint; /* 1 - mean length of v_b (Fig. 6g): 0 where relaxation let photons move
			     freely */
} GatherResult;

typedef struct DensityEstimator DensityEstimator;

typedef struct EstimatorSetup {
	const Estimator *method; /* object's or scene's; all zeros: POV-Ray's way of gathering */
	const PhotonSettings *photons; /* the scene's: gather, radius, expand_thresholds */
	const PhotonMap *map;          /* indexed; outlives the estimator */
	double radius;                 /* of a progressive pass: every photon within it counts and
	                                * kernels are as wide as it; 0: none */
	const volatile int *stop;      /* creation ends soon after this becomes nonzero; NULL:
					* never */
} EstimatorSetup;

/* An estimator ready for one map: checks and prepares what the method needs (networks,
 * sheets, radii from the photons). What setup points to, except the map, need not outlive
 * the call. NULL on failure, reported, or when stopped. */
DensityEstimator *estimator_create(const EstimatorSetup *setup, Diag *diag);
void estimator_destroy(DensityEstimator *estimator); /* NULL is allowed */
/* Thread-safe. */
void estimator_gather(const DensityEstimator *estimator, const GatherPoint *point, GatherBsdf *bsdf,
                      void *data, GatherResult *result);

#endif
