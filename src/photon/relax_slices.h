/*
 * Slices of the spectrum. Where a photon of parted light falls depends on its hue as on where it
 * left the light: neighbours must be alike in both, or there is no one map from the light to the
 * surface, and no edge where one hue's light ends. Beyond SJ13, whose light has no hue. And hues
 * are random, so that the noise of parted light is a colour's own; each slice is evened for itself.
 */
#ifndef PHOTON_RELAX_SLICES_H
#define PHOTON_RELAX_SLICES_H

#include <stdint.h>

#include "photon/map.h"

/*
 * The number of the slice that each photon of the map is in: 0 but for parted light. Slices of a
 * kind (photon/group.h) are of equal width, and as many as make a photon's move through its slice,
 * were its hue another, about as long as photons of the slice are apart. The caller frees them.
 */
uint8_t *relax_slices(const PhotonMap *map);

#endif
