/* JPEG through libjpeg: grey, RGB and Adobe's inverted CMYK, 8 bits. */
#include <setjmp.h>
#include <stdio.h>
#include <stdlib.h>

#include <jpeglib.h>

#include "base/arena.h"
#include "image/decode.h"
#include "image/encode.h"

typedef struct ErrorHandler {
	struct jpeg_error_mgr manager; /* first: libjpeg hands back a pointer to it */
	jmp_buf back;
	char message[JMSG_LENGTH_MAX];
} ErrorHandler;

static void on_error(j_common_ptr info)
{
	ErrorHandler *handler = (ErrorHandler *)info->err;
	info->err->format_message(info, handler->message);
	longjmp(handler->back, 1);
}

static void on_message(j_common_ptr info)
{
	(void)info;
}

static struct jpeg_error_mgr *handler_init(ErrorHandler *handler)
{
	struct jpeg_error_mgr *manager = jpeg_std_error(&handler->manager);
	manager->error_exit = on_error;
	manager->output_message = on_message;
	return manager;
}

static void convert_row(Image *image, int y, const uint8_t *row, int components)
{
	float *out = image->pixels + (size_t)image->width * image->channels * y;
	for (int x = 0; x < image->width; x++)
		for (int c = 0; c < image->channels; c++) {
			float value = row[x * components + c] / 255.0f;
			if (components == 4)
				value *= row[x * components + 3] / 255.0f;
			out[x * image->channels + c] = value;
		}
}

typedef struct Reading {
	struct jpeg_decompress_struct info;
	ErrorHandler handler;
	Image *image;
	uint8_t *row;
} Reading;

static void read_image(Reading *r, ImageBytes *bytes, Diag *diag)
{
	struct jpeg_decompress_struct *info = &r->info;
	jpeg_mem_src(info, bytes->data, bytes->size);
	jpeg_read_header(info, TRUE);
	jpeg_calc_output_dimensions(info);
	bool gray = info->out_color_components == 1;
	r->image = image_create((int)info->image_width, (int)info->image_height, gray ? 1 : 3,
				bytes->path, diag);
	if (!r->image)
		return;
	jpeg_start_decompress(info);
	r->row = memory_alloc((size_t)info->output_width * info->output_components);
	while (info->output_scanline < info->output_height) {
		int y = (int)info->output_scanline;
		jpeg_read_scanlines(info, &r->row, 1);
		convert_row(r->image, y, r->row, info->output_components);
	}
	jpeg_finish_decompress(info);
}

Image *image_decode_jpeg(ImageBytes *bytes, Diag *diag)
{
	Reading r = {.image = NULL};
	r.info.err = handler_init(&r.handler);
	if (setjmp(r.handler.back)) {
		diag_fail(diag, "%s: broken JPEG: %s", bytes->path, r.handler.message);
		image_destroy(r.image);
		r.image = NULL;
	} else {
		jpeg_create_decompress(&r.info);
		read_image(&r, bytes, diag);
	}
	jpeg_destroy_decompress(&r.info);
	free(r.row);
	return r.image;
}

static void write_image(struct jpeg_compress_struct *info, const ImageValues *v, int quality,
			uint8_t *row)
{
	size_t count = (size_t)v->width * v->channels;
	info->image_width = (JDIMENSION)v->width;
	info->image_height = (JDIMENSION)v->height;
	info->input_components = v->channels;
	info->in_color_space = v->channels == 1 ? JCS_GRAYSCALE : JCS_RGB;
	jpeg_set_defaults(info);
	jpeg_set_quality(info, quality, TRUE);
	for (int c = 0; c < info->num_components; c++)
		info->comp_info[c].h_samp_factor = info->comp_info[c].v_samp_factor = 1;
	jpeg_start_compress(info, TRUE);
	for (int y = 0; y < v->height; y++) {
		for (size_t i = 0; i < count; i++)
			row[i] = (uint8_t)v->values[count * y + i];
		jpeg_write_scanlines(info, &row, 1);
	}
	jpeg_finish_compress(info);
}

bool image_encode_jpeg(FILE *out, const ImageValues *v, const ImageEncoding *encoding)
{
	struct jpeg_compress_struct info = {0};
	ErrorHandler handler;
	info.err = handler_init(&handler);
	uint8_t *row = memory_alloc((size_t)v->width * v->channels);
	volatile bool good = false;
	if (!setjmp(handler.back)) {
		jpeg_create_compress(&info);
		jpeg_stdio_dest(&info, out);
		write_image(&info, v, encoding->quality >= 2 ? encoding->quality : 85, row);
		good = true;
	}
	jpeg_destroy_compress(&info);
	free(row);
	return good;
}
