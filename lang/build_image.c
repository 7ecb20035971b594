#include "lang/build_image.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "image/read.h"
#include "lang/build_pattern.h"
#include "lang/files.h"

/* ---- from the file to linear light in the scene's working space ---- */

/* assumed_gamma of the scene: 1 is linear; 0: the old way, files are taken as they are. */
static double working_gamma(const Context *context)
{
	double gamma = context->builder->settings.assumed_gamma;
	if (gamma == 0)
		return build_version_before(context, 3.7) ? 0 : 1;
	return gamma;
}

static float encode(float x, double gamma)
{
	if (gamma < 0)
		return x <= 0.0031308f ? 12.92f * x : 1.055f * powf(x, 1 / 2.4f) - 0.055f;
	return x > 0 ? powf(x, (float)(1 / gamma)) : x;
}

static void encode_channels(float *values, size_t count, int channels, double gamma)
{
	int colors = channels >= 3 ? 3 : 1;
	for (size_t i = 0; i < count; i++)
		for (int c = 0; c < colors; c++)
			values[i * (size_t)channels + (size_t)c] = encode(
				values[i * (size_t)channels + (size_t)c], gamma);
}

/* Linear light to a working space that is not linear. */
static void image_encode(Image *image, double gamma)
{
	if (image->pixels)
		encode_channels(image->pixels, (size_t)image->width * (size_t)image->height,
				image->channels, gamma);
	if (image->palette)
		encode_channels(image->palette, (size_t)image->palette_count, 4, gamma);
}

/* What a block says about its file's values. */
typedef struct ImageGamma {
	bool given;
	double gamma;    /* negative: sRGB */
	double fallback; /* for a file that says nothing: 0 sRGB, 1 linear */
} ImageGamma;

static void decode(const Context *context, Image *image, Word kind, ImageGamma file)
{
	double working = working_gamma(context);
	bool data = kind != W_image_map;
	if (file.given) {
		image->linear = false;
		image->gamma = file.gamma;
	}
	if ((data || working == 0) && !file.given)
		return;
	image_linearize(image, file.fallback);
	if (!data && working != 1 && working != 0)
		image_encode(image, working);
}

/* ---- the block ---- */

static const float *copy_floats(Arena *arena, const float *values, size_t count)
{
	return values ? arena_copy(arena, values, count * sizeof *values) : NULL;
}

static void fill_raster(Arena *arena, ImageMap *map, const Image *image)
{
	size_t pixels = (size_t)image->width * (size_t)image->height;
	map->width = image->width;
	map->height = image->height;
	map->channels = image->channels;
	map->pixels = copy_floats(arena, image->pixels, pixels * (size_t)image->channels);
	map->indices = image->indices ? arena_copy(arena, image->indices, pixels) : NULL;
	map->palette_count = image->palette_count;
	map->palette = copy_floats(arena, image->palette, (size_t)image->palette_count * 4);
}

static Image *read_image(Context *context, const char *name, Location where)
{
	const char *path = files_find(context, name);
	if (!path) {
		diag_error(context->diag, where, "no image file '%s'", name);
		return NULL;
	}
	if (!files_may_read(context, path, where))
		return NULL;
	Image *image = image_read(path, context->diag);
	if (!image)
		diag_error(context->diag, where, "cannot use the image file '%s'", name);
	return image;
}

static bool is_image_type(Word word)
{
	switch (word) {
	case W_exr:
	case W_gif:
	case W_hdr:
	case W_iff:
	case W_jpeg:
	case W_pgm:
	case W_png:
	case W_pot:
	case W_ppm:
	case W_sys:
	case W_tga: case W_tiff: case W_bmp:
		return true;
	default:
		return false;
	}
}

/* gamma G, gamma srgb */
static void take_gamma(Cursor *inside, ImageGamma *file)
{
	file->given = true;
	file->gamma = -1;
	if (cursor_accept_word(inside, W_srgb))
		return;
	if (cursor_take_float(inside, &file->gamma) && file->gamma <= 0) {
		diag_error(inside->context->diag, inside->last->where, "a gamma is more than 0");
		file->gamma = 1;
	}
}

/* Below 0 stands for all colours, as in POV-Ray. */
static bool has_color(Cursor *inside, const ImageMap *map, Location where, int number)
{
	if (map->palette_count == 0)
		diag_error(inside->context->diag, where,
			   "the image has no palette: 'all' is meant, or another image");
	else if (number >= map->palette_count)
		diag_error(inside->context->diag, where,
			   "the image has no colour %d, its palette goes from 0 to %d", number,
			   map->palette_count - 1);
	return number < map->palette_count;
}

/* filter all F, transmit N, F: into the whole map or one palette entry. */
static void take_clear(Cursor *inside, ImageMap *map, bool filter)
{
	double amount = 0;
	int index = -1;
	Location where = cursor_where(inside);
	bool all = cursor_accept_word(inside, W_all);
	if ((!all && !cursor_take_int(inside, &index)) || !cursor_take_float(inside, &amount))
		return;
	if (!all && !has_color(inside, map, where, index))
		return;
	const float **entries = filter ? &map->palette_filter : &map->palette_transmit;
	if (index < 0) {
		*(filter ? &map->filter_all : &map->transmit_all) = (float)amount;
		return;
	}
	float *copy = arena_alloc(inside->context->builder->arena,
				  sizeof *copy * (size_t)map->palette_count);
	for (int i = 0; i < map->palette_count; i++)
		copy[i] = *entries ? (*entries)[i] : 0;
	copy[index] = (float)amount;
	*entries = copy;
}

