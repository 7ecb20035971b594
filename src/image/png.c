/* PNG through libpng. Errors inside libpng come back by longjmp; everything that must be released
 * lives in a struct. */
#include <png.h>
#include <setjmp.h>
#include <stdlib.h>
#include <string.h>

#include "base/arena.h"
#include "image/decode.h"
#include "image/encode.h"

typedef struct Reading {
	ImageBytes *bytes;
	Diag *diag;
	png_structp png;
	png_infop info;
	uint8_t *rows;
	png_bytep *row_pointers;
	Image *image;
} Reading;

static void read_bytes(png_structp png, png_bytep out, size_t count)
{
	ImageBytes *bytes = png_get_io_ptr(png);
	if (!image_bytes_has(bytes, count))
		png_error(png, "the file ends too early");
	memcpy(out, bytes->data + bytes->at, count);
	bytes->at += count;
}

static void on_error(png_structp png, png_const_charp message)
{
	Reading *r = png_get_error_ptr(png);
	diag_fail(r->diag, "%s: broken PNG: %s", r->bytes->path, message);
	png_longjmp(png, 1);
}

static void on_warning(png_structp png, png_const_charp message)
{
	(void)png;
	(void)message;
}

static void read_gamma(Reading *r)
{
	double stored;
	int intent;
	if (png_get_sRGB(r->png, r->info, &intent))
		r->image->gamma = -1;
	else if (png_get_gAMA(r->png, r->info, &stored) && stored > 0)
		r->image->gamma = 1 / stored;
}

static void read_region(Reading *r)
{
	png_textp texts = NULL;
	int count = 0;
	png_get_text(r->png, r->info, &texts, &count);
	for (int i = 0; i < count; i++)
		if (strcmp(texts[i].key, "Region") == 0 && texts[i].text)
			r->image->region = image_region_read(texts[i].text);
}

static void read_palette(Reading *r)
{
	png_colorp colors = NULL;
	png_bytep alpha = NULL;
	int count = 0, alpha_count = 0;
	png_get_PLTE(r->png, r->info, &colors, &count);
	png_get_tRNS(r->png, r->info, &alpha, &alpha_count, NULL);
	if (count <= 0 || !image_set_palette(r->image, count))
		png_error(r->png, "no palette");
	for (int i = 0; i < count; i++) {
		float *entry = r->image->palette + 4 * i;
		entry[0] = colors[i].red / 255.0f;
		entry[1] = colors[i].green / 255.0f;
		entry[2] = colors[i].blue / 255.0f;
		entry[3] = i < alpha_count ? alpha[i] / 255.0f : 1;
	}
}

static void read_rows(Reading *r)
{
	int height = (int)png_get_image_height(r->png, r->info);
	size_t stride = png_get_rowbytes(r->png, r->info);
	r->rows = calloc((size_t)height, stride);
	r->row_pointers = calloc((size_t)height, sizeof *r->row_pointers);
	if (!r->rows || !r->row_pointers)
		png_error(r->png, "not enough memory");
	for (int y = 0; y < height; y++)
		r->row_pointers[y] = r->rows + stride * y;
	png_read_image(r->png, r->row_pointers);
}

static void convert_rows(Reading *r)
{
	Image *image = r->image;
	size_t count = (size_t)image->width * image->height * image->channels;
	if (image->indices) {
		memcpy(image->indices, r->rows, (size_t)image->width * image->height);
		image_expand_palette(image);
		return;
	}
	for (size_t i = 0; i < count; i++)
		image->pixels[i] = image->bits == 16
					   ? (r->rows[2 * i] << 8 | r->rows[2 * i + 1]) / 65535.0f
					   : r->rows[i] / 255.0f;
}

