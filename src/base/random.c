#include "base/random.h"

#include <assert.h>

#include "base/vec.h"

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
	case 4: return radical_inverse(index, 11);
	case 5: return radical_inverse(index, 13);
	case 6: return radical_inverse(index, 17);
	case 7: return radical_inverse(index, 19);
	default: return radical_inverse(index, (uint64_t)primes[dimension]);
	}
}

/* The numbers of n, n + 1, ... are those of n / base, n / base + 1, ... moved one digit on, each
 * after every digit: upper holds the latter. */
static void append_digit(uint64_t first, uint64_t base, int count, const double *upper, double *out)
{
	double inverse = 1.0 / (double)base;
	int digit = (int)(first % base), last = (int)base - 1;
	for (int i = 0; i < count; i++) {
		double value = (digit + *upper) * inverse;
		out[i] = real_min(value, 0x1.fffffffffffffp-1);
		upper += digit == last;
		digit = digit == last ? 0 : digit + 1;
	}
}

void random_halton_run(uint64_t first, int dimension, int count, double *out)
{
	enum { FEW = 8 };
	uint64_t base = (uint64_t)primes[dimension];
	if (dimension == 0 || count <= FEW) {
		for (int i = 0; i < count; i++)
			out[i] = random_halton(first + (uint64_t)i, dimension);
		return;
	}
	/* At the array's end, behind what is written from them. */
	uint64_t upper = first / base;
	int uppers = (int)((first + (uint64_t)count - 1) / base - upper) + 1;
	double *rest = out + count - uppers;
	random_halton_run(upper, dimension, uppers, rest);
	append_digit(first, base, count, rest, out);
}
