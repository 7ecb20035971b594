/*
 * The queries' bodies, compiled once for each instruction set: a file that includes this defines,
 * on eight floats at a time (type Eight),
 *
 *   eight_load                of eight floats in a row
 *   eight_leaf, eight_box     squared distances of a leaf's points, of a node's children
 *   eight_less, eight_most    bit mask of those less than, or at most, a bound
 *   eight_least               which of a mask's is the least
 *   eight_lights              bit mask of the lights that are the given one
 *   eight_compact             stores those of a mask, packed, with their indices; all of these
 *                             write eight places
 *   eight_pairs               the same as neighbours
 *   eight_pack                the same without indices
 *   eight_numbers             stores numbers of a mask's lanes, packed
 *   eight_count               how many of an array's values are less than a bound
 *   eight_farthest            the largest of an array's finite values
 *   eight_find_least          where an array's least value is
 *
 * and QUERY_NEAREST and QUERY_WITHIN, the names of what this defines.
 *
 * A query for the k nearest first looks into the few nearest nodes with leaves, one after the
 * other, which gives a bound that little else is within. Then all nodes within that bound are
 * looked at in one loop, without an order: it doesn't branch on what it finds, and the processor
 * fetches many nodes and leaves at a time.
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

/* ---- nodes to visit ---- */

/*
 * Nodes still to be looked at, and leaves that were met. Which of eight children are near is as
 * good as random, so nothing branches on it: children are packed behind the others, and loops run
 * over many of them.
 */
enum { CROWDED = 256, LEAVES = 64, LEVEL_BITS = 4 };
typedef struct Walk {
	const PhotonTree *tree;
	const float *center;
	const EmitterRange *range;
	int count, leaf_count;
	float distance2[CROWDED + TREE_WIDTH * (TREE_MAX_LEVELS + 1)];
	uint32_t node[CROWDED + TREE_WIDTH * (TREE_MAX_LEVELS + 1)]; /* number and level */
	uint32_t leaves[LEAVES + TREE_WIDTH];
} Walk;

INLINE void start_walk(Walk *w, const PhotonTree *tree, const float *center,
		       const EmitterRange *range)
{
	w->tree = tree;
	w->center = center;
	w->range = range;
	w->count = 1;
	w->leaf_count = 0;
	w->distance2[0] = 0;
	w->node[0] = (uint32_t)tree->level_count;
}

/* Which children of a node, lowest level 1, may hold what is nearer than the bound. */
INLINE unsigned near_children(const Walk *w, uint32_t number, uint32_t level, float bound,
			      Eight *d2)
{
	const TreeLevel *here = &w->tree->levels[level - 1];
	*d2 = eight_box(&here->boxes[number], w->center);
	unsigned mask = eight_less(*d2, bound);
	if (!w->range)
		return mask;
	Eight emitter = eight_box(&here->emitter_boxes[number], w->range->center);
	return mask & eight_most(emitter, w->range->radius2);
}

INLINE void add_leaves(Walk *w, uint32_t parent, unsigned mask)
{
	eight_numbers(w->leaves + w->leaf_count, parent * TREE_WIDTH, 1, mask);
	w->leaf_count += __builtin_popcount(mask);
}

/* What stands for a node's first child; the others follow in steps. */
INLINE uint32_t first_child(uint32_t number, uint32_t level)
{
	return number * TREE_WIDTH << LEVEL_BITS | (level - 1);
}

INLINE void add_nodes(Walk *w, uint32_t number, uint32_t level, unsigned mask, Eight d2)
{
	eight_pack(w->distance2 + w->count, d2, mask);
	eight_numbers(w->node + w->count, first_child(number, level), 1 << LEVEL_BITS, mask);
	w->count += __builtin_popcount(mask);
}

/* From a node down to the leaves of what is nearest below it; the rest waits. */
INLINE void descend(Walk *w, uint32_t node, float bound)
{
	uint32_t number = node >> LEVEL_BITS, level = node & ((1 << LEVEL_BITS) - 1);
	Eight d2;
	for (; level > 1; level--) {
		unsigned mask = near_children(w, number, level, bound, &d2);
		if (mask == 0)
			return;
		unsigned nearest = eight_least(d2, mask);
		add_nodes(w, number, level, mask & ~(1u << nearest), d2);
		number = number * TREE_WIDTH + nearest;
	}
	add_leaves(w, number, near_children(w, number, 1, bound, &d2));
}

/* Takes the nearest node, or the last while there are many of them, so that their number is
 * bounded. */
INLINE uint32_t take_nearest(Walk *w)
{
	int at = w->count - 1;
	if (w->count <= CROWDED)
		at = eight_find_least(w->distance2, w->count);
	uint32_t node = w->node[at];
	w->count--;
	w->node[at] = w->node[w->count];
	w->distance2[at] = w->distance2[w->count];
	return node;
}

/* ---- k nearest ---- */

/* The points of a leaf that match the emitter's range. */
INLINE unsigned leaf_matches(const PhotonTree *tree, uint32_t leaf, const EmitterRange *range)
{
	unsigned near = eight_most(eight_leaf(&tree->emitters[leaf], range->center),
				   range->radius2);
	return near & eight_lights(tree->lights + (size_t)leaf * TREE_WIDTH, range->light);
}

