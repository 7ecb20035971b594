#include "density/estimator.h"

#include <stdlib.h>

#include "base/arena.h"
#include "density/method.h"

struct DensityEstimator {
	const EstimatorMethod *method;
	void *data;
	const PhotonMap *map;
};

/* A method a row. */
static const EstimatorMethod *const methods[] = {
	[ESTIMATOR_NEAREST] = &nearest_method,
	[ESTIMATOR_DIFFUSION] = &diffusion_method,
	[ESTIMATOR_FOOTPRINT] = &footprint_method,
	[ESTIMATOR_DEEP] = NULL,
	[ESTIMATOR_ADAPTIVE] = NULL,
};

/* A scene that says nothing, neither how many photons nor how far, gathers as POV-Ray does. */
static bool says_nothing(const EstimatorSetup *setup)
{
	const Estimator *e = setup->method;
	return e->kind == ESTIMATOR_NEAREST && e->count == 0 && !(e->radius > 0) &&
	       !(setup->radius > 0);
}

DensityEstimator *estimator_create(const EstimatorSetup *setup, Diag *diag)
{
	const EstimatorMethod *method = methods[setup->method->kind];
	if (says_nothing(setup))
		method = &expand_method;
	if (!method) {
		diag_fail(diag, "this photon estimator is not available");
		return NULL;
	}
	if (setup->method->count > ESTIMATOR_MOST_PHOTONS) {
		diag_fail(diag, "estimator '%s': count %d is over %d", method->name,
			  setup->method->count, ESTIMATOR_MOST_PHOTONS);
		return NULL;
	}
	void *data = method->create(setup, diag);
	if (!data)
		return NULL;
	DensityEstimator *estimator = memory_alloc(sizeof *estimator);
	*estimator = (DensityEstimator){method, data, setup->map};
	return estimator;
}

void estimator_destroy(DensityEstimator *estimator)
{
	if (!estimator)
		return;
	free(estimator->data);
	free(estimator);
}

void estimator_gather(const DensityEstimator *estimator, const GatherPoint *point, GatherBsdf *bsdf,
                      void *data, GatherResult *result)
{
	GatherTask task = {estimator->map, point, bsdf, data};
	*result = (GatherResult){0};
	estimator->method->gather(estimator->data, &task, result);
}
