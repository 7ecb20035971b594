#include "image/layer.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "image/write.h"

enum { COLORS = 3, CHANNELS = 4, LONGEST_NAME = 256 };

static const char COLOR_LAYER[] = "RGBA", CAUSTIC_LAYER[] = "caustic";

/* ---- layers by name ---- */

static int find_channels(const ExrImage *exr, const char *layer, const ExrChannel *found[COLORS])
{
	static const char *const endings[] = {"R", "G", "B", "X", "Y", "Z", "V"};
	bool colors = strcmp(layer, COLOR_LAYER) == 0;
	int count = 0;
	for (size_t i = 0; i < sizeof endings / sizeof *endings && count < COLORS; i++) {
		char name[LONGEST_NAME];
		snprintf(name, sizeof name, "%s%s%s", colors ? "" : layer, colors ? "" : ".",
			 endings[i]);
		const ExrChannel *channel = exr_find(exr, name);
		if (channel)
			found[count++] = channel;
	}
	if (count == 0 && exr_find(exr, layer))
		found[count++] = exr_find(exr, layer);
	return count;
}

static Image *new_image(int width, int height, int channels)
{
	Image *image = memory_alloc(sizeof *image);
	*image = (Image){.width = width, .height = height, .channels = channels};
	image->pixels = memory_alloc(sizeof(float) * ((size_t)width * height * channels + 1));
	return image;
}

static size_t pixel_count(const Image *image) { return (size_t)image->width * image->height; }

Image *layer_extract(const ExrImage *exr, const char *layer)
{
	const ExrChannel *found[COLORS];
	int count = find_channels(exr, layer, found);
	if (count == 0)
		return NULL;
	Image *image = new_image(exr->width, exr->height, count < COLORS ? 1 : COLORS);
	image->linear = true;
	for (size_t i = 0; i < pixel_count(image); i++)
		for (int c = 0; c < image->channels; c++)
			image->pixels[i * image->channels + c] =
				found[c]->data[i * found[c]->stride];
	return image;
}

/* A channel's name without its ending, where that is one letter that tells a component. */
static const char *layer_of(const char *channel, Arena *arena)
{
	const char *dot = strrchr(channel, '.');
	if (!dot && strlen(channel) == 1 && strchr("RGBAY", *channel))
		return COLOR_LAYER;
	return dot && strlen(dot) == 2 ? arena_strndup(arena, channel, (size_t)(dot - channel))
				       : channel;
}

int layer_names(const ExrImage *exr, const char ***names, Arena *arena)
{
	const char **all = ARENA_ARRAY(arena, const char *, exr->channel_count + 1);
	int count = 0;
	for (int i = 0; i < exr->channel_count; i++) {
		const char *name = layer_of(exr->channels[i].name, arena);
		bool known = false;
		for (int k = 0; k < count; k++)
			known = known || strcmp(all[k], name) == 0;
		if (!known)
			all[count++] = name;
	}
	*names = all;
	return count;
}

bool layer_bounds(const Image *layer, double *least, double *most)
{
	*least = INFINITY;
	*most = -INFINITY;
	for (size_t i = 0; i < pixel_count(layer) * layer->channels; i++) {
		double value = layer->pixels[i];
		if (isfinite(value)) {
			*least = fmin(*least, value);
			*most = fmax(*most, value);
		}
	}
	return *least <= *most;
}

/* ---- layers as pictures ---- */

typedef struct Drawing {
	const Image *layer;
	const Image *light; /* what shades it, or NULL */
	double least, most, exposure;
	double middle[COLORS], spread[COLORS]; /* of layers of colours that are no light */
} Drawing;

static double unit(double value) { return value > 0 ? value < 1 ? value : 1 : 0; }

static double shown(double light) { return image_transfer_encode(unit(light), -1); }

/* Blue, cyan, green, yellow, red: as bright everywhere, so that shading stays readable. */
static void number_color(double at, double out[COLORS])
{
	static const double stops[5][COLORS] = {{0.25, 0.35, 0.95}, {0.10, 0.75, 0.90},
						{0.30, 0.85, 0.30}, {0.98, 0.85, 0.20},
						{0.95, 0.25, 0.15}};
	double place = 4 * unit(at);
	int low = place < 4 ? (int)place : 3;
	for (int c = 0; c < COLORS; c++)
		out[c] = stops[low][c] + (place - low) * (stops[low + 1][c] - stops[low][c]);
}

static double light_at(const Drawing *drawing, size_t i)
{
	if (!drawing->light)
		return 1;
	const float *l = drawing->light->pixels + COLORS * i;
	return 0.2126 * l[0] + 0.7152 * l[1] + 0.0722 * l[2];
}

/* How bright the pixel's light makes it, as stored. */
static double shade(const Drawing *drawing, size_t i)
{
	return shown(drawing->exposure * light_at(drawing, i));
}

typedef void DrawPixel(const Drawing *drawing, size_t i, double out[COLORS]);

static void draw_light(const Drawing *drawing, size_t i, double out[COLORS])
{
	for (int c = 0; c < COLORS; c++)
		out[c] = shown(drawing->exposure * drawing->layer->pixels[COLORS * i + c]);
}

static void draw_normal(const Drawing *drawing, size_t i, double out[COLORS])
{
	for (int c = 0; c < COLORS; c++)
		out[c] = 0.5 + 0.5 * drawing->layer->pixels[COLORS * i + c];
}

