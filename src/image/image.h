/* Images in memory: rows from the top, single precision, channels interleaved. */
#ifndef IMAGE_IMAGE_H
#define IMAGE_IMAGE_H

#include <stdbool.h>
#include <stdint.h>

#include "base/diag.h"

/* The pixels of a picture that were rendered: x0 <= x < x1 and so in y. All zero: the whole
 * picture. */
typedef struct ImageRegion {
	int x0, y0, x1, y1;
} ImageRegion;

typedef struct Image {
	int width, height,
		channels; /* 1 grey, 2 grey+alpha, 3 RGB, 4 RGB+alpha (not premultiplied) */
	float *pixels; /* width*height*channels, 0..1 for integer formats */
	uint8_t *indices;            /* palette indices of a palette image, or NULL */
	int palette_count;
	float *palette;              /* palette_count x 4, or NULL */
	int bits;                    /* per channel in the file: 1..16, 32 for floats */
	bool linear; /* the format says its values are linear light (EXR); else sRGB or the file's
			gamma below */
	double gamma; /* the file's own encoding gamma, 0 when it says nothing; negative: sRGB */
	ImageRegion region;          /* as a PNG of ours names it; see image_region_write */
} Image;

/* Channels of a picture without and with alpha. */
#define IMAGE_RGB 3
#define IMAGE_RGBA 4

/* Black, 8 bits, gamma 0. NULL, reported with the path of the file that wants it, for sizes of
 * nought or of more than 2^28 pixels, or without memory. */
Image *image_create(int width, int height, int channels, const char *path, Diag *diag);
void image_destroy(Image *image);

/* Makes it a palette image of count colours (all opaque black) with zero indices. False without
 * memory. */
bool image_set_palette(Image *image, int count);
/* Sets pixels from indices and palette; indices beyond the palette become its last colour. */
void image_expand_palette(Image *image);

/* A region as files name it, "x0 y0 x1 y1": the text PNG keeps under the key Region, OpenEXR under
 * the attribute region. */
enum { IMAGE_REGION_TEXT = 48 };
void image_region_write(const ImageRegion *region, char text[IMAGE_REGION_TEXT]);
ImageRegion image_region_read(const char *text); /* all zero for anything else */
bool image_region_is_part(const ImageRegion *region); /* not all zero */

/* A linear value as a file of that gamma stores it, 0..1, and back. A negative gamma means
 * the sRGB transfer; 0 leaves values as they are. */
double image_transfer_encode(double linear, double gamma);
double image_transfer_decode(double stored, double gamma);

/* Decodes the file's values to linear light in place: by the file's gamma, else by fallback (0:
 * sRGB transfer, 1: none). */
void image_linearize(Image *image, double fallback);

#endif
