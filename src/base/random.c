#include "base/random.h"

#include <assert.h>

static const int primes[64] = {
	2,   3,   5,   7,   11,  13,  17,  19,  23,  29,  31,  37,  41,  43,  47,  53,
	59,  61,  67,  71,  73,  79,  83,  89,  97,  101, 103, 107, 109, 113, 127, 131,
	137, 139, 149, 151, 157, 163, 167, 173, 179, 181, 191, 193, 197, 199, 211, 223,
	227, 229, 233, 239, 241, 251, 257, 263, 269, 271, 277, 281, 283, 293, 307, 311,
};

/* With the base known when this is compiled, divisions become multiplications. */
static inline __attribute__((always_inline)) double radical_inverse(uint64_t index, uint64_t base)
{
	double inverse = 1.0 / (double)base, factor = inverse, result = 0;
	for (; index; index /= base, factor *= inverse)
		result += (double)(index % base) * factor;
	return result < 1 ? result : 0x1.fffffffffffffp-1;
}

static double reversed_bits(uint64_t index)
{
	uint64_t v = __builtin_bswap64(index);
	v = (v >> 4 & 0x0f0f0f0f0f0f0f0f) | (v & 0x0f0f0f0f0f0f0f0f) << 4;
	v = (v >> 2 & 0x3333333333333333) | (v & 0x3333333333333333) << 2;
	v = (v >> 1 & 0x5555555555555555) | (v & 0x5555555555555555) << 1;
	return (double)(v >> 11) * 0x1p-53;
}

double random_halton(uint64_t index, int dimension)
{
	assert(dimension >= 0 && dimension < 64);
	switch (dimension) {
	case 0: return reversed_bits(index);
	case 1: return radical_inverse(index, 3);
	case 2: return radical_inverse(index, 5);
	case 3: return radical_inverse(index, 7);
	default: return radical_inverse(index, (uint64_t)primes[dimension]);
	}
}
