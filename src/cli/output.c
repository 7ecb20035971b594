#include "cli/output.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/path.h"
#include "config.h"
#include "image/exr.h"

/* The length without an extension; names that only start with a dot have none. */
static size_t stem_length(const char *path)
{
	const char *base = path_file_name(path), *dot = strrchr(base, '.');
	return dot && dot > base ? (size_t)(dot - path) : strlen(path);
}

const char *output_scene_name(const Options *options)
{
	if (strcmp(options->input, "-") == 0)
		return "stdin";
	const char *base = path_file_name(options->input);
	return arena_strndup(options->arena, base, stem_length(base));
}

/* The path up to the frame number. Only the format's own extension is taken off, as POV-Ray does.
 */
static const char *output_stem(const Options *options)
{
	const char *said = options->output, *extension = image_format_extension(options->format);
	if (!said && strcmp(options->input, "-") == 0)
		return output_scene_name(options);
	if (!said)
		return arena_strndup(options->arena, options->input, stem_length(options->input));
	size_t length = strlen(said), tail = strlen(extension);
	if (length == 0 || said[length - 1] == '/')
		return arena_printf(options->arena, "%s%s", said, output_scene_name(options));
	if (length > tail && strcmp(said + length - tail, extension) == 0)
		length -= tail;
	else if (said[length - 1] == '.')
		length--;
	return arena_strndup(options->arena, said, length);
}

const char *output_path(const Options *options, const Animation *animation, int frame)
{
	const char *extension = image_format_extension(options->format);
	if (options->output && strcmp(options->output, "-") == 0)
		return options->output;
	const char *stem = output_stem(options);
	if (!animation->active)
		return arena_printf(options->arena, "%s%s", stem, extension);
	return arena_printf(options->arena, "%s%0*d%s", stem, animation->digits, frame, extension);
}

/* The transfer that leads from the scene's working space to linear light. Scenes before version 3.7
 * that say nothing are shown as they compute: their values count as sRGB's. */
static double working_gamma(const Settings *settings)
{
	if (settings->assumed_gamma != 0)
		return settings->assumed_gamma;
	return settings->version < 3.7 ? -1 : 1;
}

/* The film's picture in linear light, not premultiplied. */
static Image linear_image(const Film *film, const Settings *settings)
{
	Image image = {.width = film_width(film),
		       .height = film_height(film),
		       .channels = 4,
		       .linear = true};
	size_t count = (size_t)image.width * image.height;
	double gamma = working_gamma(settings);
	const float *from = film_pixels(film, FILM_COLOR);
	image.pixels = memory_alloc(count * 4 * sizeof *image.pixels);
	for (size_t i = 0; i < count; i++) {
		float alpha = from[4 * i + 3], scale = alpha > 0 && alpha < 1 ? 1 / alpha : 1;
		for (int c = 0; c < 3; c++)
			image.pixels[4 * i + c] = (float)image_transfer_decode(
				from[4 * i + c] * scale, gamma);
		image.pixels[4 * i + 3] = alpha;
	}
	return image;
}

unsigned output_layers(const Options *options, bool photons)
{
	unsigned of_photons = 1u << FILM_DIRECT | 1u << FILM_CAUSTIC | 1u << FILM_PHOTON_COUNT |
	                      1u << FILM_PHOTON_PARAMETER | 1u << FILM_PHOTON_EDGES |
	                      1u << FILM_PHOTON_CONSTRAINT;
	if (options->format != IMAGE_EXR)
		return 1u << FILM_COLOR;
	return ((1u << FILM_LAYER_COUNT) - 1) & ~(photons ? 0 : of_photons);
}

/* Layers' channels are named for what they hold. */
static const char *channel_ending(FilmLayer layer, int channel)
{
	static const char *const colors[] = {"R", "G", "B", "A"}, *const axes[] = {"X", "Y", "Z"};
	return layer == FILM_NORMAL ? axes[channel] : colors[channel];
}

static const char *channel_name(Arena *arena, FilmLayer layer, int channel)
{
	if (layer == FILM_COLOR)
		return channel_ending(layer, channel);
	if (film_layer_channels(layer) == 1)
		return film_layer_name(layer);
	return arena_printf(arena, "%s.%s", film_layer_name(layer), channel_ending(layer, channel));
}

/* The picture as OpenEXR wants it: linear, multiplied by alpha; from the picture not multiplied. */
static void premultiply(Image *image)
{
	size_t count = (size_t)image->width * image->height;
	for (size_t i = 0; i < 4 * count; i++)
		if (i % 4 < 3)
			image->pixels[i] *= image->pixels[i | 3];
}

static bool write_layers(const Options *options, const Film *film, const OutputOrigin *origin,
			 const char *path, Diag *diag)
{
	Arena *arena = arena_create();
	Image color = linear_image(film, origin->settings);
	premultiply(&color);
	ExrChannel channels[FILM_CHANNELS];
	int count = 0;
	for (FilmLayer layer = 0; layer < FILM_LAYER_COUNT; layer++) {
		int width = film_layer_channels(layer);
		const float *pixels = layer == FILM_COLOR ? color.pixels : film_pixels(film, layer);
		for (int c = 0; film_has(film, layer) && c < width; c++) {
			if (layer == FILM_COLOR && c == 3 && !options->alpha)
				continue;
			channels[count++] = (ExrChannel){.name = channel_name(arena, layer, c),
							 .data = (float *)pixels + c,
							 .stride = width,
							 .half = layer != FILM_DEPTH};
		}
	}
	char region[IMAGE_REGION_TEXT];
	image_region_write(&origin->region, region);
	ExrAttribute attributes[8] = {
		{"scene", origin->scene},
		{"seed", arena_printf(arena, "%llu", (unsigned long long)origin->seed)},
		{"passes", arena_printf(arena, "%u", film_passes(film) ? film_passes(film) : 1)},
		{"switches", origin->switches},
		{"software", PACKAGE_STRING},
		{"photons", arena_printf(arena, "%llu", (unsigned long long)film_photons(film))},
		{"radius", arena_printf(arena, "%.9g", origin->passes.radius)},
	};
	int attribute_count = origin->passes.has_photons ? 7
							 : 5; /* the last two are about photons */
	if (image_region_is_part(&origin->region))
		attributes[attribute_count++] = (ExrAttribute){"region", region};
	ExrImage image = {color.width, color.height, count, channels, attribute_count, attributes};
	bool good = exr_write(path, &image, diag);
	free(color.pixels);
	arena_destroy(arena);
	return good;
}

bool output_write(const Options *options, const Film *film, const OutputOrigin *origin,
		  const char *path, Diag *diag)
{
	if (options->format == IMAGE_EXR)
		return write_layers(options, film, origin, path, diag);
	ImageEncoding encoding = {
		.format = options->format,
		.bits = options->bits,
		.alpha = options->alpha,
		.gray = options->gray,
		.dither = options->dither,
		.gamma = options->file_gamma,
		.quality = options->compression,
		.region = origin->region,
	};
	Image image = linear_image(film, origin->settings);
	bool good = image_write(path, &encoding, &image, diag);
	free(image.pixels);
	return good;
}
