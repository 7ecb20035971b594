#include "photon/tree_build.h"

#include <assert.h>
#include <math.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

#include "base/arena.h"
#include "base/parallel.h"

/*
 * Ordering: a run of up to 8^l points is cut into eight runs of 8^(l-1) by three binary cuts, each at the multiple of the
 * child's size that is nearest to the middle, across the dimension of largest extent, with quickselect.
 */

typedef struct Item {
	float key[6];
	uint32_t index;
} Item;

typedef struct Item3 {
	float key[3];
	uint32_t index;
} Item3;

typedef struct Build {
	Item *items;
	float weight[6];
	int dimensions;
} Build;

typedef struct Extent { float lo[6], hi[6]; } Extent;

static Extent extent_of(const Build *b, const Item *items, uint32_t count)
{
	Extent e;
	for (int k = 0; k < 6; k++) {
		e.lo[k] = INFINITY;
		e.hi[k] = -INFINITY;
	}
	for (uint32_t i = 0; i < count; i++) {
		for (int k = 0; k < b->dimensions; k++) {
			e.lo[k] = items[i].key[k] < e.lo[k] ? items[i].key[k] : e.lo[k];
			e.hi[k] = items[i].key[k] > e.hi[k] ? items[i].key[k] : e.hi[k];
		}
	}
	return e;
}

static int widest(const Build *b, const Extent *e)
{
	int best = 0;
	float most = -1;
	for (int k = 0; k < b->dimensions; k++) {
		float width = b->weight[k] * (e->hi[k] - e->lo[k]);
		if (width > most) {
			most = width;
			best = k;
		}
	}
	return best;
}

static bool item_before(const Item *a, const Item *b, int axis)
{
	return a->key[axis] < b->key[axis] || (a->key[axis] == b->key[axis] && a->index < b->index);
}

static void swap_items(Item *a, Item *b)
{
	Item t = *a;
	*a = *b;
	*b = t;
}

static void order_three(Item *a, Item *b, Item *c, int axis)
{
	if (item_before(b, a, axis))
		swap_items(a, b);
	if (item_before(c, a, axis))
		swap_items(a, c);
	if (item_before(c, b, axis))
		swap_items(b, c);
}

/* Quickselect: the first `left` items come before the others along the axis. */
static void split_at(Item *items, uint32_t count, uint32_t left, int axis)
{
	long lo = 0, hi = (long)count - 1, k = left;
	while (lo < hi) {
		long middle = lo + (hi - lo) / 2, i = lo, j = hi;
		order_three(&items[lo], &items[middle], &items[hi], axis);
		Item pivot = items[middle];
		while (i <= j) {
			while (item_before(&items[i], &pivot, axis))
				i++;
			while (item_before(&pivot, &items[j], axis))
				j--;
			if (i <= j)
				swap_items(&items[i++], &items[j--]);
		}
		if (k <= j)
			hi = j;
		else if (k >= i)
			lo = i;
		else
			return;
	}
}

/* Cuts a run of several children's size in two until it is one child. */
static void arrange(const Build *b, uint32_t first, uint32_t count, uint32_t child)
{
	while (child >= TREE_WIDTH && count <= child)
		child /= TREE_WIDTH;
	if (count <= TREE_WIDTH)
		return;
	uint32_t children = (count + child - 1) / child, left = children / 2 * child;
	Item *items = b->items + first;
	Extent e = extent_of(b, items, count);
	split_at(items, count, left, widest(b, &e));
#pragma omp task if (count > 20000)
	arrange(b, first, left, child);
	arrange(b, first + left, count - left, child);
#pragma omp taskwait
}

static const float *row(const float *base, uint32_t stride, uint32_t i)
{
	return (const float *)((const char *)base + (size_t)stride * i);
}

