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

/* Wave number (rad per unit), phase, height times distance. */
typedef struct Wave { double x, z, phase, height; } Wave;

/*
 * Sums of sines; those left out have no height. margin: of the light around the square; paths are
 * bent by less.
 */
typedef struct WaveSheet {
	double margin;
	Wave waves[WAVES];
} WaveSheet;

/*
 * Many wave numbers, two to three sheets over each other: cusps, knots, filaments finer than a few
 * photons are apart.
 */
static const WaveSheet wave_detailed = {0.25, {
	{9.1, 3.7, 0.3, 3.5e-3},   {-4.2, 12.6, 1.9, 3.0e-3},  {17.3, -8.8, 4.1, 1.44e-3},
	{6.4, 21.0, 5.2, 1.2e-3},  {-29.0, 11.0, 2.7, 4.8e-4}, {14.0, 33.0, 0.9, 3.8e-4},
	{41.0, 27.0, 3.3, 1.8e-4},
}};

/* One wave number rules: long folds that cross each other, smooth light between them. */
static const WaveSheet wave_gentle = {0.45, {
	{18.7, 7.7, 0.3, 1.96e-2}, {-5.5, 14.85, 1.9, 2.55e-3},
}};

static inline void wave_map(const WaveSheet *sheet, double x, double z, double to[2])
{
	to[0] = x;
	to[1] = z;
	for (int i = 0; i < WAVES && sheet->waves[i].height > 0; i++) {
		const Wave *w = &sheet->waves[i];
		double slope = w->height * cos(w->x * x + w->z * z + w->phase);
		to[0] -= slope * w->x;
		to[1] -= slope * w->z;
	}
}

static inline double wave_inverse(uint64_t i, unsigned base)
{
	double digit = 1.0 / base, sum = 0;
	for (; i; i /= base, digit /= base)
		sum += digit * (double)(i % base);
	return sum;
}

/* A side of the light, with its margin. */
static inline double wave_side(const WaveSheet *sheet)
{
	return 1 + 2 * sheet->margin;
}

/* Where path number i leaves the light: Halton's points in bases 2 and 3. */
static inline void wave_start(const WaveSheet *sheet, uint64_t i, double from[2])
{
	from[0] = wave_inverse(i, 2) * wave_side(sheet) - sheet->margin;
	from[1] = wave_inverse(i, 3) * wave_side(sheet) - sheet->margin;
}

#endif
