/* Blend maps: see the header. */
#include "surface/blend.h"

static double key_of(const void *entries, size_t size, int i)
{
	return *(const double *)(const void *)((const char *)entries + size * (size_t)i);
}

/* The first entry whose key is not below value; count - 1 when all are. */
static int first_not_below(const void *entries, size_t size, int count, double value)
{
	int lo = 0, hi = count - 1;
	while (lo < hi) {
		int middle = lo + (hi - lo) / 2;
		if (key_of(entries, size, middle) < value)
			lo = middle + 1;
		else
			hi = middle;
	}
	return lo;
}

BlendSpan blend_find(const void *entries, size_t size, int count, double value)
{
	int upper = first_not_below(entries, size, count, value);
	double key = key_of(entries, size, upper);
	if (value >= key_of(entries, size, count - 1))
		return (BlendSpan){count - 1, count - 1, 1};
	if (upper == 0 || key == value)
		return (BlendSpan){upper, upper, 1};
	double below = key_of(entries, size, upper - 1);
	return (BlendSpan){upper - 1, upper, (value - below) / (key - below)};
}
