/* POV-Ray's two ways of super-sampling (manual 3.2.8.7), for one pixel at a time. */
#ifndef RENDER_ANTIALIAS_H
#define RENDER_ANTIALIAS_H

#include "render/sample.h"

/* True when two colours differ by more than the threshold as an eye sees them (gamma applied,
 * clipped to 0..1). */
bool antialias_differ(const RenderOptions *options, const FilmPixel *a, const FilmPixel *b);

typedef struct AntialiasPixel {
	Tracer *tracer;
	const RenderOptions *options;
	const Film *film;
	int x, y;
	bool first_hit; /* the film wants to know what was met */
} AntialiasPixel;

/* The pixel's first sample, at the options' place. */
void antialias_first(const AntialiasPixel *pixel, FilmPixel *out);

/* Method 1: a grid of depth x depth samples, jittered, beside the first, whose other
 * layers are kept. */
void antialias_grid(const AntialiasPixel *pixel, const FilmPixel *first, FilmPixel *out);

/* Method 2: corners first, and parts whose corners differ in four again, at most depth - 1 times.
 */
typedef struct CornerGrid CornerGrid; /* scratch; one for a thread */

CornerGrid *corner_grid_create(int depth, int tile); /* tile: pixels along a tile's edge */
void corner_grid_destroy(CornerGrid *grid);
void corner_grid_start_tile(CornerGrid *grid, int x, int y); /* its upper left pixel */
void antialias_recursive(const AntialiasPixel *pixel, CornerGrid *grid, FilmPixel *out);

#endif
