#include "image/image.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define MAXIMUM_PIXELS (1 << 28)

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
