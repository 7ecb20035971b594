/*
 * Writing pictures: PNG, TGA, PPM/PGM, JPEG, BMP from linear light, with the transfer that POV-Ray
 * calls File_Gamma. (OpenEXR with its named layers is image/exr.h.) Files are written beside and
 * renamed; "-" is standard output.
 */
#ifndef IMAGE_WRITE_H
#define IMAGE_WRITE_H

#include "image/image.h"

typedef enum ImageFormat {
	IMAGE_PNG,
	IMAGE_TGA,
	IMAGE_TGA_RLE,
	IMAGE_PPM,
	IMAGE_JPEG,
	IMAGE_BMP,
	IMAGE_EXR,
	IMAGE_FORMAT_COUNT
} ImageFormat;

/* A negative gamma means the sRGB transfer; 0 leaves values as they are. */
typedef struct ImageEncoding {
	ImageFormat format;
	int bits;         /* per channel, 5 to 16; 8 where the format knows nothing else */
	bool alpha;       /* keep the fourth channel, where the format can */
	bool gray;        /* one channel */
	bool dither;      /* Floyd-Steinberg */
	double gamma;     /* of the values in the file */
	int quality;      /* JPEG, 2 to 100 */
	ImageRegion region; /* of a part: PNG names it */
} ImageEncoding;

/* The extension with its dot: ".png". */
const char *image_format_extension(ImageFormat format);

/* pixels: width x height x 4 (R, G, B, alpha, not premultiplied), linear light, rows from the top.
 * False on failure, reported. IMAGE_EXR writes the layer RGBA alone, in linear light. */
bool image_write(const char *path, const ImageEncoding *encoding, const Image *image, Diag *diag);

#endif
