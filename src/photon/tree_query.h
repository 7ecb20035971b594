/*
 * The queries' bodies, compiled once for each instruction set: a file that includes this defines,
 * on eight floats at a time (type Eight),
 *
 *   eight_leaf, eight_box     squared distances of a leaf's points, of a node's children, to a
 * point eight_less, eight_most    bit mask of those less than, or at most, a bound eight_least
 * which is the least eight_lights              bit mask of the lights that are the given one
 *   eight_compact             stores those of a mask, packed, with their indices; writes eight
 * places eight_pairs               the same as neighbours eight_count               how many of an
 * array's values are less than a bound
 *
 * and QUERY_NEAREST and QUERY_WITHIN, the names of what this defines.
 */
#include <math.h>
#include <string.h>

/* ---- candidates ---- */

/*
 * The k nearest so far are gathered unsorted, distances and indices in arrays of their own. When
 * the store is full, a bound that about the wanted number of them keep is found by counting, and
 * the others are dropped. Counting has no branches to mispredict and eight distances fit a
 * register; a heap or quickselect of the same size costs several times more.
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

/* Counting goes by eight: the store is padded with infinities. */
INLINE void pad(Candidates *c)
{
	for (int k = 0; k < TREE_WIDTH; k++)
		c->distance2[c->count + k] = INFINITY;
}

INLINE void keep_nearer(Candidates *c, float bound)
{
	int kept = 0;
	for (int i = 0; i < c->count; i += TREE_WIDTH) {
		Eight d2 = eight_load(c->distance2 + i);
		unsigned mask = eight_less(d2, bound);
		eight_compact(c->distance2 + kept, c->index + kept, d2, c->index + i, mask);
		kept += __builtin_popcount(mask);
	}
	c->count = kept;
}

/* A bound to try between lo and hi, where below_lo < wanted <= below_hi candidates are nearer
 * than those: by proportion, or in the middle of their bit patterns, which rise with the
 * floats. */
INLINE uint32_t guess_between(uint32_t lo, uint32_t hi, float share)
{
	uint32_t by_value = bits_of(float_of(lo) + share * (float_of(hi) - float_of(lo)));
	return by_value > lo && by_value < hi ? by_value : lo + (hi - lo) / 2;
}

/* The least bound that `wanted` to `wanted + spare` of the candidates are nearer than, or the
 * last that more are. */
INLINE float find_bound(const Candidates *c, int spare)
{
	uint32_t lo = 0, hi = bits_of(eight_farthest(c->distance2, c->count)) + 1;
	int below_lo = 0, below_hi = c->count;
	for (int step = 0; hi - lo > 1 && below_hi > c->wanted + spare; step++) {
		float share = (c->wanted + 0.5f * spare - below_lo) / (below_hi - below_lo);
		/* Proportion alone can creep: every third step halves, by value and then by bits.
		 */
		uint32_t middle = lo + (hi - lo) / 2;
		if (step < 24)
			middle = guess_between(lo, hi, step % 3 == 2 ? 0.5f : share);
		int nearer = eight_count(c->distance2, c->count, float_of(middle));
		if (nearer >= c->wanted) {
			hi = middle;
			below_hi = nearer;
		} else {
			lo = middle;
			below_lo = nearer;
		}
	}
	return float_of(hi);
}

/* Of several that are exactly as far as the farthest, the lowest indices stay; others still
 * compete by theirs. */
static void break_ties(Candidates *c)
{
	pad(c);
	float farthest = eight_farthest(c->distance2, c->count);
	while (c->count > c->wanted) {
		int worst = -1;
		for (int i = 0; i < c->count; i++) {
			if (c->distance2[i] == farthest &&
			    (worst < 0 || c->index[i] > c->index[worst]))
				worst = i;
		}
		c->count--;
		c->distance2[worst] = c->distance2[c->count];
		c->index[worst] = c->index[c->count];
	}
}

static void tighten(Candidates *c, int spare)
{
	if (c->count <= c->wanted)
		return;
	pad(c);
	c->bound = find_bound(c, spare);
	keep_nearer(c, c->bound);
	if (c->count > c->wanted + spare)
		break_ties(c);
}

/* ---- the way down ---- */

/* A node still to be visited. level 1 has leaves below. */
typedef struct Pending {
	float distance2;
	uint32_t node;
	int level;
} Pending;

/* What is pushed will be visited soon: its cache lines may come meanwhile. */
INLINE void prefetch_leaves(const PhotonTree *tree, uint32_t first, unsigned mask)
{
	for (; mask; mask &= mask - 1) {
		const char *at = (const char *)&tree->leaves[first + (unsigned)__builtin_ctz(mask)];
		__builtin_prefetch(at);
		__builtin_prefetch(at + 64);
	}
}

INLINE void prefetch_boxes(const TreeBoxes *boxes)
{
	const char *at = (const char *)boxes;
	__builtin_prefetch(at);
	__builtin_prefetch(at + 64);
	__builtin_prefetch(at + 128);
}

INLINE Pending child_of(const PhotonTree *tree, const Pending *node, int slot, float distance2)
{
	Pending child = {distance2, node->node * TREE_WIDTH + (uint32_t)slot, node->level - 1};
	prefetch_boxes(&tree->levels[child.level - 1].boxes[child.node]);
	return child;
}

typedef struct Stack {
	Pending nodes[TREE_WIDTH * TREE_MAX_LEVELS];
	int count;
} Stack;

