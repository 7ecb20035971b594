/*
 * Patterns: a number for every point of space, and the words that bend space before and the number
 * after. Shared by pigments, normals, texture maps and, later, densities.
 *
 * A new pattern is one .c file (or a function in its family's file) with a PatternClass and one row
 * in pattern_table.
 */
#ifndef SURFACE_PATTERN_H
#define SURFACE_PATTERN_H

#include <stdbool.h>

#include "base/arena.h"
#include "base/transform.h"
#include "surface/point.h"

typedef struct Pattern Pattern;
typedef struct PatternClass PatternClass;

typedef enum WaveType {
	WAVE_RAMP,
	WAVE_TRIANGLE,
	WAVE_SINE,
	WAVE_SCALLOP,
	WAVE_CUBIC,
	WAVE_POLY
} WaveType;

/* How a class differs from the common kind of pattern. */
enum {
	PATTERN_OWN_TURBULENCE = 1, /* value uses the pattern's classic turbulence itself: it is not
				       applied to the point */
	PATTERN_TRIANGLE = 2, /* the default wave is a triangle */
	PATTERN_STILL =
		4, /* frequency is 0 unless the scene says so: the value goes to the map as it is */
	PATTERN_NEEDS_DATA = 8, /* data may not be NULL */
};

struct PatternClass {
	const char *name; /* as in the scene language */
	/* The raw value: usually in [0, 1] before wave shaping; for list patterns the number of the
	 * entry. */
	double (*value)(const Pattern *pattern, const SurfacePoint *at);
	int list; /* > 0: takes that many colours/pigments/textures instead of a map (checker 2,
		     hexagon 3) */
	/* Optional: a normal perturbation of its own (bumps, dents, ripples, waves, wrinkles,
	 * quilted...). NULL: normals come from the slope of value. Adds to *normal, which is unit
	 * and stays of any length. */
	void (*bump)(const Pattern *pattern, const SurfacePoint *at, double amount, Vec3 *normal);
	int flags;         /* PATTERN_... */
};

typedef struct Warp Warp; /* surface/warp.h */

struct Pattern {
	const PatternClass *class;
	const void *data; /* the class' own parameters, as pattern_data.h defines them; NULL for the
			     defaults */
	const Warp *warps;  /* see warp.h, which also builds the list; transformations are warps */
	double frequency, phase, exponent;
	WaveType wave;
	int noise_generator; /* 1, 2, 3; 0: the scene's */
};

/* A pattern of a class with the class' default wave and frequency, and nothing else. */
void pattern_init(Pattern *pattern, const PatternClass *class);
/* The value with warps, frequency, phase and wave applied: in [0, 1], or an entry's number for list
 * patterns. */
double pattern_value(const Pattern *pattern, const SurfacePoint *at);
/* The same at a point that went through pattern_warp_point already. */
double pattern_value_unwarped(const Pattern *pattern, const SurfacePoint *at);
/* at->p taken through the warps alone. */
Vec3 pattern_warp_point(const Pattern *pattern, const SurfacePoint *at);

/* A normal taken from outside into the pattern's space and back (transformations only); neither
 * comes out unit. A class' own bump gets at->p and the normal in the pattern's space. */
Vec3 pattern_warp_normal(const Pattern *pattern, Vec3 normal);
Vec3 pattern_unwarp_normal(const Pattern *pattern, Vec3 normal);

/* The class of a word, or NULL. */
const PatternClass *pattern_find(const char *name);

#endif
