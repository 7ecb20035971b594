/* `function WIDTH, HEIGHT { ... }` where an image's name may stand: a raster of the unit square of
 * the x-y plane. */
#include <math.h>

#include "lang/build_image.h"
#include "surface/function.h"

enum { RESOLUTION_MAX = 16384 };

/* Where pixel i of count lies: the first at 0, the last at 1; rows count from the top, but the top
 * row is y = 0. */
static double place(int i, int count) { return count > 1 ? (double)i / (count - 1) : 0; }

/* Heights outside 0..1 start again, as everywhere in patterns. */
static float wrap(double value)
{
	if (!isfinite(value))
		return 0;
	return (float)(value < 0 || value > 1 ? value - floor(value) : value);
}

static float *fill_gray(Arena *arena, const Function *function, int width, int height)
{
	float *pixels = ARENA_ARRAY(arena, float, (size_t)width * (size_t)height);
	for (int y = 0; y < height; y++)
		for (int x = 0; x < width; x++) {
			double args[3] = {place(x, width), place(y, height), 0};
			pixels[(size_t)y * (size_t)width + (size_t)x] = wrap(
				function_eval(function, args));
		}
	return pixels;
}

static float *fill_color(Arena *arena, const VectorFunction *function, int width, int height)
{
	float *pixels = ARENA_ARRAY(arena, float, (size_t)width * (size_t)height * 4);
	for (int y = 0; y < height; y++)
		for (int x = 0; x < width; x++) {
			double args[3] = {place(x, width), place(y, height), 0}, color[5] = {0};
			float *pixel = pixels + ((size_t)y * (size_t)width + (size_t)x) * 4;
			function->eval(function->data, args, color);
			for (int c = 0; c < 3; c++)
				pixel[c] = (float)color[c];
			pixel[3] = (float)fmin(1, fmax(0, 1 - color[4]));
		}
	return pixels;
}

bool build_function_image(Context *context, const Node *block, ImageMap *map)
{
	Arena *arena = context->builder->arena;
	Cursor inside = cursor_begin(context, block);
	const Function *gray = cursor_accept_item(&inside, VALUE_FUNCTION);
	const VectorFunction *color = gray ? NULL
					   : cursor_take_item(&inside, VALUE_VECTOR_FUNCTION,
							      "a function");
	if ((!gray && !color) || !cursor_take_whole(&inside, 1, RESOLUTION_MAX, &map->width) ||
	    !cursor_take_whole(&inside, 1, RESOLUTION_MAX, &map->height))
		return false;
	if ((gray ? function_arity(gray) : color->arity) != 3) {
		diag_error(context->diag, block->where, "a function for an image takes x, y and z");
		return false;
	}
	map->channels = gray ? 1 : 4;
	map->pixels = gray ? fill_gray(arena, gray, map->width, map->height)
			   : fill_color(arena, color, map->width, map->height);
	return cursor_end(&inside);
}
