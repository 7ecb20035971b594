#include "render/antialias.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/arena.h"

/* Sample numbers: a pixel's first sample is number 0 of its block, the grid's follow. Corner
 * samples, shared by pixels, are numbered by their place on the image's finest grid, beyond all
 * blocks. */
static const uint64_t SAMPLES_A_PIXEL = 1u << 7;
static const uint64_t CORNER_NUMBERS = (uint64_t)1 << 62;

static double shown(float value, double gamma)
{
	double clipped = value > 0 ? fmin(value, 1) : 0;
	return gamma == 1 ? clipped : pow(clipped, 1 / gamma);
}

bool antialias_differ(const RenderOptions *options, const FilmPixel *a, const FilmPixel *b)
{
	double sum = 0;
	if (memcmp(a->v, b->v, 4 * sizeof(float)) == 0)
		return options->threshold < 0;
	for (int i = 0; i < 4; i++)
		sum += fabs(shown(a->v[i], i < 3 ? options->gamma : 1) -
			    shown(b->v[i], i < 3 ? options->gamma : 1));
	return sum > options->threshold;
}

static SamplePlace pixel_place(const AntialiasPixel *pixel)
{
	int width = film_width(pixel->film), height = film_height(pixel->film);
	return (SamplePlace){
		.x = pixel->x,
		.y = pixel->y,
		.width = width,
		.height = height,
		.number = ((uint64_t)pixel->y * (uint64_t)width + (uint64_t)pixel->x) *
			  SAMPLES_A_PIXEL,
	};
}

void antialias_first(const AntialiasPixel *pixel, FilmPixel *out)
{
	SamplePlace place = pixel_place(pixel);
	place.x += pixel->options->place[0];
	place.y += pixel->options->place[1];
	place.first_hit = pixel->first_hit;
	sample_image(pixel->tracer, &place, out);
}

/* Random and in [-amount/2, amount/2), from the sample's own numbers. */
static double jitter(const RenderOptions *options, uint64_t number, int axis)
{
	/* Dimensions far from those that the ray's own sampler counts through. */
	return (random_uniform(options->seed, number, ((uint64_t)1 << 32) + (uint64_t)axis) - 0.5) *
	       options->jitter;
}

void antialias_grid(const AntialiasPixel *pixel, const FilmPixel *first, FilmPixel *out)
{
	const RenderOptions *options = pixel->options;
	int depth = options->depth;
	double sum[FILM_LIGHT_CHANNELS];
	for (int k = 0; k < FILM_LIGHT_CHANNELS; k++)
		sum[k] = first->v[k]; /* counts like the others */
	SamplePlace corner = pixel_place(pixel);
	for (int i = 0; i < depth * depth; i++) {
		SamplePlace place = corner;
		place.number += (uint64_t)i + 1;
		place.x += (i % depth + 0.5 + jitter(options, place.number, 0)) / depth;
		place.y += (i / depth + 0.5 + jitter(options, place.number, 1)) / depth;
		FilmPixel one;
		sample_image(pixel->tracer, &place, &one);
		for (int k = 0; k < FILM_LIGHT_CHANNELS; k++)
			sum[k] += one.v[k];
	}
	*out = *first;
	for (int k = 0; k < FILM_LIGHT_CHANNELS; k++)
		out->v[k] = (float)(sum[k] / (depth * depth + 1));
}

/* ---- method 2 ---- */

/* Samples that are kept as long as a stamp says so. */
typedef struct SampleCache {
	int side;
	uint32_t stamp;   /* of what is worked on now */
	uint32_t *stamps; /* which samples belong to it */
	FilmPixel *samples;
} SampleCache;

struct CornerGrid {
	SampleCache pixel;   /* the finest grid of one pixel: 2^(depth - 1) + 1 along an edge */
	SampleCache tile;    /* the corners of a tile's pixels, shared by neighbours */
	int tile_x, tile_y;
};

static void cache_init(SampleCache *cache, int side)
{
	size_t count = (size_t)side * (size_t)side;
	cache->side = side;
	cache->stamp = 0;
	cache->stamps = memory_alloc(count * sizeof *cache->stamps);
	memset(cache->stamps, 0, count * sizeof *cache->stamps);
	cache->samples = memory_alloc(count * sizeof *cache->samples);
}

