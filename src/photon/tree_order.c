/*
 * The order of the tree's points: a run of up to 8^l points is cut into eight runs of 8^(l-1) by
 * three binary cuts, each at the multiple of the child's size that is nearest to the middle,
 * across the dimension of largest extent. Runs that are a child are that node's box, and those of
 * up to eight points a leaf.
 *
 * A point's place is decided by keys and numbers alone, so any instruction set and any number of
 * threads leave the same tree.
 */
#include "photon/tree_order.h"

#include <math.h>
#include <stdbool.h>
#include <stdlib.h>

/* Up to so many points are one thread's work. */
enum { FEW = 20000 };

typedef struct Order {
	PhotonTree *tree;
	const TreePoints *points;
	const TreeOrderer *orderer;
	int32_t *columns[2][TREE_COLUMNS]; /* the sides */
	int dimensions;
	float weight[TREE_COLUMNS];
} Order;

/* Points from first on that are children of a node of the level, or several of them. */
typedef struct Part {
	uint32_t first, count, child; /* points a child */
	int level, side;
} Part;

static const float *row(const float *base, uint32_t stride, uint32_t i)
{
	return (const float *)((const char *)base + (size_t)stride * i);
}

static TreeRun run_of(const Order *o, const Part *part)
{
	TreeRun run = {.dimensions = o->dimensions, .count = part->count};
	for (int k = 0; k <= o->dimensions; k++) {
		run.here[k] = o->columns[part->side][k] + part->first;
		run.there[k] = o->columns[!part->side][k] + part->first;
	}
	return run;
}

/* ---- leaves and boxes ---- */

static void set_box(TreeBoxes *boxes, uint32_t child, const int32_t *lo, const int32_t *hi)
{
	TreeBoxes *b = &boxes[child / TREE_WIDTH];
	for (int k = 0; k < 3; k++) {
		b->lo[k][child % TREE_WIDTH] = tree_value(lo[k]);
		b->hi[k][child % TREE_WIDTH] = tree_value(hi[k]);
	}
}

static void set_boxes(const Order *o, const Part *part, const TreeExtent *e)
{
	const TreeLevel *level = &o->tree->levels[part->level];
	uint32_t child = part->first / part->child;
	set_box(level->boxes, child, e->lo, e->hi);
	if (level->emitter_boxes)
		set_box(level->emitter_boxes, child, e->lo + 3, e->hi + 3);
}

static void fill_values(TreeLeaf *leaf, int32_t *const *columns, const int32_t *numbers,
			uint32_t count)
{
	for (uint32_t i = 0; i < TREE_WIDTH; i++)
		leaf->index[i] = (uint32_t)numbers[i];
	for (int k = 0; k < 3; k++) {
#pragma omp simd
		for (uint32_t i = 0; i < TREE_WIDTH; i++)
			leaf->at[k][i] = tree_value(columns[k][i]);
	}
	for (uint32_t i = count; i < TREE_WIDTH; i++) {
		leaf->index[i] = 0;
		leaf->at[0][i] = leaf->at[1][i] = leaf->at[2][i] = INFINITY;
	}
}

static void fill_leaf(const Order *o, uint32_t number, const TreeRun *run)
{
	const int32_t *numbers = run->here[run->dimensions];
	TreeLeaf *leaf = &o->tree->leaves[number];
	fill_values(leaf, run->here, numbers, run->count);
	if (!o->tree->emitters)
		return;
	fill_values(&o->tree->emitters[number], run->here + 3, numbers, run->count);
	for (uint32_t i = 0; i < TREE_WIDTH; i++)
		memcpy(&o->tree->lights[number * TREE_WIDTH + i],
		       (const char *)o->points->light +
			       (size_t)o->points->stride * leaf->index[i],
		       sizeof *o->tree->lights);
}

/* ---- cuts ---- */

