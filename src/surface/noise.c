/*
 * Gradient noise on a lattice of unit cubes (Perlin, "An Image Synthesizer", SIGGRAPH 1985): each
 * lattice point has a number and a gradient; in a cube the eight linear functions are mixed with
 * weights 3t^2 - 2t^3.
 *
 * The figures that make it POV-Ray's noise were measured with POV-Ray 3.7.0.10;
 * tests/measure_noise.py measures them again. What was found:
 * - Generators 1 and 2 and the vector noise share a lattice. A point hashes to h in 0..255 by a
 * shuffled table of 4096 (noise_tables_make.c); from a table of 267 numbers entry h, halved, is its
 * number, h+1..h+3 its gradient. The vector noise's x, y and z use the entries from h, h+4 and h+8.
 * Coordinates wrap at 4096, counted from -10000.
 * - Generator 1 is that value + 0.5, generator 2 (value + 1.05242) 0.48985582, both clamped
 * to [0, 1].
 * - Generator 3 has unit gradients and no number, 2048 of each, and a lattice that is shifted by a
 * fraction.
 */
#include "surface/noise.h"

#include <stdint.h>
#include <string.h>

#include "base/pair.h"

#include "surface/noise_tables.inc"

enum { LATTICE_MASK = 4095, LATTICE_ORIGIN = 10000, PERLIN_MASK = 2047 };

/* A cube of the lattice: the corner's coordinates, the place in it and the weights of the upper
 * faces. */
typedef struct Cell {
	int64_t x, y, z;
	double dx, dy, dz;
	double sx, sy, sz;
} Cell;

static inline double fade(double t) { return t * t * (3 - 2 * t); }

static double clamp_unit(double v) { return v < 0 ? 0 : v > 1 ? 1 : v; }

static inline int64_t lattice_floor(double v)
{
	int64_t i = (int64_t)v;
	return i - (v < (double)i);
}

/* Places too far out for the lattice's numbers, or nowhere, count as the origin. */
static inline double on_lattice(double v) { return v > -0x1p62 && v < 0x1p62 ? v : 0; }

static inline Cell lattice_cell(double x, double y, double z)
{
	Cell c;
	x = on_lattice(x);
	y = on_lattice(y);
	z = on_lattice(z);
	c.x = lattice_floor(x);
	c.y = lattice_floor(y);
	c.z = lattice_floor(z);
	c.dx = x - (double)c.x;
	c.dy = y - (double)c.y;
	c.dz = z - (double)c.z;
	c.sx = fade(c.dx);
	c.sy = fade(c.dy);
	c.sz = fade(c.dz);
	return c;
}

#define INLINE static inline __attribute__((always_inline))

/* Adds one corner's linear functions, `parts` of them, to as many sums of two pairs. */
INLINE void corner_add(Pair *sums, int parts, const double *entries, Pair low, Pair high)
{
#pragma GCC unroll 3
	for (int n = 0; n < parts; n++) {
		Pair a, b;
		memcpy(&a, entries + 4 * n, sizeof a);
		memcpy(&b, entries + 4 * n + 2, sizeof b);
		sums[2 * n] += a * low;
		sums[2 * n + 1] += b * high;
	}
}

/* The two corners above each other along z, for x and y chosen; weight is that of the edge. */
INLINE void edge_add(const Cell *c, Pair *sums, int parts, int hash, double weight, Pair low,
                     double dy)
{
	int z = (int)((c->z + LATTICE_ORIGIN) & LATTICE_MASK), z1 = (z + 1) & LATTICE_MASK;
	double near = weight * (1 - c->sz), far = weight * c->sz;
	corner_add(sums, parts, noise_entries + (noise_hash[hash ^ z] & 255), low * near,
	           (Pair){dy, c->dz} * near);
	corner_add(sums, parts, noise_entries + (noise_hash[hash ^ z1] & 255), low * far,
	           (Pair){dy, c->dz - 1} * far);
}

/* `parts` noises summed over the cube's eight corners; each is the total of its two pairs. */
INLINE void lattice_sum(const Cell *c, int parts, Pair *sums)
{
	int y = (int)((c->y + LATTICE_ORIGIN) & LATTICE_MASK), y1 = (y + 1) & LATTICE_MASK;
	int hash = noise_hash[(c->x + LATTICE_ORIGIN) & LATTICE_MASK];
	int hash1 = noise_hash[(c->x + LATTICE_ORIGIN + 1) & LATTICE_MASK];
	double x0 = 1 - c->sx, y0 = 1 - c->sy;
	Pair low = {0.5, c->dx}, low1 = {0.5, c->dx - 1};
#pragma GCC unroll 6
	for (int n = 0; n < 2 * parts; n++)
		sums[n] = (Pair){0, 0};
	edge_add(c, sums, parts, noise_hash[hash ^ y], x0 * y0, low, c->dy);
	edge_add(c, sums, parts, noise_hash[hash ^ y1], x0 * c->sy, low, c->dy - 1);
	edge_add(c, sums, parts, noise_hash[hash1 ^ y], c->sx * y0, low1, c->dy);
	edge_add(c, sums, parts, noise_hash[hash1 ^ y1], c->sx * c->sy, low1, c->dy - 1);
}

