/*
 * Blend maps: where a pattern's value lies among the keys of a colour, pigment, normal, slope or
 * texture map.
 */
#ifndef SURFACE_BLEND_H
#define SURFACE_BLEND_H

#include <stddef.h>

/* Between entries lower and upper, weight of the way from lower to upper; upper alone (weight 1,
 * lower == upper) at a key and beyond both ends. */
typedef struct BlendSpan {
	int lower, upper;
	double weight;
} BlendSpan;

/* entries are count > 0 structs of size bytes that begin with a double, their key; keys
 * rise, or the first one not below value counts. */
BlendSpan blend_find(const void *entries, size_t size, int count, double value);

#endif
