/*
 * TIFF through libtiff: 16-bit integers and 32-bit floats as they are where samples lie side by
 * side in strips; everything else (palettes, YCbCr, tiles, planes) through libtiff's own conversion
 * to 8-bit RGBA.
 */
#include <stdlib.h>
#include <string.h>
#include <tiffio.h>

#include "base/arena.h"
#include "image/decode.h"

static tmsize_t read_bytes(thandle_t handle, void *out, tmsize_t count)
{
	ImageBytes *bytes = handle;
	size_t left = bytes->at < bytes->size ? bytes->size - bytes->at : 0;
	size_t take = (size_t)count < left ? (size_t)count : left;
	memcpy(out, bytes->data + bytes->at, take);
	bytes->at += take;
	return (tmsize_t)take;
}

static tmsize_t refuse_write(thandle_t handle, void *data, tmsize_t count)
{
	(void)handle;
	(void)data;
	(void)count;
	return -1;
}

static toff_t seek(thandle_t handle, toff_t offset, int whence)
{
	ImageBytes *bytes = handle;
	toff_t base = whence == SEEK_SET ? 0 : whence == SEEK_CUR ? bytes->at : bytes->size;
	bytes->at = (size_t)(base + offset) <= bytes->size ? (size_t)(base + offset) : bytes->size;
	return bytes->at;
}

static int close_nothing(thandle_t handle)
{
	(void)handle;
	return 0;
}

static toff_t size_of(thandle_t handle)
{
	return ((ImageBytes *)handle)->size;
}

static float sample_value(const uint8_t *row, size_t index, int bits)
{
	if (bits == 16) {
		uint16_t value;
		memcpy(&value, row + 2 * index, sizeof value);
		return value / 65535.0f;
	}
	float value;
	memcpy(&value, row + 4 * index, sizeof value);
	return value;
}

/* Reads deep samples; false where libtiff finds the file broken. */
static bool read_deep(TIFF *tiff, Image *image, int bits, int samples)
{
	uint8_t *row = memory_alloc((size_t)TIFFScanlineSize(tiff) + 16);
	bool good = true;
	for (int y = 0; y < image->height && good; y++) {
		good = TIFFReadScanline(tiff, row, (uint32_t)y, 0) > 0;
		float *out = image->pixels + (size_t)y * image->width * image->channels;
		for (int x = 0; x < image->width && good; x++)
			for (int c = 0; c < image->channels; c++)
				out[x * image->channels + c] = sample_value(
					row, (size_t)x * samples + c, bits);
	}
	free(row);
	return good;
}

static bool read_plain(TIFF *tiff, Image *image)
{
	size_t count = (size_t)image->width * image->height;
	uint32_t *packed = memory_alloc(count * sizeof *packed);
	bool good = TIFFReadRGBAImageOriented(tiff, (uint32_t)image->width, (uint32_t)image->height,
					      packed, ORIENTATION_TOPLEFT, 1) != 0;
	for (size_t i = 0; i < count && good; i++) {
		float alpha = TIFFGetA(packed[i]) / 255.0f,
		      scale = alpha > 0 ? 1 / (255 * alpha) : 0;
		float *out = image->pixels + 4 * i;
		out[0] = TIFFGetR(packed[i]) * scale;
		out[1] = TIFFGetG(packed[i]) * scale;
		out[2] = TIFFGetB(packed[i]) * scale;
		out[3] = alpha;
	}
	free(packed);
	return good;
}

typedef struct Layout {
	uint32_t width, height;
	uint16_t bits, samples, planar, photometric, kind;
	bool deep;
} Layout;

static Layout layout_of(TIFF *tiff)
{
	Layout l = {0};
	TIFFGetField(tiff, TIFFTAG_IMAGEWIDTH, &l.width);
	TIFFGetField(tiff, TIFFTAG_IMAGELENGTH, &l.height);
	TIFFGetFieldDefaulted(tiff, TIFFTAG_BITSPERSAMPLE, &l.bits);
	TIFFGetFieldDefaulted(tiff, TIFFTAG_SAMPLESPERPIXEL, &l.samples);
	TIFFGetFieldDefaulted(tiff, TIFFTAG_PLANARCONFIG, &l.planar);
	TIFFGetFieldDefaulted(tiff, TIFFTAG_SAMPLEFORMAT, &l.kind);
	TIFFGetField(tiff, TIFFTAG_PHOTOMETRIC, &l.photometric);
	bool plain = l.photometric == PHOTOMETRIC_RGB || l.photometric == PHOTOMETRIC_MINISBLACK;
	bool depth = (l.bits == 16 && l.kind == SAMPLEFORMAT_UINT) ||
		     (l.bits == 32 && l.kind == SAMPLEFORMAT_IEEEFP);
	l.deep = depth && plain && l.samples >= 1 && l.samples <= 4 && !TIFFIsTiled(tiff) &&
	         (l.planar == PLANARCONFIG_CONTIG || l.samples == 1);
	return l;
}

static Image *read_image(TIFF *tiff, const char *path, Diag *diag)
{
	Layout l = layout_of(tiff);
	if (l.width > INT32_MAX || l.height > INT32_MAX)
		l.width = l.height = 0;
	Image *image = image_create((int)l.width, (int)l.height, l.deep ? l.samples : 4, path,
				    diag);
	if (!image)
		return NULL;
	image->bits = l.deep ? l.bits : 8;
	image->linear = l.deep && l.bits == 32;
	if (l.deep ? read_deep(tiff, image, l.bits, l.samples) : read_plain(tiff, image))
		return image;
	diag_fail(diag, "%s: broken TIFF", path);
	image_destroy(image);
	return NULL;
}

Image *image_decode_tiff(ImageBytes *bytes, Diag *diag)
{
	TIFFSetErrorHandler(NULL);
	TIFFSetWarningHandler(NULL);
	TIFF *tiff = TIFFClientOpen(bytes->path, "rm", bytes, read_bytes, refuse_write, seek,
				    close_nothing, size_of, NULL, NULL);
	if (!tiff) {
		diag_fail(diag, "%s: broken TIFF", bytes->path);
		return NULL;
	}
	Image *image = read_image(tiff, bytes->path, diag);
	TIFFClose(tiff);
	return image;
}
