#include "photon/tree_order.h"

#include <assert.h>
#include <math.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

#include "base/arena.h"
#include "photon/group.h"

static const float *row(const float *base, uint32_t stride, uint32_t i)
{
	return (const float *)((const char *)base + (size_t)stride * i);
}

/* Queries jump about, and would miss small pages' table entries. */
void *tree_alloc(size_t count, size_t size)
{
	return memory_alloc_wide(count * size);
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

/* Only the last node of a level may lack children. */
static TreeBoxes *make_boxes(uint32_t count)
{
	TreeBoxes *boxes = tree_alloc(count, sizeof *boxes);
	clear_boxes(&boxes[count - 1]);
	return boxes;
}

static void make_levels(PhotonTree *tree, bool with_emitters)
{
	uint32_t below = tree->leaf_count;
	do {
		TreeLevel *level = &tree->levels[tree->level_count++];
		assert(tree->level_count <= TREE_MAX_LEVELS);
		level->count = (below + TREE_WIDTH - 1) / TREE_WIDTH;
		level->boxes = make_boxes(level->count);
		if (with_emitters)
			level->emitter_boxes = make_boxes(level->count);
		below = level->count;
	} while (below > 1);
}

PhotonTree *tree_create(const TreePoints *points, const TreeOrderer *orderer)
{
	PhotonTree *tree = memory_alloc(sizeof *tree);
	*tree = (PhotonTree){.count = points->count};
	tree->leaf_count = (points->count + TREE_WIDTH - 1) / TREE_WIDTH;
	if (points->count == 0)
		return tree;
	assert(points->count <= INT32_MAX);
	tree->leaves = tree_alloc(tree->leaf_count, sizeof(TreeLeaf));
	if (points->emitter) {
		tree->emitters = tree_alloc(tree->leaf_count, sizeof(TreeLeaf));
		tree->lights = tree_alloc((size_t)tree->leaf_count * TREE_WIDTH, sizeof(uint16_t));
	}
	make_levels(tree, points->emitter);
	tree_order(tree, points, orderer);
	return tree;
}

PhotonTree *photon_tree_create(const TreePoints *points)
{
#ifdef TREE_HAS_AVX2
	if (tree_has_avx2())
		return tree_create(points, &tree_orderer_avx2);
#endif
	return tree_create(points, &tree_orderer_plain);
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
	uint64_t *codes = memory_alloc(sizeof *codes * ((size_t)count + 1));
	for (uint32_t i = 0; i < count; i++) {
		const float *p = row(position, stride, i);
		codes[i] = 0;
		for (int k = 0; k < 3; k++)
			codes[i] |= spread((uint32_t)((p[k] - lo[k]) * scale)) << k;
	}
	photon_group(codes, count, order);
	free(codes);
}
