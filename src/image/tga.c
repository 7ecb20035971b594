/* TGA (Truevision 2.0): palette, true colour and grey, plain and run-length coded; 8, 15, 16, 24
 * and 32 bits. */
#include <stdlib.h>

#include "image/decode.h"
#include "image/encode.h"

enum { KIND_PALETTE = 1, KIND_COLOR = 2, KIND_GRAY = 3, KIND_RLE = 8 };
enum { FROM_RIGHT = 0x10, FROM_TOP = 0x20 };

typedef struct Header {
	int id_length, has_map, kind;
	int map_first, map_count, map_bits;
	int width, height, bits, flags;
} Header;

static Header read_header(ImageBytes *bytes)
{
	Header h;
	h.id_length = image_bytes_u8(bytes);
	h.has_map = image_bytes_u8(bytes);
	h.kind = image_bytes_u8(bytes);
	h.map_first = image_bytes_u16le(bytes);
	h.map_count = image_bytes_u16le(bytes);
	h.map_bits = image_bytes_u8(bytes);
	bytes->at += 4; /* where the picture stands on a screen */
	h.width = image_bytes_u16le(bytes);
	h.height = image_bytes_u16le(bytes);
	h.bits = image_bytes_u8(bytes);
	h.flags = image_bytes_u8(bytes);
	return h;
}

static bool bits_are_known(int bits)
{
	return bits == 15 || bits == 16 || bits == 24 || bits == 32;
}

static bool header_is_sound(const Header *h)
{
	int plain = h->kind & ~KIND_RLE;
	if (plain == KIND_PALETTE)
		return h->has_map == 1 && h->bits == 8 && h->map_count > 0 &&
		       bits_are_known(h->map_bits);
	if (plain == KIND_COLOR)
		return bits_are_known(h->bits);
	return plain == KIND_GRAY && h->bits == 8;
}

/* One colour of 15 to 32 bits, blue first in the file. */
static void read_color(ImageBytes *bytes, int bits, float out[4])
{
	out[3] = 1;
	if (bits <= 16) {
		unsigned value = image_bytes_u16le(bytes);
		out[0] = (value >> 10 & 31) / 31.0f;
		out[1] = (value >> 5 & 31) / 31.0f;
		out[2] = (value & 31) / 31.0f;
		return;
	}
	for (int c = 2; c >= 0; c--)
		out[c] = image_bytes_u8(bytes) / 255.0f;
	if (bits == 32)
		out[3] = image_bytes_u8(bytes) / 255.0f;
}

/* One pixel: an index, a grey or a colour. */
static void read_pixel(ImageBytes *bytes, const Header *h, float out[4], uint8_t *index)
{
	if (h->bits == 8) {
		*index = image_bytes_u8(bytes);
		out[0] = *index / 255.0f;
	} else {
		read_color(bytes, h->bits, out);
	}
}

static void store_pixel(Image *image, const Header *h, size_t i, const float value[4],
			uint8_t index)
{
	int x = (int)(i % (size_t)image->width), y = (int)(i / (size_t)image->width);
	if (h->flags & FROM_RIGHT)
		x = image->width - 1 - x;
	if (!(h->flags & FROM_TOP))
		y = image->height - 1 - y;
	size_t at = (size_t)y * image->width + x;
	if (image->indices)
		image->indices[at] = index;
	for (int c = 0; c < image->channels; c++)
		image->pixels[at * image->channels + c] = value[c];
}

/* False when the file ends before the picture does. */
static bool read_pixels(ImageBytes *bytes, const Header *h, Image *image)
{
	size_t total = (size_t)image->width * image->height;
	for (size_t i = 0; i < total;) {
		if (!image_bytes_has(bytes, 1))
			return false;
		int packet = h->kind & KIND_RLE ? image_bytes_u8(bytes) : 127;
		int count = (packet & 127) + 1;
		float value[4];
		uint8_t index = 0;
		for (int k = 0; k < count && i < total; k++, i++) {
			if (k == 0 || !(packet & 128))
				read_pixel(bytes, h, value, &index);
			store_pixel(image, h, i, value, index);
		}
	}
	return true;
}