static void read_image(Reading *r)
{
	png_read_info(r->png, r->info);
	int type = png_get_color_type(r->png, r->info), depth = png_get_bit_depth(r->png, r->info);
	bool palette = type == PNG_COLOR_TYPE_PALETTE;
	bool alpha = png_get_valid(r->png, r->info, PNG_INFO_tRNS) || (type & PNG_COLOR_MASK_ALPHA);
	if (palette)
		png_set_packing(r->png);
	else
		png_set_expand(r->png);
	png_set_interlace_handling(r->png);
	png_read_update_info(r->png, r->info);
	int channels = palette ? IMAGE_RGB + alpha : png_get_channels(r->png, r->info);
	r->image = image_create((int)png_get_image_width(r->png, r->info),
				(int)png_get_image_height(r->png, r->info), channels,
				r->bytes->path, r->diag);
	if (!r->image)
		png_longjmp(r->png, 1);
	r->image->bits = depth;
	read_gamma(r);
	read_region(r);
	if (palette)
		read_palette(r);
	read_rows(r);
	convert_rows(r);
}

Image *image_decode_png(ImageBytes *bytes, Diag *diag)
{
	Reading r = {.bytes = bytes, .diag = diag};
	r.png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &r, on_error, on_warning);
	r.info = r.png ? png_create_info_struct(r.png) : NULL;
	bool good = false;
	if (r.info && !setjmp(png_jmpbuf(r.png))) {
		png_set_read_fn(r.png, bytes, read_bytes);
		read_image(&r);
		good = true;
	}
	png_destroy_read_struct(&r.png, &r.info, NULL);
	free(r.rows);
	free(r.row_pointers);
	if (good)
		return r.image;
	image_destroy(r.image);
	return NULL;
}

static void silent_error(png_structp png, png_const_charp message)
{
	(void)message;
	png_longjmp(png, 1);
}

static void write_header(png_structp png, png_infop info, const ImageValues *v,
			 const ImageEncoding *encoding)
{
	int type = v->channels == 1 ? PNG_COLOR_TYPE_GRAY
	         : v->channels == IMAGE_RGBA ? PNG_COLOR_TYPE_RGB_ALPHA : PNG_COLOR_TYPE_RGB;
	png_set_IHDR(png, info, (png_uint_32)v->width, (png_uint_32)v->height, v->bits, type,
		     PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
	if (encoding->gamma < 0)
		png_set_sRGB_gAMA_and_cHRM(png, info, PNG_sRGB_INTENT_PERCEPTUAL);
	else if (encoding->gamma > 0)
		png_set_gAMA(png, info, 1 / encoding->gamma);
	png_byte bits = (png_byte)encoding->bits;
	png_color_8 significant = {bits, bits, bits, bits, bits};
	png_set_sBIT(png, info, &significant);
	char region[IMAGE_REGION_TEXT];
	image_region_write(&encoding->region, region);
	png_text texts[] = {
		{.compression = PNG_TEXT_COMPRESSION_NONE,
		 .key = (char *)"Software",
		 .text = (char *)"cognac"},
		{.compression = PNG_TEXT_COMPRESSION_NONE, .key = (char *)"Region", .text = region},
	};
	png_set_text(png, info, texts, image_region_is_part(&encoding->region) ? 2 : 1);
	png_write_info(png, info);
}

static void write_rows(png_structp png, const ImageValues *v, uint8_t *row)
{
	size_t count = (size_t)v->width * v->channels;
	for (int y = 0; y < v->height; y++) {
		const uint16_t *values = v->values + count * y;
		for (size_t i = 0; i < count; i++) {
			if (v->bits == 16) {
				row[2 * i] = (uint8_t)(values[i] >> 8);
				row[2 * i + 1] = (uint8_t)values[i];
			} else {
				row[i] = (uint8_t)values[i];
			}
		}
		png_write_row(png, row);
	}
}

bool image_encode_png(FILE *out, const ImageValues *v, const ImageEncoding *encoding)
{
	png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, NULL, silent_error,
						  on_warning);
	png_infop info = png ? png_create_info_struct(png) : NULL;
	uint8_t *row = memory_alloc((size_t)v->width * v->channels * 2);
	volatile bool good = false;
	if (info && !setjmp(png_jmpbuf(png))) {
		png_init_io(png, out);
		write_header(png, info, v, encoding);
		write_rows(png, v, row);
		png_write_end(png, info);
		good = true;
	}
	png_destroy_write_struct(&png, &info);
	free(row);
	return good;
}
