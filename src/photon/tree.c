#include "photon/tree.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/arena.h"
#include "photon/tree_build.h"

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__SANITIZE_ADDRESS__)
#define CLONES __attribute__((target_clones("avx2", "default")))
#else
#define CLONES
#endif

#define INLINE static inline __attribute__((always_inline))

void photon_tree_destroy(PhotonTree *tree)
{
	if (!tree)
		return;
	for (int i = 0; i < tree->level_count; i++) {
		free(tree->levels[i].boxes);
		free(tree->levels[i].emitter_boxes);
	}
	free(tree->leaves);
	free(tree->emitters);
	free(tree->lights);
	free(tree);
}

/* ---- eight at a time ---- */

INLINE void leaf_distances(const TreeLeaf *leaf, const float p[3], float d2[TREE_WIDTH])
{
	for (int i = 0; i < TREE_WIDTH; i++) {
		float dx = leaf->at[0][i] - p[0], dy = leaf->at[1][i] - p[1], dz = leaf->at[2][i] - p[2];
		d2[i] = dx * dx + dy * dy + dz * dz;
	}
}

INLINE float positive(float a) { return a > 0 ? a : 0; }

INLINE void box_distances(const TreeBoxes *boxes, const float p[3], float d2[TREE_WIDTH])
{
	for (int i = 0; i < TREE_WIDTH; i++) {
		float dx = positive(boxes->lo[0][i] - p[0]) + positive(p[0] - boxes->hi[0][i]);
		float dy = positive(boxes->lo[1][i] - p[1]) + positive(p[1] - boxes->hi[1][i]);
		float dz = positive(boxes->lo[2][i] - p[2]) + positive(p[2] - boxes->hi[2][i]);
		d2[i] = dx * dx + dy * dy + dz * dz;
	}
}

/* What does not match the emitter's range goes infinitely far away. */
INLINE void mask_boxes(const TreeBoxes *boxes, const EmitterRange *range, float d2[TREE_WIDTH])
{
	float e2[TREE_WIDTH];
	box_distances(boxes, range->center, e2);
	for (int i = 0; i < TREE_WIDTH; i++)
		d2[i] = e2[i] <= range->radius2 ? d2[i] : INFINITY;
}

INLINE void mask_leaf(const PhotonTree *tree, uint32_t leaf, const EmitterRange *range, float d2[TREE_WIDTH])
{
	float e2[TREE_WIDTH];
	leaf_distances(&tree->emitters[leaf], range->center, e2);
	const uint16_t *light = tree->lights + (size_t)leaf * TREE_WIDTH;
	for (int i = 0; i < TREE_WIDTH; i++)
		d2[i] = (e2[i] <= range->radius2) & (light[i] == range->light) ? d2[i] : INFINITY;
}

/* ---- the way down ---- */

/* A node still to be visited. level 0 is the leaves. */
typedef struct Pending {
	float distance2;
	uint32_t node;
	int level;
} Pending;

enum { STACK = TREE_WIDTH * TREE_MAX_LEVELS };

/* What is pushed will be visited soon: its cache lines may come meanwhile. */
INLINE void prefetch(const PhotonTree *tree, int level, uint32_t node)
{
	const char *at = level ? (const char *)&tree->levels[level - 1].boxes[node] : (const char *)&tree->leaves[node];
	__builtin_prefetch(at);
	__builtin_prefetch(at + 64);
	if (level)
		__builtin_prefetch(at + 128);
}

/* Pushes the children of a node that are nearer than bound, the nearest last. */
INLINE int push_children(const PhotonTree *tree, Pending *stack, int top, Pending node, const float d2[TREE_WIDTH],
                         float bound)
{
	int first = top;
	for (int i = 0; i < TREE_WIDTH; i++) {
		if (!(d2[i] < bound))
			continue;
		prefetch(tree, node.level - 1, node.node * TREE_WIDTH + (uint32_t)i);
		int k = top++;
		for (; k > first && stack[k - 1].distance2 < d2[i]; k--)
			stack[k] = stack[k - 1];
		stack[k] = (Pending){d2[i], node.node * TREE_WIDTH + (uint32_t)i, node.level - 1};
	}
	return top;
}

/* ---- k nearest ---- */

