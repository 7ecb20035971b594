#include "scene/photon_settings.h"

/* Spencer and Jones 2013, section 5: seven iterations in each space, 50 and 16 neighbours. */
Relaxation relaxation_default(void)
{
	return (Relaxation){.on = true, .constrained = true, .parameter_iterations = 7, .world_iterations = 7,
	                    .neighbors = 50, .repulsion_neighbors = 16, .range = 3};
}

PhotonSettings photon_settings_default(void)
{
	return (PhotonSettings){
		.gather_min = 20, .gather_max = 100, .jitter = 0.4, .adc_bailout = -1, .expand_increase = 0.2,
		.expand_min = 40, .media_factor = 1, .emitter_coordinates = true,
	};
}
