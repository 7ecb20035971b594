/*
 * Private to this room: one encoder a format, fed with values that are already transferred, rounded
 * and dithered.
 */
#ifndef IMAGE_ENCODE_H
#define IMAGE_ENCODE_H

#include <stdio.h>

#include "image/write.h"

/* Rows from the top, channels interleaved, 0 .. maximum. */
typedef struct ImageValues {
	int width, height, channels; /* 1, 3 or 4 */
	int bits, maximum;           /* bits of the file's samples: 8 or 16; maximum 2^bits - 1 */
	uint16_t *values;
} ImageValues;

/* Fewer bits than the file's samples are spread over their whole range. Release values with free.
 */
ImageValues image_quantize(const Image *image, const ImageEncoding *encoding, int channels);

typedef bool ImageEncoder(FILE *out, const ImageValues *values, const ImageEncoding *encoding);

/* False when the library or the disk refuses. */
ImageEncoder image_encode_png, image_encode_tga, image_encode_pnm, image_encode_jpeg,
	image_encode_bmp;

#endif