/* Pushes the children of a mask, the nearest last. */
INLINE void push_children(const PhotonTree *tree, Stack *stack, Pending node, Eight d2,
			  unsigned mask)
{
	float distance2[TREE_WIDTH];
	int nearest = eight_least(d2);
	eight_store(distance2, d2);
	for (unsigned rest = mask & ~(1u << nearest); rest; rest &= rest - 1) {
		int slot = __builtin_ctz(rest);
		stack->nodes[stack->count++] = child_of(tree, &node, slot, distance2[slot]);
	}
	if (mask >> nearest & 1)
		stack->nodes[stack->count++] = child_of(tree, &node, nearest, distance2[nearest]);
}

/* ---- k nearest ---- */

/* The points of a leaf that match the emitter's range. */
INLINE unsigned leaf_matches(const PhotonTree *tree, uint32_t leaf, const EmitterRange *range)
{
	unsigned near = eight_most(eight_leaf(&tree->emitters[leaf], range->center),
				   range->radius2);
	return near & eight_lights(tree->lights + (size_t)leaf * TREE_WIDTH, range->light);
}

INLINE void gather_leaf(const PhotonTree *tree, const NearestQuery *query, uint32_t leaf,
			Candidates *c)
{
	Eight d2 = eight_leaf(&tree->leaves[leaf], query->center);
	unsigned mask = eight_less(d2, c->bound);
	if (query->range)
		mask &= leaf_matches(tree, leaf, query->range);
	eight_compact(c->distance2 + c->count, c->index + c->count, d2, tree->leaves[leaf].index,
		      mask);
	c->count += __builtin_popcount(mask);
	if (c->count + TREE_WIDTH > c->capacity)
		tighten(c, c->wanted / 8 + 1);
}

/* The children of a node that may hold nearer points. */
INLINE unsigned children_nearer(const PhotonTree *tree, const NearestQuery *query, Pending node,
                                float bound, Eight *d2)
{
	const TreeLevel *level = &tree->levels[node.level - 1];
	*d2 = eight_box(&level->boxes[node.node], query->center);
	unsigned mask = eight_less(*d2, bound);
	if (!query->range)
		return mask;
	Eight emitter = eight_box(&level->emitter_boxes[node.node], query->range->center);
	return mask & eight_most(emitter, query->range->radius2);
}

INLINE void walk_nearest(const PhotonTree *tree, const NearestQuery *query, Candidates *c)
{
	Stack stack;
	stack.nodes[0] = (Pending){0, 0, tree->level_count};
	stack.count = 1;
	while (stack.count > 0) {
		Pending node = stack.nodes[--stack.count];
		Eight d2;
		if (!(node.distance2 < c->bound))
			continue;
		unsigned mask = children_nearer(tree, query, node, c->bound, &d2);
		if (node.level > 1) {
			push_children(tree, &stack, node, d2, mask);
			continue;
		}
		prefetch_leaves(tree, node.node * TREE_WIDTH, mask);
		for (; mask; mask &= mask - 1)
			gather_leaf(tree, query,
				    node.node * TREE_WIDTH + (unsigned)__builtin_ctz(mask), c);
	}
}

/* Candidates beyond the wanted ones that may wait for the next count. */
enum { SPARE = 32 };

int QUERY_NEAREST(const PhotonTree *tree, const NearestQuery *query, Neighbor *out)
{
	if (tree->count == 0 || query->count <= 0)
		return 0;
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

typedef struct Within {
	const PhotonTree *tree;
	const float *center;
	float radius2;
	TreeVisit *visit;
	void *data;
	int count;
	Neighbor batch[BATCH + TREE_WIDTH];
} Within;

INLINE void visit_leaf(Within *w, uint32_t leaf)
{
	Eight d2 = eight_leaf(&w->tree->leaves[leaf], w->center);
	unsigned mask = eight_less(d2, w->radius2);
	eight_pairs(w->batch + w->count, d2, w->tree->leaves[leaf].index, mask);
	w->count += __builtin_popcount(mask);
	if (w->count > BATCH - TREE_WIDTH) {
		w->visit(w->data, w->batch, w->count);
		w->count = 0;
	}
}

INLINE void walk_within(Within *w)
{
	const PhotonTree *tree = w->tree;
	Stack stack;
	stack.nodes[0] = (Pending){0, 0, tree->level_count};
	stack.count = 1;
	while (stack.count > 0) {
		Pending node = stack.nodes[--stack.count];
		Eight d2 = eight_box(&tree->levels[node.level - 1].boxes[node.node], w->center);
		unsigned mask = eight_less(d2, w->radius2);
		if (node.level > 1) {
			for (; mask; mask &= mask - 1)
				stack.nodes[stack.count++] = child_of(tree, &node,
								      __builtin_ctz(mask), 0);
			continue;
		}
		prefetch_leaves(tree, node.node * TREE_WIDTH, mask);
		for (; mask; mask &= mask - 1)
			visit_leaf(w, node.node * TREE_WIDTH + (unsigned)__builtin_ctz(mask));
	}
}

void QUERY_WITHIN(const PhotonTree *tree, const WithinQuery *query, TreeVisit *visit, void *data)
{
	Within w; /* the batch stays as it is: zeroing it would cost as much as a small query */
	w.tree = tree;
	w.center = query->center;
	w.radius2 = query->radius * query->radius;
	w.visit = visit;
	w.data = data;
	w.count = 0;
	if (tree->count > 0)
		walk_within(&w);
	if (w.count > 0)
		visit(data, w.batch, w.count);
}