/* All zero where there are no photons. */
static bool has_color(const Image *layer, size_t i)
{
	const float *p = layer->pixels + COLORS * i;
	return p[0] != 0 || p[1] != 0 || p[2] != 0;
}

/*
 * Mean and standard deviation of each channel where there is light, by how much: photons of one
 * lamp may leave it in a narrow cone, whose colours would hardly differ. A channel that hardly
 * changes beside the others is spread less, not to show noise.
 */
static void find_spread(Drawing *drawing)
{
	double weight = 0, sum[COLORS] = {0}, squares[COLORS] = {0}, widest = 0;
	for (size_t i = 0; i < pixel_count(drawing->layer); i++) {
		double w = has_color(drawing->layer, i) ? fmax(light_at(drawing, i), 0) : 0;
		weight += w;
		for (int c = 0; c < COLORS; c++) {
			double value = drawing->layer->pixels[COLORS * i + c];
			sum[c] += w * value;
			squares[c] += w * value * value;
		}
	}
	for (int c = 0; c < COLORS && weight > 0; c++) {
		drawing->middle[c] = sum[c] / weight;
		double variance = squares[c] / weight - drawing->middle[c] * drawing->middle[c];
		drawing->spread[c] = sqrt(fmax(variance, 0));
		widest = fmax(widest, drawing->spread[c]);
	}
	for (int c = 0; c < COLORS; c++)
		drawing->spread[c] = fmax(drawing->spread[c], fmax(widest / 4, 1e-6));
}

/* Two standard deviations to each side fill the scale. */
static void draw_spread(const Drawing *drawing, size_t i, double out[COLORS])
{
	double brightness = has_color(drawing->layer, i) ? shade(drawing, i) : 0;
	for (int c = 0; c < COLORS; c++) {
		double value = drawing->layer->pixels[COLORS * i + c] - drawing->middle[c];
		out[c] = brightness * unit(0.5 + value / (4 * drawing->spread[c]));
	}
}

static void draw_number(const Drawing *drawing, size_t i, double out[COLORS])
{
	double value = drawing->layer->pixels[i], range = drawing->most - drawing->least;
	number_color(range > 0 ? (value - drawing->least) / range : 0, out);
	for (int c = 0; c < COLORS; c++)
		out[c] = isfinite(value) ? out[c] : 0;
}

/* Black where there are none. */
static void draw_photons(const Drawing *drawing, size_t i, double out[COLORS])
{
	double brightness = drawing->layer->pixels[i] > 0 ? shade(drawing, i) : 0;
	draw_number(drawing, i, out);
	for (int c = 0; c < COLORS; c++)
		out[c] *= brightness;
}

/* Grey light, red where it is held. */
static void draw_held(const Drawing *drawing, size_t i, double out[COLORS])
{
	static const double red[COLORS] = {1, 0.06, 0.04};
	double held = unit(drawing->layer->pixels[i]), gray = shade(drawing, i);
	for (int c = 0; c < COLORS; c++)
		out[c] = gray * (1 - held + held * red[c]);
}

/* How a layer is drawn, by its name; numbers and light are known by their channels. */
static DrawPixel *find_draw(const char *layer, const Image *image)
{
	static const struct { const char *name; DrawPixel *draw; int channels; } rows[] = {
		{"N", draw_normal, COLORS},
		{"photons.parameter", draw_spread, COLORS},
		{"photons.count", draw_photons, 1},
		{"photons.edges", draw_photons, 1},
		{"photons.constraint", draw_held, 1},
	};
	for (size_t i = 0; i < sizeof rows / sizeof *rows; i++)
		if (strcmp(rows[i].name, layer) == 0 && image->channels == rows[i].channels)
			return rows[i].draw;
	return image->channels == 1 ? draw_number : draw_light;
}

static Image *draw(const Drawing *drawing, DrawPixel *draw_pixel)
{
	Image *image = new_image(drawing->layer->width, drawing->layer->height, CHANNELS);
	for (size_t i = 0; i < pixel_count(image); i++) {
		double color[COLORS];
		draw_pixel(drawing, i, color);
		for (int c = 0; c < COLORS; c++)
			image->pixels[CHANNELS * i + c] = (float)unit(color[c]);
		image->pixels[CHANNELS * i + COLORS] = 1;
	}
	return image;
}

static bool is_of_photons(const char *layer) { return strncmp(layer, "photons.", 8) == 0; }

Image *layer_draw(const ExrImage *exr, const char *layer, const LayerView *view)
{
	Image *image = layer_extract(exr, layer), *light = NULL;
	if (!image)
		return NULL;
	if (is_of_photons(layer) && !view->unlit)
		light = layer_extract(exr, CAUSTIC_LAYER);
	Drawing drawing = {.layer = image,
			   .light = light && light->channels == COLORS ? light : NULL,
			   .least = view->least,
			   .most = view->most,
			   .exposure = view->exposure};
	if (drawing.least >= drawing.most)
		layer_bounds(image, &drawing.least, &drawing.most);
	DrawPixel *draw_pixel = find_draw(layer, image);
	if (draw_pixel == draw_spread)
		find_spread(&drawing);
	Image *drawn = draw(&drawing, draw_pixel);
	image_destroy(image);
	image_destroy(light);
	return drawn;
}
