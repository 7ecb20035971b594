/*
 * OpenEXR through OpenEXRCore: any set of named float channels in one part, "caustic.R" being
 * channel R of the layer caustic, with text attributes in the header. Values are linear and go
 * through unchanged (half where asked).
 */
#ifndef IMAGE_EXR_H
#define IMAGE_EXR_H

#include "base/diag.h"

typedef struct ExrChannel {
	const char *name;  /* "R", "caustic.G", "photons.count.Y", "Z" */
	float *data;       /* the first pixel's value */
	int stride;        /* floats from one pixel to the next */
	bool half;         /* stored as half */
} ExrChannel;

typedef struct ExrAttribute {
	const char *name, *text;
} ExrAttribute;

/* Rows from the top, width pixels each. Whoever fills it owns the memory, but see exr_read. */
typedef struct ExrImage {
	int width, height;
	int channel_count; ExrChannel *channels;
	int attribute_count; const ExrAttribute *attributes;
} ExrImage;

/* ZIP-compressed scan lines, written beside and renamed; "-" is standard output. False on failure,
 * reported. */
bool exr_write(const char *path, const ExrImage *image, Diag *diag);

/* Every channel of the first part (tiled or scan lines, half, float or unsigned), stride 1; no
 * attributes but strings. NULL on failure, reported. Release with exr_destroy, which frees the data
 * as well. */
ExrImage *exr_read(const char *path, Diag *diag);
void exr_destroy(ExrImage *image);

/* The channel of that name, or NULL. */
const ExrChannel *exr_find(const ExrImage *image, const char *name);

#endif
