/* Radiance's RGBE pictures, plain and run-length coded, top row first (-Y h +X w). */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/arena.h"
#include "image/decode.h"

/* Takes the next line without its end; false at the end of the file. */
static bool read_line(ImageBytes *bytes, char *line, size_t size)
{
	size_t used = 0;
	if (bytes->at >= bytes->size)
		return false;
	while (bytes->at < bytes->size) {
		char c = (char)image_bytes_u8(bytes);
		if (c == '\n')
			break;
		if (used + 1 < size)
			line[used++] = c;
	}
	line[used] = 0;
	return true;
}

static bool read_size(ImageBytes *bytes, int *width, int *height)
{
	char line[200];
	while (read_line(bytes, line, sizeof line) && line[0])
		; /* the header ends with an empty line */
	return read_line(bytes, line, sizeof line) &&
	       sscanf(line, "-Y %d +X %d", height, width) == 2;
}

/* One component of a run-length coded row. */
static bool read_component(ImageBytes *bytes, uint8_t *out, int width)
{
	for (int x = 0; x < width;) {
		int count = image_bytes_u8(bytes);
		bool run = count > 128;
		count = run ? count - 128 : count;
		if (count == 0 || count > width - x ||
		    !image_bytes_has(bytes, run ? 1 : (size_t)count))
			return false;
		if (run)
			memset(out + x, image_bytes_u8(bytes), (size_t)count);
		for (int k = 0; !run && k < count; k++)
			out[x + k] = image_bytes_u8(bytes);
		x += count;
	}
	return true;
}

static bool row_is_packed(const ImageBytes *bytes, int width)
{
	const uint8_t *at = bytes->data + bytes->at;
	return width >= 8 && width < 32768 && image_bytes_has(bytes, 4) && at[0] == 2 &&
	       at[1] == 2 && (at[2] << 8 | at[3]) == width;
}

static bool read_row(ImageBytes *bytes, uint8_t *planes, int width)
{
	if (row_is_packed(bytes, width)) {
		bytes->at += 4;
		for (int c = 0; c < 4; c++)
			if (!read_component(bytes, planes + (size_t)c * width, width))
				return false;
		return true;
	}
	if (!image_bytes_has(bytes, (size_t)width * 4))
		return false;
	for (int x = 0; x < width; x++)
		for (int c = 0; c < 4; c++)
			planes[(size_t)c * width + x] = image_bytes_u8(bytes);
	return true;
}

static void convert_row(const uint8_t *planes, int width, float *out)
{
	for (int x = 0; x < width; x++) {
		int exponent = planes[3 * (size_t)width + x];
		float scale = exponent ? ldexpf(1, exponent - 136) : 0;
		for (int c = 0; c < 3; c++)
			out[3 * x + c] = planes[(size_t)c * width + x] * scale;
	}
}

Image *image_decode_hdr(ImageBytes *bytes, Diag *diag)
{
	int width = 0, height = 0;
	Image *image = NULL;
	if (read_size(bytes, &width, &height))
		image = image_create(width, height, IMAGE_RGB, bytes->path, diag);
	if (!image) {
		diag_fail(diag, "%s: broken Radiance picture", bytes->path);
		return NULL;
	}
	image->bits = 32;
	image->linear = true;
	uint8_t *planes = memory_alloc((size_t)width * 4);
	bool good = true;
	for (int y = 0; y < height && good; y++) {
		good = read_row(bytes, planes, width);
		if (good)
			convert_row(planes, width, image->pixels + (size_t)y * width * 3);
	}
	free(planes);
	if (!good) {
		diag_fail(diag, "%s: broken Radiance picture: it ends too early", bytes->path);
		image_destroy(image);
		return NULL;
	}
	return image;
}
