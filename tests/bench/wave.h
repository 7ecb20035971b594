/*
 * A caustic in closed form: parallel light falls through a thin wavy sheet onto the unit square of
 * the plane y = 0, each path bent by the slope of a sum of sines. The light's coordinates are x
 * and z. It covers more than the square, so that the square has no edge of its own.
 */
#ifndef TESTS_BENCH_WAVE_H
#define TESTS_BENCH_WAVE_H

#include <math.h>
#include <stdint.h>

enum { WAVES = 7 };
static const double WAVE_MARGIN = 0.25; /* of the light around the square; paths are bent by less */

typedef struct Wave { double x, z, phase, height; } Wave;

/*
 * Wave numbers, phases, heights times distance: two to three sheets lie over each other in places.
 */
static const Wave waves[WAVES] = {
	{9.1, 3.7, 0.3, 3.5e-3},   {-4.2, 12.6, 1.9, 3.0e-3},  {17.3, -8.8, 4.1, 1.44e-3},
	{6.4, 21.0, 5.2, 1.2e-3},  {-29.0, 11.0, 2.7, 4.8e-4}, {14.0, 33.0, 0.9, 3.8e-4},
	{41.0, 27.0, 3.3, 1.8e-4},
};

static inline void wave_map(double x, double z, double to[2])
{
	to[0] = x;
	to[1] = z;
	for (int i = 0; i < WAVES; i++) {
		const Wave *w = &waves[i];
		double slope = w->height * cos(w->x * x + w->z * z + w->phase);
		to[0] -= slope * w->x;
		to[1] -= slope * w->z;
	}
}

/*
 * Where path number i leaves the light: Halton's points in bases 2 and 3, over the square with its
 * margin.
 */
static inline double wave_inverse(uint64_t i, unsigned base)
{
	double digit = 1.0 / base, sum = 0;
	for (; i; i /= base, digit /= base)
		sum += digit * (double)(i % base);
	return sum;
}

static inline void wave_start(uint64_t i, double from[2])
{
	double side = 1 + 2 * WAVE_MARGIN;
	from[0] = wave_inverse(i, 2) * side - WAVE_MARGIN;
	from[1] = wave_inverse(i, 3) * side - WAVE_MARGIN;
}

#endif
