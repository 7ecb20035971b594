/* The queries for any processor, in loops of eight that the compiler may vectorise. */
#include "photon/tree_build.h"

#include <math.h>

#include "photon/eight_plain.h"

typedef struct Eight { float at[TREE_WIDTH]; } Eight;

INLINE Eight eight_load(const float *at)
{
	Eight a;
	for (int i = 0; i < TREE_WIDTH; i++)
		a.at[i] = at[i];
	return a;
}

INLINE void eight_store(float *at, Eight a)
{
	for (int i = 0; i < TREE_WIDTH; i++)
		at[i] = a.at[i];
}

INLINE Eight eight_leaf(const TreeLeaf *leaf, const float p[3])
{
	Eight d2;
	for (int i = 0; i < TREE_WIDTH; i++) {
		float dx = leaf->at[0][i] - p[0], dy = leaf->at[1][i] - p[1],
		      dz = leaf->at[2][i] - p[2];
		d2.at[i] = dx * dx + dy * dy + dz * dz;
	}
	return d2;
}

/* How far p is outside of the interval. */
INLINE float outside(float lo, float hi, float p)
{
	float below = lo - p, above = p - hi, most = below > above ? below : above;
	return most > 0 ? most : 0;
}

INLINE Eight eight_box(const TreeBoxes *boxes, const float p[3])
{
	Eight d2;
	for (int i = 0; i < TREE_WIDTH; i++) {
		float dx = outside(boxes->lo[0][i], boxes->hi[0][i], p[0]);
		float dy = outside(boxes->lo[1][i], boxes->hi[1][i], p[1]);
		float dz = outside(boxes->lo[2][i], boxes->hi[2][i], p[2]);
		d2.at[i] = dx * dx + dy * dy + dz * dz;
	}
	return d2;
}

INLINE unsigned eight_less(Eight a, float bound) { return EIGHT_MASK(a.at[i] < bound); }
INLINE unsigned eight_most(Eight a, float bound) { return EIGHT_MASK(a.at[i] <= bound); }

/* The least of a mask's lanes, the first of several; the mask is not 0. */
INLINE unsigned eight_least(Eight a, unsigned mask)
{
	unsigned least = (unsigned)__builtin_ctz(mask);
	for (unsigned i = least + 1; i < TREE_WIDTH; i++)
		least = (mask >> i & 1) && a.at[i] < a.at[least] ? i : least;
	return least;
}

/* Which of an array's values is the least, the first of several; the array has room for seven
 * more. */
INLINE int eight_find_least(float *values, int count)
{
	int least = 0;
	for (int i = 1; i < count; i++)
		least = values[i] < values[least] ? i : least;
	return least;
}

INLINE unsigned eight_lights(const uint16_t *lights, uint16_t light)
{
	return EIGHT_MASK(lights[i] == light);
}

INLINE void eight_pack(float *out, Eight a, unsigned mask)
{
	EightLanes order = eight_order(mask);
	for (int i = 0; i < TREE_WIDTH; i++)
		out[i] = a.at[order.at[i]];
}

/* first + lane * step of a mask's lanes. */
INLINE void eight_numbers(uint32_t *out, uint32_t first, uint32_t step, unsigned mask)
{
	EightLanes order = eight_order(mask);
	for (int i = 0; i < TREE_WIDTH; i++)
		out[i] = first + (uint32_t)order.at[i] * step;
}

INLINE void eight_pairs(Neighbor *out, Eight d2, const uint32_t *from, unsigned mask)
{
	EightLanes order = eight_order(mask);
	for (int i = 0; i < TREE_WIDTH; i++)
		out[i] = (Neighbor){d2.at[order.at[i]], from[order.at[i]]};
}

/* The indices may lie where they are packed to, ahead of the place: one by one. */
INLINE void eight_compact(float *distance2, uint32_t *index, Eight d2, const uint32_t *from,
			  unsigned mask)
{
	int count = 0;
	for (int i = 0; i < TREE_WIDTH; i++) {
		distance2[count] = d2.at[i];
		index[count] = from[i];
		count += mask >> i & 1;
	}
}

INLINE int eight_count(const float *values, int count, float bound)
{
	int lanes[TREE_WIDTH] = {0}, sum = 0;
	for (int i = 0; i < count; i += TREE_WIDTH) {
		for (int k = 0; k < TREE_WIDTH; k++)
			lanes[k] += values[i + k] < bound;
	}
	for (int k = 0; k < TREE_WIDTH; k++)
		sum += lanes[k];
	return sum;
}

/* The largest finite one. */
INLINE float eight_farthest(const float *values, int count)
{
	float most = 0;
	for (int i = 0; i < count; i++)
		most = values[i] > most && values[i] < INFINITY ? values[i] : most;
	return most;
}

#define QUERY_NEAREST tree_nearest_plain
#define QUERY_WITHIN tree_within_plain
#include "photon/tree_query.h"
