#include "photon/tree_build.h"

#include <assert.h>
#include <math.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>

#include "base/arena.h"

static const float *row(const float *base, uint32_t stride, uint32_t i)
{
	return (const float *)((const char *)base + (size_t)stride * i);
}

enum { LARGE_PAGE = 1 << 21 };

/* Large arrays are asked for in large pages: queries jump about, and would miss small pages'
 * table entries. */
void *tree_alloc(size_t count, size_t size)
{
	size_t bytes = count * size, unit = bytes < LARGE_PAGE ? 64 : LARGE_PAGE;
	bytes = (bytes + unit - 1) / unit * unit;
	void *memory = aligned_alloc(unit, bytes);
	if (!memory)
		memory_alloc(SIZE_MAX / 2); /* ends the program with the usual message */
#ifdef MADV_HUGEPAGE
	if (unit == LARGE_PAGE)
		madvise(memory, bytes, MADV_HUGEPAGE);
#endif
	return memory;
}

static uint32_t number_of(const TreeItems *order, uint32_t at)
{
	uint32_t number;
	size_t words = (size_t)order->words;
	memcpy(&number, &order->items[words * at + words - 1], sizeof number);
	return number;
}

static void fill_slot(TreeLeaf *leaf, int slot, const float *at)
{
	for (int k = 0; k < 3; k++)
		leaf->at[k][slot] = at ? at[k] : INFINITY;
}

static void fill_leaves(PhotonTree *tree, const TreePoints *points, const TreeItems *order)
{
	uint32_t slots = tree->leaf_count * TREE_WIDTH;
	tree->leaves = tree_alloc(tree->leaf_count, sizeof(TreeLeaf));
	for (uint32_t i = 0; i < slots; i++) {
		TreeLeaf *leaf = &tree->leaves[i / TREE_WIDTH];
		bool there = i < points->count;
		fill_slot(leaf, i % TREE_WIDTH,
			  there ? &order->items[(size_t)order->words * i] : NULL);
		leaf->index[i % TREE_WIDTH] = there ? number_of(order, i) : 0;
	}
}

static void fill_emitters(PhotonTree *tree, const TreePoints *points, const TreeItems *order)
{
	uint32_t slots = tree->leaf_count * TREE_WIDTH;
	tree->emitters = tree_alloc(tree->leaf_count, sizeof(TreeLeaf));
	tree->lights = tree_alloc(slots, sizeof(uint16_t));
	for (uint32_t i = 0; i < slots; i++) {
		bool there = i < points->count;
		uint32_t number = there ? number_of(order, i) : 0;
		fill_slot(&tree->emitters[i / TREE_WIDTH], i % TREE_WIDTH,
		          there ? row(points->emitter, points->stride, number) : NULL);
		memcpy(&tree->lights[i],
		       (const char *)points->light + (size_t)points->stride * number,
		       sizeof *tree->lights);
	}
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

/* Child `slot` of a node covers the values from lo to hi; the infinities of missing points do
 * not count. */
static void cover(TreeBoxes *boxes, int slot, int axis, const float *lo, const float *hi)
{
	float least = INFINITY, most = -INFINITY;
	for (int i = 0; i < TREE_WIDTH; i++) {
		float top = hi[i] < INFINITY ? hi[i] : -INFINITY;
		least = lo[i] < least ? lo[i] : least;
		most = top > most ? top : most;
	}
	boxes->lo[axis][slot] = least;
	boxes->hi[axis][slot] = most;
}

static TreeBoxes *boxes_of_leaves(const TreeLeaf *leaves, uint32_t leaf_count, uint32_t count)
{
	TreeBoxes *boxes = tree_alloc(count, sizeof *boxes);
	for (uint32_t n = 0; n < count; n++)
		clear_boxes(&boxes[n]);
	for (uint32_t n = 0; n < leaf_count; n++) {
		for (int k = 0; k < 3; k++)
			cover(&boxes[n / TREE_WIDTH], (int)(n % TREE_WIDTH), k, leaves[n].at[k],
			      leaves[n].at[k]);
	}
	return boxes;
}

static TreeBoxes *boxes_of_nodes(const TreeBoxes *nodes, uint32_t node_count, uint32_t count)
{
	TreeBoxes *boxes = tree_alloc(count, sizeof *boxes);
	for (uint32_t n = 0; n < count; n++)
		clear_boxes(&boxes[n]);
	for (uint32_t n = 0; n < node_count; n++) {
		for (int k = 0; k < 3; k++)
			cover(&boxes[n / TREE_WIDTH], (int)(n % TREE_WIDTH), k, nodes[n].lo[k],
			      nodes[n].hi[k]);
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
			level->emitter_boxes = first ? boxes_of_leaves(tree->emitters, below,
								       level->count)
						     : boxes_of_nodes(last->emitter_boxes, below,
								      level->count);
		below = level->count;
	} while (below > 1);
}

PhotonTree *photon_tree_create(const TreePoints *points)
{
	PhotonTree *tree = memory_alloc(sizeof *tree);
	*tree = (PhotonTree){.count = points->count};
	tree->leaf_count = (points->count + TREE_WIDTH - 1) / TREE_WIDTH;
	if (points->count == 0)
		return tree;
	TreeItems order = tree_order(points);
	fill_leaves(tree, points, &order);
	if (points->emitter)
		fill_emitters(tree, points, &order);
	free(order.items);
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