static bool read_palette(ImageBytes *bytes, const Header *h, Image *image)
{
	int count = h->map_first + h->map_count;
	if (count > 256 || !image_set_palette(image, count))
		return false;
	for (int i = h->map_first; i < count; i++)
		read_color(bytes, h->map_bits, image->palette + 4 * i);
	return true;
}

Image *image_decode_tga(ImageBytes *bytes, Diag *diag)
{
	Header h = read_header(bytes);
	if (bytes->size < 18 || !header_is_sound(&h)) {
		diag_fail(diag, "%s: not a picture in a format that can be read", bytes->path);
		return NULL;
	}
	int channels = (h.kind & ~KIND_RLE) == KIND_GRAY ? 1
		       : h.bits == 32                    ? IMAGE_RGBA
							 : IMAGE_RGB;
	Image *image = image_create(h.width, h.height, channels, bytes->path, diag);
	if (!image)
		return NULL;
	bytes->at += (size_t)h.id_length;
	bool palette = (h.kind & ~KIND_RLE) == KIND_PALETTE;
	bool good = !palette || read_palette(bytes, &h, image);
	if (good && !palette && h.has_map)
		bytes->at += (size_t)h.map_count * (size_t)((h.map_bits + 7) / 8);
	good = good && read_pixels(bytes, &h, image);
	if (good && palette)
		image_expand_palette(image);
	if (!good) {
		diag_fail(diag, "%s: broken TGA", bytes->path);
		image_destroy(image);
		return NULL;
	}
	return image;
}

static void put_u16(FILE *out, int value)
{
	putc(value & 255, out);
	putc(value >> 8 & 255, out);
}

static void put_pixel(FILE *out, const uint16_t *pixel, int channels)
{
	if (channels == 1) {
		putc(pixel[0], out);
		return;
	}
	for (int c = 2; c >= 0; c--)
		putc(pixel[c], out);
	if (channels == IMAGE_RGBA)
		putc(pixel[3], out);
}

static bool pixels_equal(const uint16_t *a, const uint16_t *b, int channels)
{
	for (int c = 0; c < channels; c++)
		if (a[c] != b[c])
			return false;
	return true;
}

/* Packets of up to 128 pixels: all the same, or each its own. Packets end with the row. */
static void put_row_packed(FILE *out, const uint16_t *row, int width, int channels)
{
	for (int x = 0; x < width;) {
		int run = 1, lone = 1;
		while (x + run < width && run < 128 &&
		       pixels_equal(row + x * channels, row + (x + run) * channels, channels))
			run++;
		while (run == 1 && x + lone < width && lone < 128 &&
		       !pixels_equal(row + (x + lone - 1) * channels, row + (x + lone) * channels,
				     channels))
			lone++;
		int count = run > 1 ? run : lone;
		putc((run > 1 ? 128 : 0) | (count - 1), out);
		for (int k = 0; k < (run > 1 ? 1 : count); k++)
			put_pixel(out, row + (x + k) * channels, channels);
		x += count;
	}
}

bool image_encode_tga(FILE *out, const ImageValues *v, const ImageEncoding *encoding)
{
	bool packed = encoding->format == IMAGE_TGA_RLE;
	int kind = (v->channels == 1 ? KIND_GRAY : KIND_COLOR) | (packed ? KIND_RLE : 0);
	if (v->width > 65535 || v->height > 65535)
		return false;
	putc(0, out);
	putc(0, out);
	putc(kind, out);
	for (int i = 0; i < 9; i++)
		putc(0, out);
	put_u16(out, v->width);
	put_u16(out, v->height);
	putc(8 * v->channels, out);
	putc(FROM_TOP | (v->channels == IMAGE_RGBA ? 8 : 0), out);
	for (int y = 0; y < v->height; y++) {
		const uint16_t *row = v->values + (size_t)y * v->width * v->channels;
		if (packed)
			put_row_packed(out, row, v->width, v->channels);
		else
			for (int x = 0; x < v->width; x++)
				put_pixel(out, row + x * v->channels, v->channels);
	}
	return !ferror(out);
}
