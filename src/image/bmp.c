/* BMP: 1, 4, 8, 24 and 32 bits, uncompressed (also with the usual bit fields); no run-length
 * coding. */
#include <stdlib.h>

#include "image/decode.h"
#include "image/encode.h"

#define HEADER_SIZE 54

typedef struct Header {
	uint32_t data_at, size, compression;
	int width, height, bits, colors;
	bool from_top;
} Header;

static Header read_header(ImageBytes *bytes)
{
	Header h = {0};
	bytes->at = 10;
	h.data_at = image_bytes_u32le(bytes);
	h.size = image_bytes_u32le(bytes);
	int64_t width = (int32_t)image_bytes_u32le(bytes),
		height = (int32_t)image_bytes_u32le(bytes);
	h.from_top = height < 0;
	h.width = width > 0 && width <= INT32_MAX ? (int)width : 0;
	height = height < 0 ? -height : height;
	h.height = height <= INT32_MAX ? (int)height : 0;
	bytes->at += 2;
	h.bits = image_bytes_u16le(bytes);
	h.compression = image_bytes_u32le(bytes);
	bytes->at += 12;
	h.colors = (int)(image_bytes_u32le(bytes) & 0xffff);
	return h;
}

static bool header_is_sound(const Header *h, const ImageBytes *bytes)
{
	bool depth = h->bits == 1 || h->bits == 4 || h->bits == 8 || h->bits == 24 || h->bits == 32;
	bool plain = h->compression == 0 || (h->compression == 3 && h->bits == 32);
	return depth && plain && h->size >= 40 && h->data_at < bytes->size;
}

static bool read_palette(ImageBytes *bytes, const Header *h, Image *image)
{
	int count = h->colors > 0 && h->colors <= 256 ? h->colors : 1 << h->bits;
	if (!image_set_palette(image, count))
		return false;
	bytes->at = 14 + (size_t)h->size;
	for (int i = 0; i < count; i++) {
		for (int c = 2; c >= 0; c--)
			image->palette[4 * i + c] = image_bytes_u8(bytes) / 255.0f;
		bytes->at++;
	}
	return true;
}

static void read_row(const uint8_t *row, const Header *h, Image *image, int y)
{
	size_t at = (size_t)y * image->width;
	for (int x = 0; x < image->width; x++) {
		if (image->indices) {
			int bit = x * h->bits, shift = 8 - h->bits - bit % 8;
			image->indices[at + x] = (uint8_t)(row[bit / 8] >> shift &
							   ((1 << h->bits) - 1));
			continue;
		}
		const uint8_t *pixel = row + x * (h->bits / 8);
		for (int c = 0; c < 3; c++)
			image->pixels[(at + x) * image->channels + c] = pixel[2 - c] / 255.0f;
		if (image->channels == IMAGE_RGBA)
			image->pixels[(at + x) * 4 + 3] = pixel[3] / 255.0f;
	}
}

static bool read_rows(ImageBytes *bytes, const Header *h, Image *image)
{
	size_t stride = ((size_t)h->width * h->bits + 31) / 32 * 4;
	bytes->at = h->data_at;
	for (int i = 0; i < image->height; i++, bytes->at += stride) {
		if (!image_bytes_has(bytes, stride))
			return false;
		read_row(bytes->data + bytes->at, h, image,
			 h->from_top ? i : image->height - 1 - i);
	}
	if (image->indices)
		image_expand_palette(image);
	return true;
}

/* 32-bit files mostly leave the fourth byte 0 and mean an opaque picture. */
static void drop_empty_alpha(Image *image)
{
	size_t count = (size_t)image->width * image->height;
	for (size_t i = 0; i < count; i++)
		if (image->pixels[4 * i + 3] > 0)
			return;
	for (size_t i = 0; i < count; i++)
		image->pixels[4 * i + 3] = 1;
}

Image *image_decode_bmp(ImageBytes *bytes, Diag *diag)
{
	Header h = read_header(bytes);
	if (!header_is_sound(&h, bytes)) {
		diag_fail(diag, "%s: broken BMP, or of a kind that cannot be read", bytes->path);
		return NULL;
	}
	Image *image = image_create(h.width, h.height, h.bits == 32 ? 4 : 3, bytes->path, diag);
	if (!image)
		return NULL;
	if ((h.bits <= 8 && !read_palette(bytes, &h, image)) || !read_rows(bytes, &h, image)) {
		diag_fail(diag, "%s: broken BMP: it ends too early", bytes->path);
		image_destroy(image);
		return NULL;
	}
	if (image->channels == IMAGE_RGBA)
		drop_empty_alpha(image);
	return image;
}

static void put(FILE *out, uint64_t value, int bytes)
{
	for (int i = 0; i < bytes; i++)
		putc(i < 8 ? (int)(value >> 8 * i & 255) : 0, out);
}

static void put_header(FILE *out, const ImageValues *v, size_t stride)
{
	uint32_t data = (uint32_t)(stride * (size_t)v->height);
	fputs("BM", out);
	put(out, HEADER_SIZE + data, 4);
	put(out, 0, 4);
	put(out, HEADER_SIZE, 4);
	put(out, 40, 4);
	put(out, (uint32_t)v->width, 4);
	put(out, (uint32_t)v->height, 4);
	put(out, 1, 2);
	put(out, (uint32_t)(8 * v->channels), 2);
	put(out, 0, 4);
	put(out, data, 4);
	put(out, 0, 16); /* resolution and numbers of colours: not said */
}

bool image_encode_bmp(FILE *out, const ImageValues *v, const ImageEncoding *encoding)
{
	(void)encoding;
	size_t used = (size_t)v->width * v->channels, stride = (used + 3) / 4 * 4;
	put_header(out, v, stride);
	for (int y = v->height - 1; y >= 0; y--) {
		const uint16_t *row = v->values + used * y;
		for (int x = 0; x < v->width; x++, row += v->channels) {
			for (int c = 2; c >= 0; c--)
				putc(row[c], out);
			if (v->channels == IMAGE_RGBA)
				putc(row[3], out);
		}
		for (size_t pad = used; pad < stride; pad++)
			putc(0, out);
	}
	return !ferror(out);
}
