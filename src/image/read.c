#include "image/read.h"

#include <stdlib.h>
#include <string.h>

#include "image/decode.h"

typedef struct Format {
	const char *magic;
	int length;
	Image *(*decode)(ImageBytes *bytes, Diag *diag);
} Format;

static const Format formats[] = {
	{"\x89PNG\r\n\x1a\n", 8, image_decode_png},
	{"\xff\xd8\xff", 3, image_decode_jpeg},
	{"II*\0", 4, image_decode_tiff},
	{"MM\0*", 4, image_decode_tiff},
	{"GIF8", 4, image_decode_gif},
	{"BM", 2, image_decode_bmp},
	{"\x76\x2f\x31\x01", 4, image_decode_exr},
	{"#?", 2, image_decode_hdr},
	{"P1", 2, image_decode_pnm},
	{"P2", 2, image_decode_pnm},
	{"P3", 2, image_decode_pnm},
	{"P4", 2, image_decode_pnm},
	{"P5", 2, image_decode_pnm},
	{"P6", 2, image_decode_pnm},
};

static Image *decode(ImageBytes *bytes, Diag *diag)
{
	for (size_t i = 0; i < sizeof formats / sizeof *formats; i++) {
		const Format *f = &formats[i];
		if (bytes->size >= (size_t)f->length &&
		    memcmp(bytes->data, f->magic, (size_t)f->length) == 0)
			return f->decode(bytes, diag);
	}
	return image_decode_tga(bytes, diag); /* the one format without a mark */
}

Image *image_read(const char *path, Diag *diag)
{
	size_t size = 0;
	uint8_t *data = image_bytes_load(path, &size, diag);
	if (!data)
		return NULL;
	ImageBytes bytes = {.path = path, .data = data, .size = size};
	Image *image = decode(&bytes, diag);
	free(data);
	return image;
}