/*
 * Candidates are gathered unsorted, distances and indices in arrays of their own. When the store is full, a bound that
 * about the wanted number of them keep is found by counting (bisection over the floats' bit patterns, which rise with
 * the floats), and the others are dropped. Counting has no branches to mispredict and eight distances fit a register; a heap or
 * quickselect of the same size costs several times more.
 */
typedef struct Candidates {
	float *distance2;
	uint32_t *index;
	int count, wanted, capacity;
	float bound; /* farther ones need not come */
} Candidates;

INLINE float float_of(uint32_t bits)
{
	float f;
	memcpy(&f, &bits, sizeof f);
	return f;
}

INLINE uint32_t bits_of(float f)
{
	uint32_t bits;
	memcpy(&bits, &f, sizeof bits);
	return bits;
}

/* How many are nearer than the bound; the store is padded with infinities to a multiple of eight. */
INLINE int count_nearer(const Candidates *c, float bound)
{
	int lanes[TREE_WIDTH] = {0}, sum = 0;
	for (int i = 0; i < c->count; i += TREE_WIDTH) {
		for (int k = 0; k < TREE_WIDTH; k++)
			lanes[k] += c->distance2[i + k] < bound;
	}
	for (int k = 0; k < TREE_WIDTH; k++)
		sum += lanes[k];
	return sum;
}

INLINE void pad(Candidates *c)
{
	for (int k = 0; k < TREE_WIDTH; k++)
		c->distance2[c->count + k] = INFINITY;
}

INLINE void keep_nearer(Candidates *c, float bound)
{
	int kept = 0;
	for (int i = 0; i < c->count; i++) {
		float d2 = c->distance2[i];
		c->distance2[kept] = d2;
		c->index[kept] = c->index[i];
		kept += d2 < bound;
	}
	c->count = kept;
}

INLINE float farthest_of(const Candidates *c)
{
	float lanes[TREE_WIDTH] = {0};
	for (int i = 0; i < c->count; i += TREE_WIDTH) {
		for (int k = 0; k < TREE_WIDTH; k++) {
			float d2 = c->distance2[i + k];
			lanes[k] = d2 > lanes[k] && d2 < INFINITY ? d2 : lanes[k];
		}
	}
	float most = 0;
	for (int k = 0; k < TREE_WIDTH; k++)
		most = lanes[k] > most ? lanes[k] : most;
	return most;
}

/* The least bound that `wanted` to `wanted + spare` of the candidates are nearer than, or the last that more are. */
INLINE float find_bound(const Candidates *c, int spare)
{
	uint32_t lo = 0, hi = bits_of(farthest_of(c)) + 1; /* fewer than wanted are nearer than lo, not fewer than hi */
	while (hi - lo > 1) {
		uint32_t middle = lo + (hi - lo) / 2;
		/* The first guesses go by value: bit patterns crowd near zero. */
		if (hi - lo > 1u << 23)
			middle = bits_of(0.5f * (float_of(lo) + float_of(hi)));
		if (middle <= lo || middle >= hi)
			middle = lo + (hi - lo) / 2;
		int nearer = count_nearer(c, float_of(middle));
		if (nearer >= c->wanted) {
			hi = middle;
			if (nearer <= c->wanted + spare)
				break;
		} else {
			lo = middle;
		}
	}
	return float_of(hi);
}

/* Of several that are exactly as far as the farthest, the lowest indices stay; others still compete by theirs. */
static void break_ties(Candidates *c)
{
	pad(c);
	float farthest = farthest_of(c);
	while (c->count > c->wanted) {
		int worst = -1;
		for (int i = 0; i < c->count; i++) {
			if (c->distance2[i] == farthest && (worst < 0 || c->index[i] > c->index[worst]))
				worst = i;
		}
		c->count--;
		c->distance2[worst] = c->distance2[c->count];
		c->index[worst] = c->index[c->count];
	}
}

INLINE void tighten(Candidates *c, int spare)
{
	if (c->count <= c->wanted)
		return;
	pad(c);
	c->bound = find_bound(c, spare);
	keep_nearer(c, c->bound);
	if (c->count > c->wanted + spare)
		break_ties(c);
}

