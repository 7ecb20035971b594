#include "scene/photon_settings.h"

#include <stddef.h>
#include <string.h>

enum { NEAREST_COUNT = 50 };

bool photon_estimator_named(const char *name, Estimator *out)
{
	static const struct {
		const char *name;
		Estimator estimator;
	} rows[] = {
		{"povray", {.kind = ESTIMATOR_NEAREST}},
		{"nearest",
		 {.kind = ESTIMATOR_NEAREST,
		  .kernel = KERNEL_EPANECHNIKOV,
		  .count = NEAREST_COUNT}},
		{"diffusion", {.kind = ESTIMATOR_DIFFUSION}},
		{"footprint", {.kind = ESTIMATOR_FOOTPRINT}},
		{"deep", {.kind = ESTIMATOR_DEEP}},
		{"adaptive", {.kind = ESTIMATOR_ADAPTIVE, .kernel = KERNEL_GAUSSIAN}},
	};
	for (size_t i = 0; i < sizeof rows / sizeof *rows; i++)
		if (strcmp(rows[i].name, name) == 0) {
			*out = rows[i].estimator;
			return true;
		}
	return false;
}

/*
 * Spencer and Jones 2013, section 5, have seven iterations in each space and a range of three.
 * Beside folds relaxation blurs; so many iterations, of photons from a smaller range, were nearer
 * to references on most scenes measured (cognac-photons(7)).
 */
Relaxation relaxation_default(void)
{
	return (Relaxation){.on = true,
			    .constrained = true,
			    .parameter_iterations = 4,
			    .world_iterations = 6,
			    .neighbors = 50,
			    .repulsion_neighbors = 16,
			    .range = 2,
			    .gradient = true,
			    .hues = true};
}

/* Fourteen iterations in all, as the paper has for comparison. */
Relaxation relaxation_plain(void)
{
	Relaxation plain = relaxation_default();
	plain.constrained = false;
	plain.parameter_iterations = plain.world_iterations = 7;
	return plain;
}

PhotonSettings photon_settings_default(void)
{
	return (PhotonSettings){
		.gather_min = 20,
		.gather_max = 100,
		.autostop = 1,
		.adc_bailout = -1,
		.expand_increase = 0.2,
		.expand_min = 40,
		.media_factor = 1,
		.emitter_coordinates = true,
	};
}
