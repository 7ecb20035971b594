/*
 * Lattice noise: POV-Ray's three generators, and the sums of octaves that the language calls
 * turbulence.
 *
 * Generator 1 is POV-Ray 3.1's noise (clamped), 2 the same one range-corrected (3.7's default), 3
 * Perlin's improved noise of 2002. 0 and everything else mean 2.
 */
#ifndef SURFACE_NOISE_H
#define SURFACE_NOISE_H

#include "base/vec.h"

enum { NOISE_GENERATOR_DEFAULT = 2 };

typedef struct Turbulence {
	Vec3 amount; /* how far each axis is moved: the users of the functions below multiply with
			it */
	int octaves; /* 1..10; 6 */
	double lambda; /* factor of the frequency from octave to octave; 2. Rounded to single
			  precision, as POV-Ray does */
	double omega;  /* factor of the size from octave to octave; 0.5. Rounded likewise */
} Turbulence;

/* No amount, 6 octaves, lambda 2, omega 0.5. */
Turbulence turbulence_default(void);
/* As many as are made when a scene asks for so many. */
static inline int turbulence_octaves(double asked)
{
	return asked > 10 ? 10 : asked >= 1 ? (int)asked : 1;
}

/* Noise in [0, 1]. */
double noise_value(Vec3 p, int generator);
/* Three noises, each about in [-0.5, 0.5], of no fixed sum. */
Vec3 noise_vector(Vec3 p, int generator);

/* Sum of octaves of noise_value / noise_vector at p; the amount is not multiplied in. */
double turbulence_value(Vec3 p, const Turbulence *t, int generator);
Vec3 turbulence_vector(Vec3 p, const Turbulence *t, int generator);

/* Three random numbers in [0, 1) for the unit cube whose lower corner is given: the point of
 * crackle's cells. */
Vec3 noise_cube_random(Vec3 cube);

#endif
