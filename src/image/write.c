#include "image/write.h"

#include <assert.h>
#include <stdlib.h>

#include "base/arena.h"
#include "base/output_file.h"
#include "image/encode.h"
#include "image/exr.h"

typedef struct Writer {
	const char *extension;
	ImageEncoder *encode; /* NULL: OpenEXR */
	bool alpha, deep;     /* what the format can */
} Writer;

static const Writer writers[IMAGE_FORMAT_COUNT] = {
	[IMAGE_PNG] = {".png", image_encode_png, true, true},
	[IMAGE_TGA] = {".tga", image_encode_tga, true, false},
	[IMAGE_TGA_RLE] = {".tga", image_encode_tga, true, false},
	[IMAGE_PPM] = {".ppm", image_encode_pnm, false, true},
	[IMAGE_JPEG] = {".jpg", image_encode_jpeg, false, false},
	[IMAGE_BMP] = {".bmp", image_encode_bmp, true, false},
	[IMAGE_EXR] = {".exr", NULL, true, true},
};

const char *image_format_extension(ImageFormat format)
{
	return writers[format].extension;
}

/* OpenEXR wants colours multiplied by alpha. */
static float *premultiplied(const Image *image)
{
	size_t count = (size_t)image->width * image->height;
	float *pixels = memory_alloc(count * 4 * sizeof *pixels);
	for (size_t i = 0; i < 4 * count; i++)
		pixels[i] = image->pixels[i] * (i % 4 == 3 ? 1 : image->pixels[i | 3]);
	return pixels;
}

static bool write_exr(const char *path, const ImageEncoding *encoding, const Image *image,
		      Diag *diag)
{
	static const char *const names[] = {"R", "G", "B", "A"};
	ExrChannel channels[4];
	ExrImage exr = {.width = image->width, .height = image->height, .channels = channels};
	exr.channel_count = encoding->alpha ? 4 : 3;
	float *pixels = encoding->alpha ? premultiplied(image) : image->pixels;
	for (int c = 0; c < 4; c++)
		channels[c] = (ExrChannel){
			.name = names[c], .data = pixels + c, .stride = 4, .half = true};
	bool good = exr_write(path, &exr, diag);
	if (encoding->alpha)
		free(pixels);
	return good;
}

bool image_write(const char *path, const ImageEncoding *encoding, const Image *image, Diag *diag)
{
	assert(image->channels == 4);
	const Writer *writer = &writers[encoding->format];
	if (!writer->encode)
		return write_exr(path, encoding, image, diag);
	ImageEncoding real = *encoding;
	if (!writer->deep || real.bits < 1)
		real.bits = 8;
	bool gray = real.gray && encoding->format != IMAGE_BMP;
	int channels = gray ? 1 : real.alpha && writer->alpha ? 4 : 3;
	OutputFile file;
	if (!output_file_open(&file, path, diag))
		return false;
	ImageValues values = image_quantize(image, &real, channels);
	bool good = writer->encode(file.stream, &values, &real);
	free(values.values);
	if (good)
		return output_file_commit(&file, diag);
	diag_fail(diag, "%s: cannot be written", path);
	output_file_abandon(&file);
	return false;
}
