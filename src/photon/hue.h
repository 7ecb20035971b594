/*
 * Light that glass has parted: each photon has one hue, at random, and lands where that takes it.
 * Photons do not keep their hue; their colour tells it.
 */
#ifndef PHOTON_HUE_H
#define PHOTON_HUE_H

#include <stdbool.h>
#include <stdint.h>

#include "photon/map.h"

/*
 * Both look at photons of one kind, those near one another where they left the light near one
 * another in the array of their numbers, as photon_group_kinds puts them (photon/group.h).
 */

/* Whether the photons have hues: strongly coloured ones, red and violet. Looks at some. */
bool photon_hue_parts(const PhotonMap *map, const uint32_t *photons, uint32_t count);
/* The hue of each photon of parted light, 0 (red) to 1 (violet), evenly distributed. */
void photon_hue_find(const PhotonMap *map, const uint32_t *photons, uint32_t count, float *hues);

#endif
