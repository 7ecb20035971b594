/*
 * The film: the image being made, as layers of floats. Colours are linear, in the scene's working
 * space; RGBA is premultiplied and alpha is 1 everywhere unless the render was asked for alpha.
 * Rows go from the top. The renderer puts finished tiles in, under a lock; anybody may take a
 * snapshot at any moment and gets whole tiles only.
 */
#ifndef RENDER_FILM_H
#define RENDER_FILM_H

#include <stdbool.h>
#include <stdint.h>

#include "base/diag.h"

typedef enum FilmLayer {
	FILM_COLOR, /* "RGBA", 4 channels */
	FILM_DIRECT, /* "direct", 3: the image without light that came by caustics */
	FILM_CAUSTIC, /* "caustic", 3 */
	FILM_ALBEDO, /* "albedo", 3: the pigment the eye ray met */
	FILM_NORMAL, /* "N", 3: world space, towards the eye; 0 where nothing was met */
	FILM_DEPTH, /* "Z", 1: distance from the camera in scene units; infinite where nothing was
		       met */
	FILM_PHOTON_COUNT, /* "photons.count", 1: photons gathered where the eye ray first met
			      something */
	FILM_PHOTON_PARAMETER, /* "photons.parameter", 3: their mean emitter coordinates as a colour
				*/
	FILM_PHOTON_EDGES, /* "photons.edges", 1: their mean number of path edges */
	FILM_PHOTON_CONSTRAINT, /* "photons.constraint", 1: how much relaxation held them, 0 not at
				   all, 1 across the feature */
	FILM_LAYER_COUNT
} FilmLayer;

enum {
	FILM_CHANNELS = 23, /* of all layers together */
	FILM_LIGHT_CHANNELS = 10 /* of the layers that come first and hold light; samples of a pixel
				    are averaged in these */
};

/* What a pixel holds, all layers side by side; film_layer_offset says where a layer starts. */
typedef struct FilmPixel {
	float v[FILM_CHANNELS];
} FilmPixel;

/* A half-open rectangle of pixels: x0 <= x < x1. */
typedef struct FilmRect {
	int x0, y0, x1, y1;
} FilmRect;

typedef struct Film Film;

/* The memory that film_create takes. */
double film_bytes(int width, int height, unsigned layers);
/* layers: a sum of (1u << FILM_...); FILM_COLOR is always there. All zero, nothing done. */
Film *film_create(int width, int height, unsigned layers);
Film *film_create_like(const Film *film); /* of the same size and layers, all zero */
void film_destroy(Film *film); /* NULL is allowed */
Film *film_snapshot(const Film *film); /* a copy; the caller destroys it */

/* In pixels; whether it has a layer; and of any film's layer the name that files give it, its
 * channels, and where it starts in a FilmPixel. */
int film_width(const Film *film);
int film_height(const Film *film);
bool film_has(const Film *film, FilmLayer layer);
const char *film_layer_name(FilmLayer layer);
int film_layer_channels(FilmLayer layer);
int film_layer_offset(FilmLayer layer);
/* width*height*channels floats; NULL when the film has no such layer. Read only while nobody
 * renders into the film. */
const float *film_pixels(const Film *film, FilmLayer layer);

/* Puts a rectangle's pixels (row by row) in; final says that they won't change any more. */
void film_commit(Film *film, FilmRect rect, const FilmPixel *pixels, bool final);
/* A pixel's layers; 0 in those that the film does not have. */
void film_read(const Film *film, int x, int y, FilmPixel *out);
bool film_is_final(const Film *film, int x, int y);
bool film_is_started(const Film *film, int x, int y); /* holds some value, final or not */

/* Takes another film, of the same size and layers, into the mean of those taken before; its pixels
 * count as final. */
void film_average(Film *film, const Film *pass);
uint32_t film_passes(const Film *film);  /* how many were taken */
void film_add_photons(Film *film, uint64_t photons);
uint64_t film_photons(const Film *film); /* that its passes used, those of earlier runs included */

/*
 * The state of an unfinished render, exact, to go on with later. key is the caller's hash of what
 * must be equal (scene, size, switches): reading with another key fails. Written beside and
 * renamed. False or NULL on failure, reported.
 */
bool film_save(const Film *film, const char *path, uint64_t key, Diag *diag);
Film *film_load(const char *path, uint64_t key, Diag *diag);

#endif
