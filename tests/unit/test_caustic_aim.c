/* Paths are aimed at the whole of a target and lose none of it: clear bodies that bend no light,
 * under parallel light, leave all that they cast a shadow with on the floor. */
#include <stdio.h>

#include "tests/unit/caustic_check.h"

/* Its rays are all but parallel; they are aimed at balls, where parallel lights see boxes. */
#define FAR_POINT "y*1e5 rgb 1"

/* A clear target between a floor and a light. */
static PhotonMap *trace_target(const char *target, const char *light)
{
	char text[1000];
	snprintf(text, sizeof text,
	         "#version 3.7;\n"
	         "global_settings { photons { count 400000 } }\n"
	         "light_source { %s point_at 0 }\n"
	         "plane { y, -3 pigment { rgb 1 } }\n"
	         "%s pigment { rgbt 1 } finish { diffuse 0 } interior { ior 1 }\n"
	         "  photons { target refraction on collect off } }\n",
	         light, target);
	return caustic_trace(text);
}

static double flux_of(const PhotonMap *map)
{
	double sum = 0;
	for (uint32_t i = 0; i < map->count; i++)
		sum += rgb_gray(photon_flux(&map->photons[i]));
	return sum;
}

/* shadow: the target's area seen from the light. */
static void check_shadow(const char *target, const char *light, double shadow)
{
	PhotonMap *map = trace_target(target, light);
	if (!map)
		return;
	CHECK_NEAR(flux_of(map) / shadow, 1, 1e-3);
	photon_map_destroy(map);
}

/* Each photon has entered the box and left it, however near to an edge. */
static void check_edges(void)
{
	PhotonMap *map = trace_target("box { <-1, 1, -1>, <1, 1.5, 1>",
				      "<-7, 10, 4> rgb 1 parallel");
	uint32_t slipped = 0;
	for (uint32_t i = 0; map && i < map->count; i++)
		slipped += map->photons[i].edges != 3;
	CHECK(slipped == 0);
	photon_map_destroy(map);
}

int main(void)
{
	double along = sqrt(7 * 7 + 10 * 10 + 4 * 4);
	check_shadow("box { <-1, 1, -1>, <1, 1.5, 1>", "<-7, 10, 4> rgb 1 parallel",
	             (7 * 1 + 10 * 4 + 4 * 1) / along);
	check_shadow("sphere { <0, 2, 0>, 1", "<3, 10, 0> rgb 1 parallel", M_PI);
	check_shadow("sphere { 0, 1 scale 1.5 rotate <30, 45, 10>", FAR_POINT, M_PI * 1.5 * 1.5);
	/* One half of it: its box is no longer that of a ball. */
	check_shadow("sphere { 0, 1 clipped_by { plane { x, 0 } }", FAR_POINT, M_PI / 2);
	check_shadow("sphere { 0, 1 clipped_by { plane { z, -0.8 } }", FAR_POINT,
	             acos(0.8) - 0.8 * 0.6);
	check_edges();
	return CHECK_RESULT();
}
