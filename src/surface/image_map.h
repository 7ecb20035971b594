/*
 * Image maps: a raster wrapped round the origin and looked up, for pigments, bump maps, material
 * maps and image_pattern.
 *
 * The pixels come from the image room, converted by lang to linear light of the scene's working
 * space; this room copies nothing and owns nothing.
 */
#ifndef SURFACE_IMAGE_MAP_H
#define SURFACE_IMAGE_MAP_H

#include <stdbool.h>
#include <stdint.h>

#include "base/arena.h"
#include "base/color.h"
#include "base/vec.h"
#include "surface/texture.h"

/* The numbers are those of the word map_type. */
typedef enum ImageMapping {
	IMAGE_MAPPING_PLANAR = 0,
	IMAGE_MAPPING_SPHERICAL = 1,
	IMAGE_MAPPING_CYLINDRICAL = 2,
	IMAGE_MAPPING_TOROIDAL = 5,
} ImageMapping;

/* The numbers are those of the word interpolate. */
typedef enum ImageInterpolation {
	IMAGE_INTERPOLATION_NONE = 0,
	IMAGE_INTERPOLATION_BILINEAR = 2,
	IMAGE_INTERPOLATION_BICUBIC = 3,
	IMAGE_INTERPOLATION_DISTANCE = 4,
} ImageInterpolation;

/* filter and transmit of one palette index or of all. */
typedef struct ImageClear {
	int index;
	float filter, transmit;
} ImageClear;

struct ImageMap {
	/* The raster: rows from the top, channels interleaved, 1 grey, 2 grey+alpha, 3 RGB, 4
	 * RGB+alpha (not premultiplied). */
	int width, height, channels;
	const float *pixels;    /* linear light */
	const uint8_t *indices; /* palette indices, or NULL */
	int palette_count;
	const float *palette; /* palette_count x 4, linear light, or NULL */

	ImageMapping mapping;
	ImageInterpolation interpolation;
	bool once;
	bool use_color; /* bump and material maps: grey of the colour although there are indices;
	                   use_index is the opposite */
	bool use_alpha; /* image_pattern: the alpha channel is the value */
	Vec2 offset;    /* the word offset of image maps; 0 */
	float filter_all, transmit_all; /* 0 */
	const float *palette_filter;    /* palette_count entries, or NULL: filter N, F */
	const float *palette_transmit;
};

/* The colour at p. Outside a map that is `once`, or unbounded: false, and a clear colour (transmit
 * 1). */
bool image_map_color(const ImageMap *map, Vec3 p, Rgbft *color);
/* Material maps: palette index, or the red channel as 0..255, at p; 0 outside. Not interpolated. */
int image_map_index(const ImageMap *map, Vec3 p);
/* image_pattern: grey or alpha at p, in [0, 1]; 0 outside. */
double image_map_gray(const ImageMap *map, Vec3 p);
/* bump_map: the normal n bent by the map's slopes at p (pattern space), amount is bump_size; n is
 * unit, the result is not. */
Vec3 image_map_bump(const ImageMap *map, Vec3 p, double amount, Vec3 n);

#endif
