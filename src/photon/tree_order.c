/*
 * The order of the tree's points: a run of up to 8^l points is cut into eight runs of 8^(l-1) by
 * three binary cuts, each at the multiple of the child's size that is nearest to the middle,
 * across the dimension of largest extent.
 *
 * A cut is a selection (Floyd & Rivest 1975): two codes from a sorted sample, a little to either
 * side of the wanted place, part the items in three, and the search goes on among the few in the
 * middle. Items are parted without branches, each written to three places, one of which then moves
 * on. The code is the key's bits made to rise with the float, with the item's number behind, so no
 * two are equal, not even NaNs.
 */
#include <math.h>
#include <stdbool.h>
#include <string.h>

#include "photon/tree_build.h"

#define INLINE static inline __attribute__((always_inline))

typedef struct Order {
	float *items, *scratch; /* of `words` floats each: coordinates first, the number last */
	int words, dimensions;
	float weight[6];
} Order;

enum { WORDS_3 = 4, WORDS_6 = 8, MOST_SAMPLES = 127 };

/* ---- selection ---- */

INLINE uint64_t code_of(const float *item, int words, int axis)
{
	int32_t key;
	uint32_t number;
	memcpy(&key, &item[axis], sizeof key);
	memcpy(&number, &item[words - 1], sizeof number);
	uint32_t rising = (uint32_t)key ^ ((uint32_t)(key >> 31) | 0x80000000u);
	return (uint64_t)rising << 32 | number;
}

/* Items, and as much room beside them. */
typedef struct Run {
	float *items, *scratch;
	uint32_t count;
} Run;

/* Codes of items: those under `low` come first, those from `high` on last. */
typedef struct Pivots { uint64_t low, high; } Pivots;

typedef struct Parts { uint32_t first, middle; } Parts;

/* The last grow downwards from the scratch's end, towards the middle ones, which grow from its
 * start. */
INLINE Parts partition(Run run, int words, int axis, Pivots pivots)
{
	size_t step = (size_t)words, size = sizeof(float) * step;
	size_t first = 0, middle = 0, last = run.count - 1;
	for (size_t i = 0; i < run.count; i++) {
		float *item = run.items + step * i, copy[WORDS_6];
		uint64_t code = code_of(item, words, axis);
		memcpy(copy, item, size);
		memcpy(run.items + step * first, copy, size);
		memcpy(run.scratch + step * middle, copy, size);
		memcpy(run.scratch + step * last, copy, size);
		first += code < pivots.low;
		middle += (code >= pivots.low) & (code < pivots.high);
		last -= code >= pivots.high;
	}
	memcpy(run.items + step * first, run.scratch, size * middle);
	memcpy(run.items + step * (first + middle), run.scratch + step * (last + 1),
	       size * (run.count - first - middle));
	return (Parts){(uint32_t)first, (uint32_t)middle};
}

static void sort_codes(uint64_t *codes, int count)
{
	for (int i = 1; i < count; i++) {
		uint64_t code = codes[i];
		int k = i;
		for (; k > 0 && codes[k - 1] > code; k--)
			codes[k] = codes[k - 1];
		codes[k] = code;
	}
}

/* Two codes that most likely have the wanted item's between them. */
INLINE Pivots choose_pivots(Run run, uint32_t wanted, int words, int axis)
{
	uint64_t codes[MOST_SAMPLES], count = run.count;
	int samples = count >= 16384 ? MOST_SAMPLES : count >= 1024 ? 31 : count >= 100 ? 9 : 3;
	for (int i = 0; i < samples; i++) {
		uint64_t from = (uint64_t)i * count / (uint64_t)samples;
		codes[i] = code_of(run.items + (size_t)words * from, words, axis);
	}
	sort_codes(codes, samples);
	int at = (int)(wanted * (uint64_t)samples / count), beyond = (samples + 8) / 16;
	int low = at - beyond, high = at + beyond;
	Pivots pivots = {codes[low > 0 ? low : 0], codes[high < samples ? high : samples - 1]};
	if (pivots.high <= pivots.low) /* so that at least one item is taken from the others */
		pivots.high = pivots.low + 1;
	return pivots;
}

static Run part_of(Run run, uint32_t first, uint32_t count, int words)
{
	size_t at = (size_t)words * first;
	return (Run){run.items + at, run.scratch + at, count};
}

