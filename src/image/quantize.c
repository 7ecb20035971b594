/* From linear light to the whole numbers of a file: transfer, rounding, dithering (Floyd and
 * Steinberg 1976). */
#include <math.h>
#include <stdlib.h>

#include "base/arena.h"
#include "image/encode.h"

typedef struct Quantizer {
	const Image *image;
	const ImageEncoding *encoding;
	int levels;        /* highest value of the asked bits */
	ImageValues *out;
	double *error[2]; /* rounding errors handed to this row and the next, channels interleaved;
			     NULL without dither */
} Quantizer;

static double stored_value(const Quantizer *q, const float *pixel, int channel)
{
	double value = pixel[channel];
	if (q->out->channels == 1)
		value = 0.297 * pixel[0] + 0.589 * pixel[1] + 0.114 * pixel[2];
	value = value > 0 ? value < 1 ? value : 1 : 0; /* not a number becomes 0 */
	return channel == 3 ? value : image_transfer_encode(value, q->encoding->gamma);
}

/* Hands the rounding error on: 7/16 right, 3/16 5/16 1/16 below. */
static void spread(Quantizer *q, int x, int channel, double error)
{
	int width = q->out->width, channels = q->out->channels;
	if (x + 1 < width) {
		q->error[0][(x + 1) * channels + channel] += error * 7 / 16;
		q->error[1][(x + 1) * channels + channel] += error / 16;
	}
	if (x > 0)
		q->error[1][(x - 1) * channels + channel] += error * 3 / 16;
	q->error[1][x * channels + channel] += error * 5 / 16;
}

static int round_value(Quantizer *q, double value, int x, int channel)
{
	double scaled = value * q->levels;
	if (q->error[0])
		scaled += q->error[0][x * q->out->channels + channel];
	int rounded = (int)floor(scaled + 0.5);
	rounded = rounded < 0 ? 0 : rounded > q->levels ? q->levels : rounded;
	if (q->error[0])
		spread(q, x, channel, scaled - rounded);
	return q->levels == q->out->maximum
		       ? rounded
		       : (int)floor((double)rounded * q->out->maximum / q->levels + 0.5);
}

static void next_row(Quantizer *q)
{
	double *done = q->error[0];
	if (!done)
		return;
	q->error[0] = q->error[1];
	q->error[1] = done;
	for (int i = 0; i < q->out->width * q->out->channels; i++)
		done[i] = 0;
}

ImageValues image_quantize(const Image *image, const ImageEncoding *encoding, int channels)
{
	ImageValues out = {.width = image->width, .height = image->height, .channels = channels};
	size_t row = (size_t)out.width * channels;
	out.bits = encoding->bits > 8 ? 16 : 8;
	out.maximum = (1 << out.bits) - 1;
	out.values = memory_alloc(row * out.height * sizeof *out.values);
	Quantizer q = {.image = image,
		       .encoding = encoding,
		       .levels = (1 << encoding->bits) - 1,
		       .out = &out};
	for (int i = 0; i < 2 && encoding->dither; i++) {
		q.error[i] = memory_alloc(row * sizeof **q.error);
		for (size_t k = 0; k < row; k++)
			q.error[i][k] = 0;
	}
	for (int y = 0; y < out.height; y++, next_row(&q))
		for (int x = 0; x < out.width; x++) {
			const float *pixel = image->pixels + ((size_t)y * out.width + x) * 4;
			for (int c = 0; c < channels; c++)
				out.values[row * y + (size_t)x * channels + c] =
					(uint16_t)round_value(&q, stored_value(&q, pixel, c), x, c);
		}
	free(q.error[0]);
	free(q.error[1]);
	return out;
}
