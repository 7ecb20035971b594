/*
 * Where a sheet of light ends near a photon: at the edge of what bends the light or of what it
 * falls on, in the shadow of something, at a crease. There is no light beyond, so a kernel is cut
 * there, and what would pass over is mirrored back (the reflection method of kernel density
 * estimation, Schuster 1985): an even sheet stays even up to its border, and no light is lost.
 */
#ifndef DENSITY_FOOTPRINT_BORDER_H
#define DENSITY_FOOTPRINT_BORDER_H

#include "density/footprint_fit.h"

enum { MOST_BORDERS = 2 };

/* A half plane of the parameters relative to the photon: the sheet is where toward . d < distance;
 * toward is unit. */
typedef struct Border { double toward[2], distance; } Border;

/* The neighbours around the photon, and what is known of them. */
typedef struct BorderSearch {
	const FitSample *samples;
	int count;
	double window; /* radius within which every neighbour is among the samples */
	double share;  /* area of a photon's share */
} BorderSearch;

/* Returns how many. */
int footprint_borders(const BorderSearch *search, Border out[MOST_BORDERS]);

#endif
