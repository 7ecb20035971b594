/*
 * Light that glass has parted: each photon has one hue, at random. Where a sheet goes is a function
 * of emitter coordinates and hue; so the spectrum is cut into slices, each with a sheet of its own
 * (footprint_parts.c), and red and violet neighbours make no coloured noise.
 */
#ifndef DENSITY_FOOTPRINT_HUE_H
#define DENSITY_FOOTPRINT_HUE_H

#include <stdbool.h>

#include "base/color.h"

enum { FOOTPRINT_HUES = 64 };

/* The spectrum: colours evenly spaced from red to violet, white on the average. */
typedef struct FootprintHues { Rgb color[FOOTPRINT_HUES]; } FootprintHues;

FootprintHues footprint_hues(void);
/* The number of the colour nearest to a flux; the sheet's flux at its place is 1. */
int footprint_hue_of(const FootprintHues *hues, Rgb flux);
/* Whether this flux is of one hue. */
bool footprint_hue_is_pure(Rgb flux);

#endif