static double lattice_value(Vec3 p)
{
	Pair sums[2];
	Cell c = lattice_cell(p.x, p.y, p.z);
	lattice_sum(&c, 1, sums);
	Pair total = sums[0] + sums[1];
	return total[0] + total[1];
}

/* Generator 3. The shift is huge, so the fraction keeps only 29 bits; that is POV-Ray's as well. */
static double perlin_value(Vec3 p)
{
	const double shift = 10485760 + 12432434 / 536870912.0;
	Cell c = lattice_cell(p.x + shift, p.y + shift, p.z + shift);
	double sum = 0;
#pragma GCC unroll 8
	for (int n = 0; n < 8; n++) {
		int i = n >> 2, j = n >> 1 & 1, k = n & 1;
		int hash = noise_perlin_hash[(c.x + i + PERLIN_SHIFT_X) & PERLIN_MASK];
		hash = noise_perlin_hash[(hash + c.y + j + PERLIN_SHIFT_Y) & PERLIN_MASK];
		const double *g = noise_perlin_gradients[(hash + c.z + k) & PERLIN_MASK];
		double weight = (i ? c.sx : 1 - c.sx) * (j ? c.sy : 1 - c.sy) *
				(k ? c.sz : 1 - c.sz);
		sum += weight * (g[0] * (c.dx - i) + g[1] * (c.dy - j) + g[2] * (c.dz - k));
	}
	return clamp_unit(0.5 * (1.59 * sum + 0.985));
}

Vec3 noise_cube_random(Vec3 cube)
{
	int hash = noise_hash[(int64_t)on_lattice(cube.x) & LATTICE_MASK];
	hash = noise_hash[hash ^ ((int64_t)on_lattice(cube.y) & LATTICE_MASK)];
	hash = noise_hash[hash ^ ((int64_t)on_lattice(cube.z) & LATTICE_MASK)];
	const uint32_t *random = noise_twister + hash;
	return vec3(random[0] * 0x1p-32, random[1] * 0x1p-32, random[2] * 0x1p-32);
}

Turbulence turbulence_default(void)
{
	return (Turbulence){.octaves = 6, .lambda = 2, .omega = 0.5};
}

double noise_value(Vec3 p, int generator)
{
	switch (generator) {
	case 1:
		return clamp_unit(lattice_value(p) + 0.5);
	case 3:
		return perlin_value(p);
	default:
		return clamp_unit((lattice_value(p) + 1.05242) * 0.48985582);
	}
}

Vec3 noise_vector(Vec3 p, int generator)
{
	(void)generator; /* all three share it */
	Pair sums[6];
	Cell c = lattice_cell(p.x, p.y, p.z);
	lattice_sum(&c, 3, sums);
	Pair x = sums[0] + sums[1], y = sums[2] + sums[3], z = sums[4] + sums[5];
	return vec3(x[0] + x[1], y[0] + y[1], z[0] + z[1]);
}

/* One octave's share: generators 2 and 3 have their narrower range stretched. */
static double turbulence_octave(Vec3 p, int generator)
{
	double v = noise_value(p, generator);
	return generator == 1 ? v : 2 * v - 0.5;
}

double turbulence_value(Vec3 p, const Turbulence *t, int generator)
{
	double sum = turbulence_octave(p, generator), scale = 1, size = 1;
	if (generator != 1)
		sum = clamp_unit(sum);
	for (int i = 1; i < t->octaves; i++) {
		scale *= (float)t->lambda;
		size *= (float)t->omega;
		sum += size * turbulence_octave(vec3_scale(p, scale), generator);
	}
	return sum;
}

Vec3 turbulence_vector(Vec3 p, const Turbulence *t, int generator)
{
	Vec3 sum = noise_vector(p, generator);
	double scale = 1, size = 1;
	for (int i = 1; i < t->octaves; i++) {
		scale *= (float)t->lambda;
		size *= (float)t->omega;
		sum = vec3_mad(sum, size, noise_vector(vec3_scale(p, scale), generator));
	}
	return sum;
}
