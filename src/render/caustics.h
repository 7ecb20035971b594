/*
 * Light that came by mirrors and through glass: an indexed photon map, an estimator for the scene
 * and one for each object that asks for its own. Immutable once created; any number of threads may
 * gather.
 */
#ifndef RENDER_CAUSTICS_H
#define RENDER_CAUSTICS_H

#include "density/estimator.h"
#include "render/lighting.h"

typedef struct CausticOptions {
	const Estimator *estimator; /* instead of the scene's and its objects'; NULL: theirs */
	double radius;              /* of a progressive pass; 0: none */
	const volatile int *stop;   /* creation ends soon after this becomes nonzero; NULL: never */
} CausticOptions;

/* What it took to create, seconds. */
typedef struct CausticTimes {
	double index;      /* the search tree */
	double estimators; /* what they prepare: footprints' sheets, for one */
} CausticTimes;

/* False, reported, when an estimator needs what the scene has turned off. switched stands for the
 * scene's and its objects' if it is not NULL. */
bool caustics_check(const Scene *scene, const Estimator *switched, Diag *diag);

/* Indexes the map and takes it over, even on failure. NULL on failure, reported, or when stopped.
 * times are added to. */
Caustics *caustics_create(const Scene *scene, PhotonMap *map, const CausticOptions *options,
			  CausticTimes *times, Diag *diag);
void caustics_destroy(Caustics *caustics); /* NULL is allowed */

/* Caustic light that the surface sends to the viewer; result says how it was found. All zero where
 * nothing collects. */
void caustics_gather(const Caustics *caustics, const LitPoint *at, const Bsdf *bsdf,
		     GatherResult *result);

/* Whether photons carry what the light sends through the surface: then its shadow is empty of
 * filtered light. */
bool caustics_replace_shadow(const Caustics *caustics, const Light *light, const Surface *surface);

#endif
