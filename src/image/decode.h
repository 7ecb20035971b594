/*
 * Private to this room: one decoder a format, each from the whole file in memory. A decoder returns
 * NULL and reports for a broken file; sizes come from the file and are never trusted before
 * image_create has seen them.
 */
#ifndef IMAGE_DECODE_H
#define IMAGE_DECODE_H

#include "image/image.h"

typedef struct ImageBytes {
	const char *path; /* for messages */
	const uint8_t *data;
	size_t size, at;  /* at: the next byte */
} ImageBytes;

/* Black, 8 bits, gamma 0. NULL, reported, for sizes of nought or of more than 2^28 pixels, or
 * without memory. */
Image *image_create(int width, int height, int channels, const char *path, Diag *diag);

/* Channels of a picture without and with alpha. */
#define IMAGE_RGB 3
#define IMAGE_RGBA 4

/* Makes it a palette image of count colours (all opaque black) with zero indices. False without
 * memory. */
bool image_set_palette(Image *image, int count);
/* Sets pixels from indices and palette; indices beyond the palette become its last colour. */
void image_expand_palette(Image *image);

/* The whole file, to be released with free; NULL, reported, when it cannot be read. */
uint8_t *image_bytes_load(const char *path, size_t *size, Diag *diag);

/* Past the end: 0. */
uint8_t image_bytes_u8(ImageBytes *bytes);
uint16_t image_bytes_u16le(ImageBytes *bytes);
uint32_t image_bytes_u32le(ImageBytes *bytes);
bool image_bytes_has(const ImageBytes *bytes, size_t count);

Image *image_decode_png(ImageBytes *bytes, Diag *diag);
Image *image_decode_jpeg(ImageBytes *bytes, Diag *diag);
Image *image_decode_tiff(ImageBytes *bytes, Diag *diag);
Image *image_decode_gif(ImageBytes *bytes, Diag *diag);
Image *image_decode_tga(ImageBytes *bytes, Diag *diag);
Image *image_decode_pnm(ImageBytes *bytes, Diag *diag);
Image *image_decode_bmp(ImageBytes *bytes, Diag *diag);
Image *image_decode_exr(ImageBytes *bytes, Diag *diag);
Image *image_decode_hdr(ImageBytes *bytes, Diag *diag);

#endif