float photon_tree_farthest(const Neighbor *found, int count)
{
	float farthest = 0;
	for (int i = 0; i < count; i++)
		farthest = found[i].distance2 > farthest ? found[i].distance2 : farthest;
	return farthest;
}

INLINE void gather_leaf(const PhotonTree *tree, const NearestQuery *query, uint32_t leaf, Candidates *c)
{
	float d2[TREE_WIDTH];
	leaf_distances(&tree->leaves[leaf], query->center, d2);
	if (query->range)
		mask_leaf(tree, leaf, query->range, d2);
	const uint32_t *index = tree->leaves[leaf].index;
	int count = c->count;
	for (int i = 0; i < TREE_WIDTH; i++) {
		c->distance2[count] = d2[i];
		c->index[count] = index[i];
		count += d2[i] < c->bound;
	}
	c->count = count;
	if (count + TREE_WIDTH > c->capacity)
		tighten(c, c->wanted / 8 + 1);
}

INLINE void walk_nearest(const PhotonTree *tree, const NearestQuery *query, Candidates *c)
{
	Pending stack[STACK];
	int top = 0;
	if (tree->count > 0 && query->count > 0)
		stack[top++] = (Pending){0, 0, tree->level_count};
	while (top > 0) {
		Pending node = stack[--top];
		if (!(node.distance2 < c->bound))
			continue;
		if (node.level == 0) {
			gather_leaf(tree, query, node.node, c);
			continue;
		}
		const TreeLevel *level = &tree->levels[node.level - 1];
		float d2[TREE_WIDTH];
		box_distances(&level->boxes[node.node], query->center, d2);
		if (query->range)
			mask_boxes(&level->emitter_boxes[node.node], query->range, d2);
		top = push_children(tree, stack, top, node, d2, c->bound);
	}
}

/* Candidates beyond the wanted ones that may wait for the next count. */
enum { SPARE = 32 };

CLONES int photon_tree_nearest(const PhotonTree *tree, const NearestQuery *query, Neighbor *out)
{
	int capacity = query->count + SPARE + query->count / 4 + TREE_WIDTH;
	float distance2[capacity + TREE_WIDTH];
	uint32_t index[capacity + TREE_WIDTH];
	Candidates c = {distance2, index, 0, query->count, capacity, query->max_distance2};
	walk_nearest(tree, query, &c);
	tighten(&c, 0);
	for (int i = 0; i < c.count; i++)
		out[i] = (Neighbor){distance2[i], index[i]};
	return c.count;
}

/* ---- fixed radius ---- */

enum { BATCH = 256 };

INLINE int append_within(const PhotonTree *tree, uint32_t leaf, const float center[3], float radius2, Neighbor *out)
{
	float d2[TREE_WIDTH];
	leaf_distances(&tree->leaves[leaf], center, d2);
	const uint32_t *index = tree->leaves[leaf].index;
	int count = 0;
	for (int i = 0; i < TREE_WIDTH; i++) {
		out[count] = (Neighbor){d2[i], index[i]};
		count += d2[i] < radius2;
	}
	return count;
}

CLONES void photon_tree_within(const PhotonTree *tree, const float center[3], float radius, TreeVisit *visit, void *data)
{
	uint32_t stack[STACK];
	int levels[STACK], top = 0, count = 0;
	Neighbor batch[BATCH + TREE_WIDTH];
	float radius2 = radius * radius;
	if (tree->count > 0) {
		stack[top] = 0;
		levels[top++] = tree->level_count;
	}
	while (top > 0) {
		uint32_t node = stack[--top];
		int level = levels[top];
		if (level == 0) {
			count += append_within(tree, node, center, radius2, batch + count);
			if (count >= BATCH) {
				visit(data, batch, count);
				count = 0;
			}
			continue;
		}
		float d2[TREE_WIDTH];
		box_distances(&tree->levels[level - 1].boxes[node], center, d2);
		for (int i = 0; i < TREE_WIDTH; i++) {
			uint32_t child = node * TREE_WIDTH + (uint32_t)i;
			if (!(d2[i] < radius2))
				continue;
			prefetch(tree, level - 1, child);
			stack[top] = child;
			levels[top++] = level - 1;
		}
	}
	if (count > 0)
		visit(data, batch, count);
}