CornerGrid *corner_grid_create(int depth, int tile)
{
	CornerGrid *grid = memory_alloc(sizeof *grid);
	cache_init(
		&grid->pixel,
		(1 << (depth - 1)) +
			1); /* depth 1 is the corners alone: as measured, not as the manual says */
	cache_init(&grid->tile, tile + 1);
	return grid;
}

void corner_grid_destroy(CornerGrid *grid)
{
	if (!grid)
		return;
	free(grid->pixel.stamps);
	free(grid->pixel.samples);
	free(grid->tile.stamps);
	free(grid->tile.samples);
	free(grid);
}

void corner_grid_start_tile(CornerGrid *grid, int x, int y)
{
	grid->tile.stamp++;
	grid->tile_x = x;
	grid->tile_y = y;
}

/* A sample's number, and so its jitter, is that of the same place seen from a neighbouring pixel.
 */
static void trace_corner(const AntialiasPixel *pixel, int cells, int column, int row,
			 FilmPixel *out)
{
	SamplePlace place = pixel_place(pixel);
	uint64_t across = (uint64_t)pixel->x * (uint64_t)cells + (uint64_t)column;
	uint64_t down = (uint64_t)pixel->y * (uint64_t)cells + (uint64_t)row;
	place.number = CORNER_NUMBERS + down * ((uint64_t)place.width * (uint64_t)cells + 1) +
		       across;
	place.x += (column + jitter(pixel->options, place.number, 0)) / cells;
	place.y += (row + jitter(pixel->options, place.number, 1)) / cells;
	place.first_hit = pixel->first_hit && column % cells == 0 && row % cells == 0;
	sample_image(pixel->tracer, &place, out);
}

/* The sample at a place of the pixel's grid. */
static const FilmPixel *corner_sample(const AntialiasPixel *pixel, CornerGrid *grid, int column,
				      int row)
{
	int cells = grid->pixel.side - 1;
	SampleCache *cache = &grid->pixel;
	int at_column = column, at_row = row;
	if (column % cells == 0 && row % cells == 0) {
		cache = &grid->tile;
		at_column = pixel->x - grid->tile_x + column / cells;
		at_row = pixel->y - grid->tile_y + row / cells;
	}
	size_t at = (size_t)at_row * (size_t)cache->side + (size_t)at_column;
	if (cache->stamps[at] != cache->stamp) {
		trace_corner(pixel, cells, column, row, &cache->samples[at]);
		cache->stamps[at] = cache->stamp;
	}
	return &cache->samples[at];
}

typedef struct Square {
	int column, row, size; /* in cells of the grid */
} Square;

static void square_color(const AntialiasPixel *pixel, CornerGrid *grid, Square square,
			 double out[FILM_LIGHT_CHANNELS])
{
	const FilmPixel *corner[4];
	for (int i = 0; i < 4; i++)
		corner[i] = corner_sample(pixel, grid, square.column + (i & 1) * square.size,
		                          square.row + (i >> 1) * square.size);
	bool differ = antialias_differ(pixel->options, corner[0], corner[1]) ||
		antialias_differ(pixel->options, corner[1], corner[3]) ||
		antialias_differ(pixel->options, corner[3], corner[2]) ||
		antialias_differ(pixel->options, corner[2], corner[0]);
	for (int k = 0; k < FILM_LIGHT_CHANNELS; k++)
		out[k] = 0;
	for (int i = 0; i < 4; i++) {
		double part[FILM_LIGHT_CHANNELS];
		int half = square.size / 2;
		if (half && differ)
			square_color(pixel, grid,
				     (Square){square.column + (i & 1) * half,
					      square.row + (i >> 1) * half, half},
				     part);
		for (int k = 0; k < FILM_LIGHT_CHANNELS; k++)
			out[k] += (half && differ ? part[k] : corner[i]->v[k]) / 4;
	}
}

void antialias_recursive(const AntialiasPixel *pixel, CornerGrid *grid, FilmPixel *out)
{
	double color[FILM_LIGHT_CHANNELS];
	grid->pixel.stamp++;
	square_color(pixel, grid, (Square){0, 0, grid->pixel.side - 1}, color);
	*out = *corner_sample(pixel, grid, 0, 0);
	for (int k = 0; k < FILM_LIGHT_CHANNELS; k++)
		out->v[k] = (float)color[k];
}
