#include "image/image.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/arena.h"
#include "image/decode.h"
#include "image/write.h"

#define MAXIMUM_PIXELS (1 << 28)

typedef struct Format {
	const char *magic;
	int length, offset;
	Image *(*decode)(ImageBytes *bytes, Diag *diag);
} Format;

static const Format formats[] = {
	{"\x89PNG\r\n\x1a\n", 8, 0, image_decode_png},
	{"\xff\xd8\xff", 3, 0, image_decode_jpeg},
	{"II*\0", 4, 0, image_decode_tiff},
	{"MM\0*", 4, 0, image_decode_tiff},
	{"GIF8", 4, 0, image_decode_gif},
	{"BM", 2, 0, image_decode_bmp},
	{"\x76\x2f\x31\x01", 4, 0, image_decode_exr},
	{"#?", 2, 0, image_decode_hdr},
	{"P1", 2, 0, image_decode_pnm},
	{"P2", 2, 0, image_decode_pnm},
	{"P3", 2, 0, image_decode_pnm},
	{"P4", 2, 0, image_decode_pnm},
	{"P5", 2, 0, image_decode_pnm},
	{"P6", 2, 0, image_decode_pnm},
};

Image *image_create(int width, int height, int channels, const char *path, Diag *diag)
{
	if (width <= 0 || height <= 0 || (int64_t)width * height > MAXIMUM_PIXELS) {
		diag_fail(diag, "%s: an image of %d x %d pixels cannot be read", path, width,
			  height);
		return NULL;
	}
	Image *image = calloc(1, sizeof *image);
	if (image)
		image->pixels = calloc((size_t)width * height * channels, sizeof *image->pixels);
	if (!image || !image->pixels) {
		diag_fail(diag, "%s: not enough memory for %d x %d pixels", path, width, height);
		free(image);
		return NULL;
	}
	image->width = width;
	image->height = height;
	image->channels = channels;
	image->bits = 8;
	return image;
}

void image_region_write(const ImageRegion *region, char text[IMAGE_REGION_TEXT])
{
	snprintf(text, IMAGE_REGION_TEXT, "%d %d %d %d", region->x0, region->y0, region->x1,
		 region->y1);
}

ImageRegion image_region_read(const char *text)
{
	ImageRegion r = {0};
	if (sscanf(text, "%9d %9d %9d %9d", &r.x0, &r.y0, &r.x1, &r.y1) != 4 || r.x0 < 0 ||
	    r.y0 < 0 || r.x1 < r.x0 || r.y1 < r.y0)
		return (ImageRegion){0};
	return r;
}

bool image_region_is_part(const ImageRegion *region)
{
	return region->x0 || region->y0 || region->x1 || region->y1;
}

void image_destroy(Image *image)
{
	if (!image)
		return;
	free(image->pixels);
	free(image->indices);
	free(image->palette);
	free(image);
}

bool image_set_palette(Image *image, int count)
{
	image->indices = calloc((size_t)image->width * image->height, 1);
	image->palette = calloc((size_t)count * 4, sizeof *image->palette);
	if (!image->indices || !image->palette)
		return false;
	image->palette_count = count;
	for (int i = 0; i < count; i++)
		image->palette[4 * i + 3] = 1;
	return true;
}

void image_expand_palette(Image *image)
{
	size_t count = (size_t)image->width * image->height;
	for (size_t i = 0; i < count; i++) {
		int index = image->indices[i] < image->palette_count ? image->indices[i]
								     : image->palette_count - 1;
		memcpy(image->pixels + i * image->channels, image->palette + 4 * index,
		       sizeof *image->pixels * image->channels);
	}
}

bool image_bytes_has(const ImageBytes *bytes, size_t count)
{
	return bytes->at <= bytes->size && count <= bytes->size - bytes->at;
}

uint8_t image_bytes_u8(ImageBytes *bytes)
{
	return bytes->at < bytes->size ? bytes->data[bytes->at++] : 0;
}

uint16_t image_bytes_u16le(ImageBytes *bytes)
{
	uint16_t low = image_bytes_u8(bytes);
	return (uint16_t)(low | image_bytes_u8(bytes) << 8);
}

uint32_t image_bytes_u32le(ImageBytes *bytes)
{
	uint32_t low = image_bytes_u16le(bytes);
	return low | (uint32_t)image_bytes_u16le(bytes) << 16;
}

/* The whole stream; errno is set when ferror is. */
static uint8_t *read_whole(FILE *file, size_t *size)
{
	size_t used = 0, room = 1 << 16;
	uint8_t *data = memory_alloc(room);
	for (;;) {
		size_t got = fread(data + used, 1, room - used, file);
		used += got;
		if (got == 0)
			break;
		if (used == room)
			data = memory_resize(data, room *= 2);
	}
	*size = used;
	return data;
}

uint8_t *image_bytes_load(const char *path, size_t *size, Diag *diag)
{
	FILE *file = fopen(path, "rb");
	if (!file) {
		diag_fail(diag, "%s: %s", path, strerror(errno));
		return NULL;
	}
	uint8_t *data = read_whole(file, size);
	if (ferror(file)) {
		diag_fail(diag, "%s: %s", path, strerror(errno));
		free(data);
		data = NULL;
	}
	fclose(file);
	return data;
}

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

double image_transfer_decode(double stored, double gamma)
{
	if (gamma == 0 || gamma == 1)
		return stored;
	if (gamma > 0)
		return stored > 0 ? pow(stored, gamma) : stored;
	return stored <= 0.04045 ? stored / 12.92 : pow((stored + 0.055) / 1.055, 2.4);
}

double image_transfer_encode(double linear, double gamma)
{
	if (gamma == 0 || gamma == 1)
		return linear;
	if (gamma > 0)
		return linear > 0 ? pow(linear, 1 / gamma) : linear;
	return linear <= 0.0031308 ? linear * 12.92 : 1.055 * pow(linear, 1 / 2.4) - 0.055;
}

/* The colour channels of count pixels; alpha is linear in every format. */
static void decode_values(float *values, size_t count, int channels, double gamma)
{
	int colors = channels > 2 ? 3 : 1;
	for (size_t i = 0; i < count; i++)
		for (int c = 0; c < colors; c++) {
			float *v = &values[i * channels + c];
			*v = (float)image_transfer_decode(*v, gamma);
		}
}

void image_linearize(Image *image, double fallback)
{
	double gamma = image->gamma != 0 ? image->gamma : fallback != 0 ? fallback : -1;
	if (image->linear)
		return;
	decode_values(image->pixels, (size_t)image->width * image->height, image->channels, gamma);
	if (image->palette)
		decode_values(image->palette, (size_t)image->palette_count, 4, gamma);
	image->linear = true;
}
