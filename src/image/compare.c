/*
 * Measures of difference. SSIM follows Wang, Bovik, Sheikh and Simoncelli, "Image quality
 * assessment: from error visibility to structural similarity" (2004): luma, a Gaussian window of 11
 * x 11 pixels and sigma 1.5, K1 0.01, K2 0.03, dynamic range 1; where the window leaves the picture
 * its weights are renormalised.
 */
#include "image/compare.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/arena.h"
#include "image/decode.h"

#define WINDOW 5 /* pixels to each side */

static int color_channels(const Image *image)
{
	return image->channels > 2 ? 3 : 1;
}

static double value_at(const Image *image, size_t pixel, int channel)
{
	int c = color_channels(image) == 1 ? 0 : channel;
	return image->pixels[pixel * image->channels + c];
}

static double luma_at(const Image *image, size_t pixel)
{
	return 0.299 * value_at(image, pixel, 0) + 0.587 * value_at(image, pixel, 1) +
	       0.114 * value_at(image, pixel, 2);
}

static void compare_values(const Image *image, const Image *reference, ImageDifference *out)
{
	size_t pixels = (size_t)image->width * image->height;
	int channels = color_channels(image) > color_channels(reference)
			       ? 3
			       : color_channels(reference);
	double count = (double)pixels * channels;
	for (size_t i = 0; i < pixels; i++)
		for (int c = 0; c < channels; c++) {
			double a = value_at(image, i, c), b = value_at(reference, i, c), d = a - b;
			double sum = fabs(a) + fabs(b);
			out->mse += d * d / count;
			out->mrse += d * d / (b * b + 1e-2) / count;
			out->smape += sum > 0 ? 2 * fabs(d) / sum / count : 0;
		}
	out->rmse = sqrt(out->mse);
	out->psnr = out->mse > 0 ? -10 * log10(out->mse) : INFINITY;
}

/* Five planes that the Gaussian blurs: a, b, aa, bb, ab. */
enum { PLANE_A, PLANE_B, PLANE_AA, PLANE_BB, PLANE_AB, PLANE_COUNT };

static void fill_planes(const Image *image, const Image *reference, float *planes)
{
	size_t count = (size_t)image->width * image->height;
	for (size_t i = 0; i < count; i++) {
		float a = (float)luma_at(image, i), b = (float)luma_at(reference, i);
		planes[PLANE_A * count + i] = a;
		planes[PLANE_B * count + i] = b;
		planes[PLANE_AA * count + i] = a * a;
		planes[PLANE_BB * count + i] = b * b;
		planes[PLANE_AB * count + i] = a * b;
	}
}

/* Blurs count values that lie step apart, through a copy of length values. */
static void blur_line(float *line, int count, size_t step, float *copy)
{
	for (int i = 0; i < count; i++)
		copy[i] = line[i * step];
	for (int i = 0; i < count; i++) {
		double sum = 0, weights = 0;
		for (int k = -WINDOW; k <= WINDOW; k++) {
			if (i + k < 0 || i + k >= count)
				continue;
			double weight = exp(-k * k / (2 * 1.5 * 1.5));
			sum += weight * copy[i + k];
			weights += weight;
		}
		line[i * step] = (float)(sum / weights);
	}
}

static void blur_plane(float *plane, int width, int height)
{
	float *copy = memory_alloc(sizeof *copy * (size_t)(width > height ? width : height));
	for (int y = 0; y < height; y++)
		blur_line(plane + (size_t)y * width, width, 1, copy);
	for (int x = 0; x < width; x++)
		blur_line(plane + x, height, (size_t)width, copy);
	free(copy);
}

static double structural_similarity(const Image *image, const Image *reference)
{
	const double c1 = 0.01 * 0.01, c2 = 0.03 * 0.03;
	size_t count = (size_t)image->width * image->height;
	float *planes = memory_alloc(count * PLANE_COUNT * sizeof *planes);
	fill_planes(image, reference, planes);
	for (int p = 0; p < PLANE_COUNT; p++)
		blur_plane(planes + p * count, image->width, image->height);
	double sum = 0;
	for (size_t i = 0; i < count; i++) {
		double a = planes[PLANE_A * count + i], b = planes[PLANE_B * count + i];
		double va = planes[PLANE_AA * count + i] - a * a,
		       vb = planes[PLANE_BB * count + i] - b * b;
		double vab = planes[PLANE_AB * count + i] - a * b;
		sum += (2 * a * b + c1) * (2 * vab + c2) / ((a * a + b * b + c1) * (va + vb + c2));
	}
	free(planes);
	return sum / (double)count;
}

bool image_compare(const Image *image, const Image *reference, ImageDifference *out, Diag *diag)
{
	*out = (ImageDifference){0};
	if (image->width != reference->width || image->height != reference->height) {
		diag_fail(diag, "the images differ in size: %d x %d and %d x %d", image->width,
			  image->height, reference->width, reference->height);
		return false;
	}
	compare_values(image, reference, out);
	out->ssim = structural_similarity(image, reference);
	out->dssim = (1 - out->ssim) / 2;
	return true;
}

/* The parts below are made from sound images, so there is nobody to tell about sizes. */
static Image *new_image(int width, int height, const Image *like)
{
	Image *image = memory_alloc(sizeof *image);
	*image = *like;
	image->indices = NULL;
	image->palette = NULL;
	image->palette_count = 0;
	image->width = width;
	image->height = height;
	image->pixels = memory_alloc(
		(size_t)width * height * image->channels * sizeof *image->pixels + 1);
	return image;
}

Image *image_halve(const Image *image)
{
	Image *half = new_image(image->width / 2, image->height / 2, image);
	int channels = image->channels;
	size_t row = (size_t)image->width * channels;
	for (int y = 0; y < half->height; y++)
		for (int x = 0; x < half->width; x++)
			for (int c = 0; c < channels; c++) {
				const float *from = image->pixels + 2 * y * row +
						    2 * (size_t)x * channels + c;
				half->pixels[((size_t)y * half->width + x) * channels + c] =
					(from[0] + from[channels] + from[row] +
					 from[row + channels]) /
					4;
			}
	return half;
}

Image *image_crop(const Image *image, int x, int y, int width, int height)
{
	Image *part = new_image(width, height, image);
	size_t line = (size_t)width * image->channels;
	for (int i = 0; i < height; i++)
		memcpy(part->pixels + line * i,
		       image->pixels + ((size_t)(y + i) * image->width + x) * image->channels,
		       line * sizeof(float));
	return part;
}

/* Black, blue, red, yellow, white at 0, 1/4 ... 1. */
static void false_color(double value, float out[4])
{
	static const float stops[5][3] = {{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {1, 1, 0}, {1, 1, 1}};
	double at = value > 0 ? value < 1 ? value * 4 : 4 : 0;
	int low = at < 4 ? (int)at : 3;
	for (int c = 0; c < 3; c++)
		out[c] = stops[low][c] + (float)(at - low) * (stops[low + 1][c] - stops[low][c]);
	out[3] = 1;
}

Image *image_difference_map(const Image *image, const Image *reference, double scale)
{
	Image like = {.channels = 4, .bits = 8};
	Image *map = new_image(image->width, image->height, &like);
	for (size_t i = 0; i < (size_t)map->width * map->height; i++) {
		double largest = 0;
		for (int c = 0; c < 3; c++)
			largest = fmax(largest,
				       fabs(value_at(image, i, c) - value_at(reference, i, c)));
		false_color(largest / scale, map->pixels + 4 * i);
	}
	return map;
}