/* The first `left` items come before the others along the axis. */
INLINE void select_items(Run run, uint32_t left, int words, int axis)
{
	while (left > 0 && left < run.count) {
		Parts parts = partition(run, words, axis, choose_pivots(run, left, words, axis));
		uint32_t both = parts.first + parts.middle;
		if (left <= parts.first) {
			run.count = parts.first;
		} else if (left <= both) {
			run = part_of(run, parts.first, parts.middle, words);
			left -= parts.first;
		} else {
			run = part_of(run, both, run.count - both, words);
			left -= both;
		}
	}
}

/* ---- cuts ---- */

typedef struct Extent { float lo[WORDS_6], hi[WORDS_6]; } Extent;

INLINE void widen(Extent *e, const float *item, int words)
{
	for (int k = 0; k < words; k++) {
		e->lo[k] = item[k] < e->lo[k] ? item[k] : e->lo[k];
		e->hi[k] = item[k] > e->hi[k] ? item[k] : e->hi[k];
	}
}

/* Two at a time, so that one's minimum need not wait for the other's. */
INLINE void extent_of(Extent *e, const float *items, uint32_t count, int words)
{
	Extent odd;
	for (int k = 0; k < words; k++) {
		e->lo[k] = odd.lo[k] = INFINITY;
		e->hi[k] = odd.hi[k] = -INFINITY;
	}
	for (uint32_t i = 0; i + 1 < count; i += 2) {
		widen(e, items + (size_t)words * i, words);
		widen(&odd, items + (size_t)words * (i + 1), words);
	}
	widen(e, items + (size_t)words * (count - 1), words);
	widen(e, odd.lo, words);
	widen(e, odd.hi, words);
}

static int widest(const Order *o, const Extent *e)
{
	int best = 0;
	float most = -1;
	for (int k = 0; k < o->dimensions; k++) {
		float width = o->weight[k] * (e->hi[k] - e->lo[k]);
		if (width > most) {
			most = width;
			best = k;
		}
	}
	return best;
}

static void cut(const Order *o, uint32_t first, uint32_t count, uint32_t left)
{
	size_t at = (size_t)o->words * first;
	Run run = {o->items + at, o->scratch + at, count};
	Extent e;
	if (o->words == WORDS_3) {
		extent_of(&e, run.items, count, WORDS_3);
		select_items(run, left, WORDS_3, widest(o, &e));
	} else {
		extent_of(&e, run.items, count, WORDS_6);
		select_items(run, left, WORDS_6, widest(o, &e));
	}
}

/* Cuts a run of several children's size in two until it is one child. */
static void arrange(const Order *o, uint32_t first, uint32_t count, uint32_t child)
{
	while (child >= TREE_WIDTH && count <= child)
		child /= TREE_WIDTH;
	if (count <= TREE_WIDTH)
		return;
	uint32_t children = (count + child - 1) / child, left = children / 2 * child;
	cut(o, first, count, left);
#pragma omp task if (count > 20000)
	arrange(o, first, left, child);
	arrange(o, first + left, count - left, child);
#pragma omp taskwait
}

static const float *row(const float *base, uint32_t stride, uint32_t i)
{
	return (const float *)((const char *)base + (size_t)stride * i);
}

static void copy_points(const Order *o, const TreePoints *points)
{
	for (uint32_t i = 0; i < points->count; i++) {
		float *item = o->items + (size_t)o->words * i;
		memcpy(item, row(points->position, points->stride, i), 3 * sizeof(float));
		if (o->dimensions > 3) {
			memcpy(item + 3, row(points->emitter, points->stride, i),
			       3 * sizeof(float));
			item[6] = 0;
		}
		memcpy(&item[o->words - 1], &i, sizeof i);
	}
}

TreeItems tree_order(const TreePoints *points)
{
	bool six = points->emitter && points->emitter_weight > 0;
	Order o = {.words = six ? WORDS_6 : WORDS_3, .dimensions = six ? 6 : 3};
	size_t floats = (size_t)o.words * points->count;
	o.items = tree_alloc(2 * floats, sizeof(float));
	o.scratch = o.items + floats;
	copy_points(&o, points);
	for (int k = 0; k < 6; k++)
		o.weight[k] = k < 3 ? 1 : points->emitter_weight;
	uint32_t largest = TREE_WIDTH;
	while (largest <= UINT32_MAX / TREE_WIDTH && largest * TREE_WIDTH < points->count)
		largest *= TREE_WIDTH;
#pragma omp parallel if (points->count > 20000)
#pragma omp single
	arrange(&o, 0, points->count, largest);
	return (TreeItems){o.items, o.words};
}
