/* The portable pixmaps P1 to P6, 1 to 16 bits, as text and binary; written as P5 and P6. */
#include <ctype.h>

#include "image/decode.h"
#include "image/encode.h"

static void skip_space(ImageBytes *bytes)
{
	while (bytes->at < bytes->size) {
		int c = bytes->data[bytes->at];
		if (c == '#')
			while (bytes->at < bytes->size && bytes->data[bytes->at] != '\n')
				bytes->at++;
		else if (isspace(c))
			bytes->at++;
		else
			return;
	}
}

/* -1 where no number stands. */
static int read_number(ImageBytes *bytes)
{
	skip_space(bytes);
	int value = -1;
	while (bytes->at < bytes->size && isdigit(bytes->data[bytes->at]) && value < 100000000)
		value = (value < 0 ? 0 : value) * 10 + (bytes->data[bytes->at++] - '0');
	return value;
}

/* P1 may run its digits together. */
static int read_text_bit(ImageBytes *bytes)
{
	skip_space(bytes);
	int c = image_bytes_u8(bytes);
	return c == '0' ? 1 : c == '1' ? 0 : -1;
}

static int read_binary(ImageBytes *bytes, int maximum)
{
	if (!image_bytes_has(bytes, maximum > 255 ? 2 : 1))
		return -1;
	int high = image_bytes_u8(bytes);
	return maximum > 255 ? high << 8 | image_bytes_u8(bytes) : high;
}

static bool read_packed_bits(ImageBytes *bytes, Image *image)
{
	for (int y = 0; y < image->height; y++)
		for (int x = 0; x < image->width; x++) {
			if (x % 8 == 0 && !image_bytes_has(bytes, 1))
				return false;
			int byte = x % 8 == 0 ? image_bytes_u8(bytes) : bytes->data[bytes->at - 1];
			image->pixels[(size_t)y * image->width + x] = (byte >> (7 - x % 8) & 1) ? 0
												: 1;
		}
	return true;
}

static bool read_values(ImageBytes *bytes, int kind, int maximum, Image *image)
{
	if (kind == 4)
		return read_packed_bits(bytes, image);
	size_t count = (size_t)image->width * image->height * image->channels;
	for (size_t i = 0; i < count; i++) {
		int value = kind == 1   ? read_text_bit(bytes)
			    : kind <= 3 ? read_number(bytes)
					: read_binary(bytes, maximum);
		if (value < 0)
			return false;
		image->pixels[i] = (float)value / maximum;
	}
	return true;
}

Image *image_decode_pnm(ImageBytes *bytes, Diag *diag)
{
	int kind = bytes->data[1] - '0';
	bytes->at = 2;
	int width = read_number(bytes), height = read_number(bytes);
	int maximum = kind == 1 || kind == 4 ? 1 : read_number(bytes);
	if (maximum < 1 || maximum > 65535) {
		diag_fail(diag, "%s: broken portable pixmap", bytes->path);
		return NULL;
	}
	if (kind >= 4)
		bytes->at++; /* the one space before the data */
	Image *image = image_create(width, height, kind == 3 || kind == 6 ? 3 : 1, bytes->path,
				    diag);
	if (!image)
		return NULL;
	image->bits = maximum > 255 ? 16 : maximum > 1 ? 8 : 1;
	if (!read_values(bytes, kind, maximum, image)) {
		diag_fail(diag, "%s: broken portable pixmap: it ends too early", bytes->path);
		image_destroy(image);
		return NULL;
	}
	return image;
}

bool image_encode_pnm(FILE *out, const ImageValues *v, const ImageEncoding *encoding)
{
	(void)encoding;
	size_t count = (size_t)v->width * v->height * v->channels;
	fprintf(out, "P%d\n%d %d\n%d\n", v->channels == 1 ? 5 : 6, v->width, v->height, v->maximum);
	for (size_t i = 0; i < count; i++) {
		if (v->bits == 16)
			putc(v->values[i] >> 8, out);
		putc(v->values[i] & 255, out);
	}
	return !ferror(out);
}
