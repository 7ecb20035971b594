/*
 * The sheet of light that photons of one kind sample: they left one light, went the same way and
 * landed on the same object, so that where one lands is a function of its emitter coordinates,
 * smooth almost everywhere.
 */
#ifndef DENSITY_FOOTPRINT_SHEET_H
#define DENSITY_FOOTPRINT_SHEET_H

#include "density/footprint_patch.h"
#include "photon/map.h"

typedef struct Strangers Strangers;

typedef struct SheetTask {
	const PhotonMap *map;
	const uint32_t *photons; /* numbers in the map; along a curve that fills emitter space */
	uint32_t count;
	/* Patches are drawn so much smaller, towards each of their photons: all of them, and in
	 * passes those that do not fit. */
	double scale, shrink;
	/* Of parted light: hues of the photons, 0..1, how the place where one lands changes with
	 * hue, and the slice of hues that the photons are from; else NULL. */
	const float *hues;
	const float (*hue_slopes)[3];
	double hue, hue_width;
	const Strangers *strangers; /* NULL: not looked at */
	const volatile int *stop; /* nonzero: what is made is of no use; NULL: never */
	uint32_t kind;              /* the sheet's, among theirs */
} SheetTask;

/* Adds to; the block is the caller's to free. */
typedef struct PatchList {
	Patch *all;
	uint32_t count, room;
} PatchList;

/* trust[i]: the share of photon i's flux that the patches bring, 0..1. The rest has found no
 * sheet. */
void footprint_sheet(const SheetTask *task, PatchList *patches, float *trust);

/* Of parted light, hue_slopes from the photons of all hues. */
void footprint_sheet_hue_slopes(const SheetTask *task, float (*hue_slopes)[3]);

#endif