static int widest(const Order *o, const TreeExtent *e)
{
	int best = 0;
	float most = -1;
	for (int k = 0; k < o->dimensions; k++) {
		float width = o->weight[k] * (tree_value(e->hi[k]) - tree_value(e->lo[k]));
		if (width > most) {
			most = width;
			best = k;
		}
	}
	return best;
}

/* Sets the boxes that a part's extent says, and the leaf if it is one. */
static bool is_finished(const Order *o, Part *part, const TreeRun *run, const TreeExtent *e)
{
	while (part->count <= part->child) {
		set_boxes(o, part, e);
		if (part->level == 0) {
			fill_leaf(o, part->first / TREE_WIDTH, run);
			return true;
		}
		part->level--;
		part->child /= TREE_WIDTH;
	}
	return false;
}

/* Cuts a part in two, unless it is a leaf already. */
static bool cut(const Order *o, Part part, Part *left, Part *right)
{
	TreeRun run = run_of(o, &part);
	TreeExtent e;
	o->orderer->extent(&run, &e);
	if (is_finished(o, &part, &run, &e))
		return false;
	uint32_t children = (part.count + part.child - 1) / part.child;
	*left = *right = part;
	left->count = children / 2 * part.child;
	right->first += left->count;
	right->count -= left->count;
	right->side = !part.side;
	o->orderer->cut(&run, widest(o, &e), left->count);
	return true;
}

static void arrange_few(const Order *o, Part part)
{
	Part left, right;
	while (cut(o, part, &left, &right)) {
		arrange_few(o, left);
		part = right;
	}
}

static void arrange(const Order *o, Part part)
{
	Part left, right;
	if (part.count <= FEW) {
		arrange_few(o, part);
	} else if (cut(o, part, &left, &right)) {
#pragma omp task
		arrange(o, left);
		arrange(o, right);
#pragma omp taskwait
	}
}

/* ---- columns ---- */

static void copy_points(const Order *o)
{
	const TreePoints *points = o->points;
	for (uint32_t i = 0; i < points->count; i++) {
		const float *at = row(points->position, points->stride, i);
		for (int k = 0; k < 3; k++)
			o->columns[0][k][i] = tree_key(at[k]);
		o->columns[0][o->dimensions][i] = (int32_t)i;
	}
	for (uint32_t i = 0; o->dimensions > 3 && i < points->count; i++) {
		const float *at = row(points->emitter, points->stride, i);
		for (int k = 0; k < 3; k++)
			o->columns[0][k + 3][i] = tree_key(at[k]);
	}
}

/* One piece of memory for both sides; for free(). */
static int32_t *make_columns(Order *o)
{
	size_t rows = ((size_t)o->points->count + 2 * TREE_WIDTH - 1) / TREE_WIDTH * TREE_WIDTH;
	int columns = o->dimensions + 1;
	int32_t *memory = tree_alloc(2 * (size_t)columns * rows, sizeof *memory);
	for (int k = 0; k < columns; k++) {
		o->columns[0][k] = memory + rows * (size_t)k;
		o->columns[1][k] = memory + rows * (size_t)(k + columns);
	}
	return memory;
}

double tree_order_room(int dimensions)
{
	return 2 * (dimensions + 1) * (double)sizeof(int32_t);
}

void tree_order(PhotonTree *tree, const TreePoints *points, const TreeOrderer *orderer)
{
	Order o = {.tree = tree, .points = points, .orderer = orderer};
	o.dimensions = points->emitter ? 6 : 3;
	int32_t *memory = make_columns(&o);
	copy_points(&o);
	for (int k = 0; k < 6; k++)
		o.weight[k] = k < 3 ? 1 : points->emitter_weight;
	Part all = {0, points->count, TREE_WIDTH, 0, 0};
	for (; all.level + 1 < tree->level_count; all.level++)
		all.child *= TREE_WIDTH;
#pragma omp parallel if (points->count > FEW)
#pragma omp single
	arrange(&o, all);
	free(memory);
}