static void take_map_type(Cursor *inside, ImageMap *map)
{
	int type = 0;
	if (!cursor_take_int(inside, &type))
		return;
	if (type == 0 || type == 1 || type == 2 || type == 5 || type == 7)
		map->mapping = (ImageMapping)type;
	else
		diag_error(inside->context->diag, inside->last->where, "there is no map_type %d",
			   type);
}

static void take_interpolate(Cursor *inside, ImageMap *map)
{
	int type = 0;
	if (!cursor_take_int(inside, &type))
		return;
	if (type >= 2 && type <= 4)
		map->interpolation = (ImageInterpolation)type;
	else
		diag_error(inside->context->diag, inside->last->where, "there is no interpolate %d",
			   type);
}

/* One modifier behind the file's name; false when none is next. */
static bool take_image_modifier(Cursor *inside, ImageMap *map, double *bump_size)
{
	Word word = cursor_peek_word(inside);
	switch (word) {
	case W_map_type:
	case W_interpolate:
	case W_once:
	case W_filter:
	case W_transmit:
	case W_use_color:
	case W_use_colour:
	case W_use_index:
	case W_use_alpha:
	case W_bump_size:
	case W_offset:
	case W_premultiplied:
		cursor_next(inside);
		break;
	default:
		return false;
	}
	switch (word) {
	case W_map_type: take_map_type(inside, map); break;
	case W_interpolate: take_interpolate(inside, map); break;
	case W_once: map->once = true; break;
	case W_filter: take_clear(inside, map, true); break;
	case W_transmit: take_clear(inside, map, false); break;
	case W_use_index: map->use_color = false; break;
	case W_use_alpha: map->use_alpha = true; break;
	case W_bump_size: cursor_take_float(inside, bump_size); break;
	case W_offset: cursor_take_vec2(inside, &map->offset); break;
	case W_premultiplied: cursor_optional_bool(inside); break;
	default: map->use_color = true;
	}
	return true;
}

/* POV-Ray takes PPM, PGM and TIFF for linear light when they do not say otherwise, all other kinds
 * for sRGB. */
static double fallback_gamma(Word type, const char *name)
{
	const char *suffix = strrchr(name, '.');
	if (type != W_NONE || !suffix)
		return type == W_ppm || type == W_pgm || type == W_tiff;
	return !strcasecmp(suffix, ".ppm") || !strcasecmp(suffix, ".pgm") ||
	       !strncasecmp(suffix, ".tif", 4);
}

/* [type] "name" [gamma G] */
static Image *take_file(Cursor *inside, Word kind)
{
	Context *context = inside->context;
	const char *name = NULL;
	Word type = cursor_peek_word(inside);
	if (is_image_type(type))
		cursor_next(inside);
	else
		type = W_NONE;
	Location where = cursor_where(inside);
	if (!cursor_take_string(inside, &name))
		return NULL;
	ImageGamma file = {false, 0, fallback_gamma(type, name)};
	if (cursor_accept_word(inside, W_gamma))
		take_gamma(inside, &file);
	Image *image = read_image(context, name, where);
	if (image)
		decode(context, image, kind, file);
	return image;
}

/* The raster; false after a reported error. */
static bool take_raster(Cursor *inside, Word kind, ImageMap *map)
{
	const Node *function = cursor_accept_block(inside, W_function);
	if (function)
		return build_function_image(inside->context, function, map);
	Image *image = take_file(inside, kind);
	if (!image)
		return false;
	fill_raster(inside->context->builder->arena, map, image);
	image_destroy(image);
	return true;
}

const ImageMap *build_image(Cursor *inside, Word kind, double *bump_size)
{
	ImageMap *map = ARENA_NEW(inside->context->builder->arena, ImageMap);
	map->use_color = kind != W_material_map;
	/* Old scenes put modifiers before the file. */
	while (take_image_modifier(inside, map, bump_size))
		;
	bool read = take_raster(inside, kind, map);
	while (take_image_modifier(inside, map, bump_size))
		;
	return read ? map : NULL;
}

/* ---- density files ---- */

static uint8_t *read_bytes(FILE *file, size_t *length)
{
	size_t capacity = 1 << 16;
	uint8_t *bytes = memory_alloc(capacity);
	*length = 0;
	size_t got;
	while ((got = fread(bytes + *length, 1, capacity - *length, file)) > 0) {
		*length += got;
		if (*length == capacity)
			bytes = memory_resize(bytes, capacity *= 2);
	}
	return bytes;
}

const DensityData *build_density_file(Cursor *cursor)
{
	Context *context = cursor->context;
	const char *name = NULL;
	Location where = cursor_where(cursor);
	if (!cursor_take_string(cursor, &name))
		return NULL;
	const char *path = files_find(context, name);
	FILE *file = path && files_may_read(context, path, where) ? fopen(path, "rb") : NULL;
	if (!file) {
		diag_error(context->diag, where, "cannot open the density file '%s'", name);
		return NULL;
	}
	size_t length = 0;
	uint8_t *bytes = read_bytes(file, &length);
	fclose(file);
	const DensityData *data = density_parse(context->builder->arena, bytes, length);
	free(bytes);
	if (!data)
		diag_error(context->diag, where, "'%s' is not a df3 file", name);
	return data;
}
