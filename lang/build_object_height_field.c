/* height_field { }: heights from an image file or a function. */
#include <math.h>

#include "geom/height_field.h"
#include "image/read.h"
#include "lang/build_object.h"
#include "lang/files.h"
#include "surface/function_natives.h"

enum { RESOLUTION_MAX = 16384 };

/* The words before a file name say its type; the file's content says it better, but for Fractint's
 * pot: true for that. */
static bool accept_type(Cursor *cursor)
{
	static const Word types[] = {W_exr, W_gif, W_hdr, W_iff, W_jpeg, W_pgm, W_png,
				     W_pot, W_ppm, W_sys, W_tga, W_tiff, W_bmp};
	for (size_t i = 0; i < sizeof types / sizeof *types; i++)
		if (cursor_accept_word(cursor, types[i]))
			return types[i] == W_pot;
	return false;
}

/* A palette image holds heights as indices, a grey one as its values; a colour one in its red
 * (high) and green (low) bytes. */
static float pixel_height(const Image *image, size_t pixel)
{
	if (image->indices)
		return (float)(image->indices[pixel] / 255.0);
	const float *channel = image->pixels + pixel * (size_t)image->channels;
	if (image->channels < 3 || image->bits > 8)
		return channel[0];
	return (float)((round(channel[0] * 255.0) * 256 + round(channel[1] * 255.0)) / 65535);
}

/* The image's lowest row lies at z = 0. */
static const float *image_heights(Arena *arena, const Image *image)
{
	size_t width = (size_t)image->width, depth = (size_t)image->height;
	float *heights = arena_alloc(arena, width * depth * sizeof *heights);
	for (size_t z = 0; z < depth; z++)
		for (size_t x = 0; x < width; x++)
			heights[z * width + x] = pixel_height(image, (depth - 1 - z) * width + x);
	return heights;
}

/* A pot file is a GIF whose left half holds the high bytes, its right half the low ones. */
static const float *pot_heights(Arena *arena, const Image *image)
{
	size_t width = (size_t)image->width / 2, depth = (size_t)image->height;
	float *heights = arena_alloc(arena, width * depth * sizeof *heights);
	for (size_t z = 0; z < depth; z++) {
		const uint8_t *row = image->indices + (depth - 1 - z) * (size_t)image->width;
		for (size_t x = 0; x < width; x++)
			heights[z * width + x] = (float)((row[x] * 256 + row[x + width]) / 65535.0);
	}
	return heights;
}

/* gamma number, gamma srgb, premultiplied on: after the file's name. */
static void read_image_words(Cursor *cursor, Image *image)
{
	for (;;) {
		if (cursor_accept_word(cursor, W_premultiplied)) {
			cursor_optional_bool(cursor);
		} else if (cursor_accept_word(cursor, W_gamma)) {
			double gamma = 0;
			if (!cursor_accept_word(cursor, W_srgb))
				cursor_take_float(cursor, &gamma);
			if (image) {
				image->gamma = 0;
				image_linearize(image, gamma);
			}
		} else {
			return;
		}
	}
}

static bool read_file(Cursor *cursor, bool pot, HeightFieldDesc *desc)
{
	Context *context = cursor->context;
	Location where = cursor_where(cursor);
	const char *name = NULL;
	if (!cursor_take_string(cursor, &name))
		return false;
	const char *path = files_find(context, name);
	if (!path)
		diag_error(context->diag, where, "cannot find the image '%s'", name);
	bool may = path && files_may_read(context, path, where);
	Image *image = may ? image_read(path, context->diag) : NULL;
	read_image_words(cursor, image);
	if (!image)
		return false;
	pot = pot && image->indices;
	desc->width = pot ? image->width / 2 : image->width;
	desc->depth = image->height;
	desc->heights = (pot ? pot_heights : image_heights)(context->builder->arena, image);
	image_destroy(image);
	return true;
}

/* A float function, or the grey value of a pigment function. */
static const Function *take_height_function(Cursor *cursor)
{
	const Function *function = cursor_accept_item(cursor, VALUE_FUNCTION);
	if (function)
		return function;
	const VectorFunction *vector = cursor_take_item(cursor, VALUE_VECTOR_FUNCTION,
							"a function");
	return vector ? function_of_gray(cursor->context->builder->arena, vector) : NULL;
}

/* function columns, rows { ... }: the function, then the numbers. Sampled over the unit square,
 * whose y falls as z rises: the function is an image there. */
static bool read_function(Cursor *outer, const Node *block, HeightFieldDesc *desc)
{
	Cursor inside = cursor_begin(outer->context, block), *cursor = &inside;
	Location where = block->where;
	const Function *function = take_height_function(cursor);
	if (!function || !cursor_take_whole(cursor, 2, RESOLUTION_MAX, &desc->width) ||
	    !cursor_take_whole(cursor, 2, RESOLUTION_MAX, &desc->depth))
		return false;
	if (function_arity(function) > 3) {
		diag_error(cursor->context->diag, where,
			   "this function has more than three parameters");
		return false;
	}
	float *heights = ARENA_ARRAY(cursor->context->builder->arena, float,
				     (size_t)desc->width *(size_t)desc->depth);
	for (int z = 0; z < desc->depth; z++)
		for (int x = 0; x < desc->width; x++) {
			double args[3] = {(double)x / (desc->width - 1),
					  1 - (double)z / (desc->depth - 1), 0};
			double height = function_eval(function, args);
			heights[(size_t)z * (size_t)desc->width + (size_t)x] = (float)fmin(
				fmax(height, 0), 1);
		}
	desc->heights = heights;
	return true;
}

bool build_height_field(Cursor *cursor, Object *object)
{
	HeightFieldDesc desc = {0};
	const char *error = NULL;
	bool pot = accept_type(cursor);
	const Node *function = cursor_accept_block(cursor, W_function);
	bool good = function ? read_function(cursor, function, &desc)
			     : read_file(cursor, pot, &desc);
	for (;;) {
		if (cursor_accept_word(cursor, W_smooth))
			desc.smooth = cursor_optional_bool(cursor);
		else if (cursor_accept_word(cursor, W_water_level))
			good &= cursor_take_float(cursor, &desc.water_level);
		else if (cursor_accept_word(cursor, W_hierarchy))
			cursor_optional_bool(cursor);
		else
			break;
	}
	if (!good)
		return false;
	const void *data = height_field_create(cursor->context->builder->arena, &desc, &error);
	const ShapeClass *class = desc.smooth ? &smooth_height_field_class : &height_field_class;
	return build_shape_set(cursor, object, class, data, &error);
}
