#include "base/median.h"

#include <math.h>
#include <string.h>

#include "base/pair.h"

/* How many are less than a value, and how many no more. */
static inline void rank_of(const Pair *v, int pairs, double value, int64_t *less, int64_t *up_to)
{
	Pair both = {value, value};
	PairCount lower = {0}, not_over = {0};
	for (int i = 0; i < pairs; i++) {
		lower -= v[i] < both;
		not_over -= v[i] <= both;
	}
	*less = lower[0] + lower[1];
	*up_to = not_over[0] + not_over[1];
}

/* Ranks are counted without a branch that depends on the values, of those that are still between
 * one that is too small and one that is too large. */
double median(const double *values, int count)
{
	Pair v[MEDIAN_MOST / 2];
	int pairs = (count + 1) / 2, middle = count / 2;
	double low = -INFINITY, high = INFINITY;
	v[pairs - 1] = (Pair){INFINITY, INFINITY};
	memcpy(v, values, sizeof *values * (size_t)count);
	for (int i = 0; i < count; i++) {
		int64_t less, up_to;
		if (!(values[i] > low && values[i] < high))
			continue;
		rank_of(v, pairs, values[i], &less, &up_to);
		if (less <= middle && up_to > middle)
			return values[i];
		if (less > middle)
			high = values[i];
		else
			low = values[i];
	}
	return INFINITY;
}
