/* Blend maps: see the header. */
#include "surface/blend.h"

static double key_of(const void *entries, size_t size, int i)
{
	return *(const double *)(const void *)((const char *)entries + size * (size_t)i);
}

/* The first entry whose key is not below value. A walk, not a bisection: maps are short, and scenes
 * may have keys that fall, which POV-Ray reads in this way. */
static int first_not_below(const void *entries, size_t size, int count, double value)
{
	int i = 0;
	while (i < count - 1 && key_of(entries, size, i) < value)
		i++;
	return i;
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