INLINE void gather_leaves(Walk *w, Candidates *c)
{
	for (int i = 0; i < w->leaf_count; i++) {
		const TreeLeaf *leaf = &w->tree->leaves[w->leaves[i]];
		Eight d2 = eight_leaf(leaf, w->center);
		unsigned mask = eight_less(d2, c->bound);
		if (w->range)
			mask &= leaf_matches(w->tree, w->leaves[i], w->range);
		eight_compact(c->distance2 + c->count, c->index + c->count, d2, leaf->index, mask);
		c->count += __builtin_popcount(mask);
		if (c->count + TREE_WIDTH > c->capacity)
			tighten(c, c->wanted / 8 + 1);
	}
	w->leaf_count = 0;
}

/* Drops what the bound excludes by now. */
INLINE void drop_nodes(Walk *w, float bound)
{
	int kept = 0;
	for (int k = 0; k < TREE_WIDTH; k++)
		w->distance2[w->count + k] = INFINITY;
	for (int i = 0; i < w->count; i += TREE_WIDTH) {
		Eight d2 = eight_load(w->distance2 + i);
		unsigned mask = eight_less(d2, bound);
		eight_compact(w->distance2 + kept, w->node + kept, d2, w->node + i, mask);
		kept += __builtin_popcount(mask);
	}
	w->count = kept;
}

/*
 * The nearest nodes with leaves, until there are enough points for a bound that leaves little
 * else: two or three times the wanted ones, by trial.
 */
INLINE void seek_bound(Walk *w, Candidates *c)
{
	int enough = 4 * c->wanted, most = c->wanted + c->wanted / 4 + 2 * TREE_WIDTH * TREE_WIDTH;
	int met = 0;
	enough = enough < most ? enough : most;
	while (w->count > 0 && (met < enough || c->count < c->wanted)) {
		descend(w, take_nearest(w), c->bound);
		met += TREE_WIDTH * TREE_WIDTH;
		gather_leaves(w, c);
	}
	tighten(c, c->wanted / 4 + 1);
}

/* The first that waits, or the last while there are many. */
INLINE uint32_t take_next(Walk *w, int *head)
{
	return w->count <= CROWDED ? w->node[(*head)++] : w->node[--w->count];
}

INLINE void expand(Walk *w, uint32_t node, float bound)
{
	uint32_t number = node >> LEVEL_BITS, level = node & ((1 << LEVEL_BITS) - 1);
	Eight d2;
	unsigned mask = near_children(w, number, level, bound, &d2);
	if (level == 1) {
		add_leaves(w, number, mask);
		return;
	}
	eight_numbers(w->node + w->count, first_child(number, level), 1 << LEVEL_BITS, mask);
	w->count += __builtin_popcount(mask);
}

INLINE void walk_nearest(Walk *w, Candidates *c)
{
	seek_bound(w, c);
	drop_nodes(w, c->bound);
	for (int head = 0; head < w->count;) {
		expand(w, take_next(w, &head), c->bound);
		if (w->leaf_count > LEAVES - TREE_WIDTH)
			gather_leaves(w, c);
	}
	gather_leaves(w, c);
}

/* Candidates beyond the wanted ones that may wait for the next count. */
enum { SPARE = 192 };

int QUERY_NEAREST(const PhotonTree *tree, const NearestQuery *query, Neighbor *out)
{
	if (tree->count == 0 || query->count <= 0)
		return 0;
	int capacity = query->count + query->count / 4 + SPARE + TREE_WIDTH;
	float distance2[capacity + TREE_WIDTH];
	uint32_t index[capacity + TREE_WIDTH];
	Candidates c = {distance2, index, 0, query->count, capacity, query->max_distance2};
	Walk w;
	start_walk(&w, tree, query->center, query->range);
	walk_nearest(&w, &c);
	tighten(&c, 0);
	for (int i = 0; i < c.count; i++)
		out[i] = (Neighbor){distance2[i], index[i]};
	return c.count;
}

/* ---- fixed radius ---- */

enum { BATCH = 256 };

typedef struct Within {
	Walk walk;
	float radius2;
	TreeVisit *visit;
	void *data;
	int count;
	Neighbor batch[BATCH + TREE_WIDTH];
} Within;

INLINE void visit_leaves(Within *w)
{
	for (int i = 0; i < w->walk.leaf_count; i++) {
		const TreeLeaf *leaf = &w->walk.tree->leaves[w->walk.leaves[i]];
		Eight d2 = eight_leaf(leaf, w->walk.center);
		unsigned mask = eight_less(d2, w->radius2);
		eight_pairs(w->batch + w->count, d2, leaf->index, mask);
		w->count += __builtin_popcount(mask);
		if (w->count > BATCH - TREE_WIDTH) {
			w->visit(w->data, w->batch, w->count);
			w->count = 0;
		}
	}
	w->walk.leaf_count = 0;
}

INLINE void walk_within(Within *w)
{
	for (int head = 0; head < w->walk.count;) {
		expand(&w->walk, take_next(&w->walk, &head), w->radius2);
		if (w->walk.leaf_count > LEAVES - TREE_WIDTH)
			visit_leaves(w);
	}
	visit_leaves(w);
}

void QUERY_WITHIN(const PhotonTree *tree, const WithinQuery *query, TreeVisit *visit, void *data)
{
	Within w; /* arrays stay as they are: zeroing them would cost as much as a small query */
	if (tree->count == 0)
		return;
	start_walk(&w.walk, tree, query->center, NULL);
	w.radius2 = query->radius * query->radius;
	w.visit = visit;
	w.data = data;
	w.count = 0;
	walk_within(&w);
	if (w.count > 0)
		visit(data, w.batch, w.count);
}
