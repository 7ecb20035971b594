/*
 * Random numbers as functions, not streams: the same (seed, index, dimension) gives the same number
 * whatever thread asks and in whatever order. Low-discrepancy: Halton points, Owen-style scrambled
 * Sobol pairs belong here as well.
 */
#ifndef BASE_RANDOM_H
#define BASE_RANDOM_H

#include <stdint.h>

/* A well-mixed 64-bit hash of a 64-bit key. */
static inline uint64_t random_mix(uint64_t k)
{
	k ^= k >> 32;
	k *= 0xd6e8feb86659fd93u;
	k ^= k >> 32;
	k *= 0xd6e8feb86659fd93u;
	k ^= k >> 32;
	return k;
}
static inline uint64_t random_bits(uint64_t seed, uint64_t index, uint64_t dimension)
{
	return random_mix(random_mix(random_mix(seed + 0x9e3779b97f4a7c15u) ^ index) +
			  0x9e3779b97f4a7c15u * (dimension + 1));
}
/* Uniform in [0, 1). */
static inline double random_uniform(uint64_t seed, uint64_t index, uint64_t dimension)
{
	return (double)(random_bits(seed, index, dimension) >> 11) * 0x1p-53;
}

/* The counting sampler that follows one path: each call takes the next dimension. */
typedef struct Sampler {
	uint64_t seed, index, dimension;
} Sampler;

static inline double sampler_next(Sampler *s)
{
	return random_uniform(s->seed, s->index, s->dimension++);
}

/* Radical inverse of index in the dimension-th prime base, in [0, 1); dimension < 64. (Halton 1960)
 */
double random_halton(uint64_t index, int dimension);
/* The same for count indices from the first on, equal but for rounding, at few operations each. */
void random_halton_run(uint64_t first, int dimension, int count, double *out);

#endif