static Item *copy_points(const TreePoints *points)
{
	Item *items = memory_alloc(sizeof(Item) * points->count);
	for (uint32_t i = 0; i < points->count; i++) {
		memcpy(items[i].key, row(points->position, points->stride, i), 3 * sizeof(float));
		if (points->emitter)
			memcpy(items[i].key + 3, row(points->emitter, points->stride, i), 3 * sizeof(float));
		items[i].index = i;
	}
	return items;
}

static void fill_leaf(PhotonTree *tree, const TreePoints *points, const Item *items, uint32_t leaf)
{
	for (uint32_t i = 0; i < TREE_WIDTH; i++) {
		uint32_t at = leaf * TREE_WIDTH + i;
		bool there = at < points->count;
		tree->leaves[leaf].index[i] = there ? items[at].index : 0;
		for (int k = 0; k < 3; k++) {
			tree->leaves[leaf].at[k][i] = there ? items[at].key[k] : INFINITY;
			if (points->emitter)
				tree->emitters[leaf].at[k][i] = there ? items[at].key[3 + k] : INFINITY;
		}
		if (points->emitter && there) {
			const char *light = (const char *)points->light + (size_t)points->stride * items[at].index;
			memcpy(&tree->lights[at], light, sizeof(uint16_t));
		}
	}
}

static void *aligned(size_t count, size_t size)
{
	void *memory = aligned_alloc(64, (count * size + 63) / 64 * 64);
	if (!memory)
		memory_alloc(SIZE_MAX / 2); /* ends the program with the usual message */
	return memory;
}

static void fill_leaves(PhotonTree *tree, const TreePoints *points, const Item *items)
{
	size_t slots = (size_t)tree->leaf_count * TREE_WIDTH;
	tree->leaves = aligned(tree->leaf_count, sizeof(TreeLeaf));
	if (points->emitter) {
		tree->emitters = aligned(tree->leaf_count, sizeof(TreeLeaf));
		tree->lights = memory_alloc(slots * sizeof(uint16_t));
	}
	for (uint32_t i = 0; i < tree->leaf_count; i++)
		fill_leaf(tree, points, items, i);
}

static void clear_boxes(TreeBoxes *boxes)
{
	for (int k = 0; k < 3; k++) {
		for (int i = 0; i < TREE_WIDTH; i++) {
			boxes->lo[k][i] = INFINITY;
			boxes->hi[k][i] = -INFINITY;
		}
	}
}

/* Child `slot` of a node covers the values from lo to hi; the infinities of missing points do not count. */
static void cover(TreeBoxes *boxes, int slot, int axis, const float *lo, const float *hi)
{
	for (int i = 0; i < TREE_WIDTH; i++) {
		if (lo[i] < boxes->lo[axis][slot])
			boxes->lo[axis][slot] = lo[i];
		if (hi[i] > boxes->hi[axis][slot] && hi[i] < INFINITY)
			boxes->hi[axis][slot] = hi[i];
	}
}

static TreeBoxes *boxes_of_leaves(const TreeLeaf *leaves, uint32_t leaf_count, uint32_t count)
{
	TreeBoxes *boxes = aligned(count, sizeof *boxes);
	for (uint32_t n = 0; n < count; n++)
		clear_boxes(&boxes[n]);
	for (uint32_t n = 0; n < leaf_count; n++) {
		for (int k = 0; k < 3; k++)
			cover(&boxes[n / TREE_WIDTH], (int)(n % TREE_WIDTH), k, leaves[n].at[k], leaves[n].at[k]);
	}
	return boxes;
}

static TreeBoxes *boxes_of_nodes(const TreeBoxes *nodes, uint32_t node_count, uint32_t count)
{
	TreeBoxes *boxes = aligned(count, sizeof *boxes);
	for (uint32_t n = 0; n < count; n++)
		clear_boxes(&boxes[n]);
	for (uint32_t n = 0; n < node_count; n++) {
		for (int k = 0; k < 3; k++)
			cover(&boxes[n / TREE_WIDTH], (int)(n % TREE_WIDTH), k, nodes[n].lo[k], nodes[n].hi[k]);
	}
	return boxes;
}

