#include "base/random.h"

#include <assert.h>

static const int primes[64] = {
	2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37, 41, 43, 47, 53, 59, 61, 67, 71, 73, 79, 83, 89, 97, 101, 103, 107, 109, 113, 127, 131,
	137, 139, 149, 151, 157, 163, 167, 173, 179, 181, 191, 193, 197, 199, 211, 223, 227, 229, 233, 239, 241, 251, 257, 263, 269, 271,
	277, 281, 283, 293, 307, 311,
};

double random_halton(uint64_t index, int dimension)
{
	assert(dimension >= 0 && dimension < 64);
	uint64_t base = (uint64_t)primes[dimension];
	double inverse = 1.0 / (double)base, factor = inverse, result = 0;
	for (; index; index /= base, factor *= inverse)
		result += (double)(index % base) * factor;
	return result < 1 ? result : 0x1.fffffffffffffp-1;
}
