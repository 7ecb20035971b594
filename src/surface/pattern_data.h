/*
 * What a pattern's words fill in: Pattern.data of each class. data NULL means the defaults, except
 * where a struct says that it is needed. lang makes them in the scene's arena; pointers inside live
 * as long.
 */
#ifndef SURFACE_PATTERN_DATA_H
#define SURFACE_PATTERN_DATA_H

#include <stdint.h>

#include "base/arena.h"
#include "surface/function.h"
#include "surface/pattern.h"
#include "surface/texture.h"

typedef struct GradientData {
	Vec3 direction;
} GradientData; /* gradient; needed */
typedef struct AgateData {
	double turbulence;
} AgateData; /* agate_turb; 1 */
typedef struct QuiltedData {
	double control0, control1;
} QuiltedData; /* 1, 1 */
typedef struct SpiralData {
	int arms;
} SpiralData; /* spiral1, spiral2; needed */
typedef struct BrickData {
	Vec3 size;
	double mortar;
} BrickData; /* <8, 3, 4.5>, 0.5 */

typedef struct Tiling Tiling;
typedef struct TilingData {
	const Tiling *tiling;
} TilingData; /* tiling; needed */
/* The tiles of `tiling KIND`. */
enum { TILING_KINDS = 24 };
const Tiling *tiling_create(Arena *arena, int kind); /* 1 to TILING_KINDS */

/* pavement; needed */
typedef struct PavementData {
	int sides;                       /* number_of_sides 3, 4, 6; 3 */
	int tiles;                       /* number_of_tiles 1..6; 1 */
	int pattern;                     /* 1..; 1 */
	int exterior, interior, form;    /* 0 */
	const struct PavementPlan *plan; /* what sides, tiles and pattern stand for */
} PavementData;

/* crackle; also facets uses the first cells of it */
typedef struct CrackleData {
	Vec3 form;     /* <-1, 1, 0> */
	double metric; /* 2 */
	double offset; /* 0 */
	bool solid;
} CrackleData;

/* facets: coords 0 snaps normals, else it is how far facets tilt; size, 0.1, is theirs in either
 * case. */
typedef struct FacetsData {
	double coords, size;
} FacetsData;

/* mandel, julia, magnet1m, magnet2m, magnet1j, magnet2j (the names of the classes; `magnet 1
 * mandel` is magnet1m) */
typedef struct FractalData {
	double real, imaginary; /* the Julia constant */
	int iterations;
	int exponent;                            /* 2..33; 2 */
	int exterior, interior;                  /* colouring types; 1, 0 */
	double exterior_factor, interior_factor; /* 1 */
} FractalData;

/* waves and ripples: the sources, made once a scene by wave_sources_create. NULL: ten sources. */
typedef struct WaveData {
	int count;
	const Vec3 *sources;
	const double *frequencies;
} WaveData;
/* global_settings { number_of_waves count } */
const WaveData *wave_sources_create(Arena *arena, int count);

typedef struct FunctionData {
	const Function *function;
} FunctionData; /* function of x, y, z; needed */
typedef struct ImageData {
	const ImageMap *image;
} ImageData; /* image_pattern; needed */
typedef struct PigmentData {
	const Pigment *pigment;
} PigmentData; /* pigment_pattern; needed */

/* object: entry 1 inside the shape. The callback keeps this room free of geometry. */
typedef struct ObjectData {
	bool (*inside)(const void *shape, Vec3 p);
	const void *shape;
} ObjectData;

/* potential: the field of a blob or function minus its threshold, as its owner computes it. */
typedef struct PotentialData {
	double (*value)(const void *shape, Vec3 p);
	const void *shape;
} PotentialData;

typedef struct SlopeData {
	Vec3 direction; /* slope's vector, or the point with point_at */
	bool point_at;
	Vec3 altitude;             /* zero: no altitude */
	double lo_slope, hi_slope; /* 0, 1 */
	double lo_alt, hi_alt;     /* 0, 1 */
} SlopeData;

/* density_file: voxels of 1, 2 or 4 bytes as unsigned integers, x fastest, z slowest. */
typedef struct DensityData {
	int size_x, size_y, size_z;
	const float *voxels; /* 0..1 */
	int interpolate;     /* 0 none, 1 trilinear, 2 tricubic */
} DensityData;
/* Reads a df3 file's bytes. NULL when it is no df3 file. */
DensityData *density_parse(Arena *arena, const uint8_t *bytes, size_t length);

#endif