static void build_levels(PhotonTree *tree)
{
	uint32_t below = tree->leaf_count;
	do {
		TreeLevel *level = &tree->levels[tree->level_count], *last = level - 1;
		bool first = tree->level_count++ == 0;
		assert(tree->level_count <= TREE_MAX_LEVELS);
		level->count = (below + TREE_WIDTH - 1) / TREE_WIDTH;
		level->boxes = first ? boxes_of_leaves(tree->leaves, below, level->count)
		                     : boxes_of_nodes(last->boxes, below, level->count);
		if (tree->emitters)
			level->emitter_boxes = first ? boxes_of_leaves(tree->emitters, below, level->count)
			                             : boxes_of_nodes(last->emitter_boxes, below, level->count);
		below = level->count;
	} while (below > 1);
}

PhotonTree *photon_tree_create(const TreePoints *points)
{
	PhotonTree *tree = memory_alloc(sizeof *tree);
	*tree = (PhotonTree){.count = points->count, .leaf_count = (points->count + TREE_WIDTH - 1) / TREE_WIDTH};
	if (points->count == 0)
		return tree;
	Build b = {.items = copy_points(points), .dimensions = points->emitter && points->emitter_weight > 0 ? 6 : 3};
	for (int k = 0; k < 6; k++)
		b.weight[k] = k < 3 ? 1 : points->emitter_weight;
	uint32_t largest = TREE_WIDTH;
	while (largest <= UINT32_MAX / TREE_WIDTH && largest * TREE_WIDTH < points->count)
		largest *= TREE_WIDTH;
#pragma omp parallel if (points->count > 20000)
#pragma omp single
	arrange(&b, 0, points->count, largest);
	fill_leaves(tree, points, b.items);
	free(b.items);
	build_levels(tree);
	return tree;
}

/* ---- Morton order ---- */

static uint64_t spread(uint32_t x)
{
	uint64_t v = x & 0x1fffff; /* 21 bits, two zeros between each */
	v = (v | v << 32) & 0x1f00000000ffff;
	v = (v | v << 16) & 0x1f0000ff0000ff;
	v = (v | v << 8) & 0x100f00f00f00f00f;
	v = (v | v << 4) & 0x10c30c30c30c30c3;
	return (v | v << 2) & 0x1249249249249249;
}

typedef struct Code {
	uint64_t code;
	uint32_t index;
} Code;

static int compare_codes(const void *a, const void *b)
{
	const Code *x = a, *y = b;
	if (x->code != y->code)
		return x->code < y->code ? -1 : 1;
	return x->index < y->index ? -1 : 1;
}

void photon_tree_morton(const float *position, uint32_t count, uint32_t stride, uint32_t *order)
{
	float lo[3] = {INFINITY, INFINITY, INFINITY}, size = 0;
	for (int pass = 0; pass < 2; pass++) {
		for (uint32_t i = 0; i < count; i++) {
			for (int k = 0; k < 3; k++) {
				float x = row(position, stride, i)[k];
				if (pass == 0)
					lo[k] = x < lo[k] ? x : lo[k];
				else
					size = x - lo[k] > size ? x - lo[k] : size;
			}
		}
	}
	float scale = size > 0 ? 2097151.0f / size : 0;
	Code *codes = memory_alloc(sizeof(Code) * count);
	for (uint32_t i = 0; i < count; i++) {
		const float *p = row(position, stride, i);
		codes[i] = (Code){0, i};
		for (int k = 0; k < 3; k++)
			codes[i].code |= spread((uint32_t)((p[k] - lo[k]) * scale)) << k;
	}
	qsort(codes, count, sizeof(Code), compare_codes);
	for (uint32_t i = 0; i < count; i++)
		order[i] = codes[i].index;
	free(codes);
}
