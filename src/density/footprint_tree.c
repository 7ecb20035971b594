#include "density/footprint_tree.h"

#include <math.h>
#include <stdlib.h>

#include "base/arena.h"
#include "photon/tree.h"

enum { WIDTH = 8 };

/* ---- order ---- */

typedef struct Place {
	int size;      /* binary exponent of the box's extent */
	uint32_t rank; /* along the curve */
	uint32_t index;
} Place;

static int compare_places(const void *a, const void *b)
{
	const Place *x = a, *y = b;
	if (x->size != y->size)
		return x->size < y->size ? -1 : 1;
	return (x->rank > y->rank) - (x->rank < y->rank);
}

static int size_of(Box3 box)
{
	int exponent = 0;
	Vec3 extent = vec3_sub(box.hi, box.lo);
	frexp(fmax(extent.x, fmax(extent.y, extent.z)), &exponent);
	return exponent;
}

void footprint_tree_order(const Box3 *boxes, uint32_t count, uint32_t *order)
{
	float (*centers)[3] = memory_alloc(sizeof *centers * (count + 1));
	Place *places = memory_alloc(sizeof *places * (count + 1));
	for (uint32_t i = 0; i < count; i++) {
		Vec3 center = vec3_scale(vec3_add(boxes[i].lo, boxes[i].hi), 0.5);
		centers[i][0] = (float)center.x;
		centers[i][1] = (float)center.y;
		centers[i][2] = (float)center.z;
	}
	photon_tree_morton(centers[0], count, sizeof *centers, order);
	for (uint32_t rank = 0; rank < count; rank++)
		places[rank] = (Place){size_of(boxes[order[rank]]), rank, order[rank]};
	qsort(places, count, sizeof *places, compare_places);
	for (uint32_t i = 0; i < count; i++)
		order[i] = places[i].index;
	free(places);
	free(centers);
}

/* ---- build ---- */

static void set_child(FootprintNode *node, int child, Box3 box)
{
	const double lo[3] = {box.lo.x, box.lo.y, box.lo.z}, hi[3] = {box.hi.x, box.hi.y, box.hi.z};
	for (int axis = 0; axis < 3; axis++) {
		node->lo[axis][child] = nextafterf((float)lo[axis], -INFINITY);
		node->hi[axis][child] = nextafterf((float)hi[axis], INFINITY);
	}
}

static Box3 node_box(const FootprintNode *node)
{
	Box3 box = box3_empty();
	for (int i = 0; i < WIDTH; i++) {
		Box3 child = {vec3(node->lo[0][i], node->lo[1][i], node->lo[2][i]),
		              vec3(node->hi[0][i], node->hi[1][i], node->hi[2][i])};
		if (!box3_is_empty(child))
			box = box3_union(box, child);
	}
	return box;
}

static uint32_t groups_of(uint32_t count) { return (count + WIDTH - 1) / WIDTH; }

FootprintTree footprint_tree_build(const Box3 *boxes, uint32_t count)
{
	FootprintTree tree = {.levels = 0};
	uint32_t total = 0;
	for (uint32_t n = groups_of(count); n > 0; n = n > 1 ? groups_of(n) : 0) {
		tree.level_start[tree.levels] = total;
		tree.level_count[tree.levels++] = n;
		total += n;
	}
	tree.nodes = memory_alloc(sizeof *tree.nodes * (total + 1));
	for (int level = 0; level < tree.levels; level++) {
		uint32_t below = level > 0 ? tree.level_count[level - 1] : count;
		const FootprintNode *lower = level > 0 ? tree.nodes + tree.level_start[level - 1]
						       : NULL;
		for (uint32_t i = 0; i < tree.level_count[level] * WIDTH; i++) {
			Box3 box = i >= below  ? box3_empty()
				   : level > 0 ? node_box(&lower[i])
					       : boxes[i];
			set_child(&tree.nodes[tree.level_start[level] + i / WIDTH],
				  (int)(i % WIDTH), box);
		}
	}
	return tree;
}

/* ---- look-up ---- */

typedef struct Visit {
	const FootprintTree *tree;
	float lo[3], hi[3];
	FootprintVisit *visit;
	void *data;
} Visit;

/* Without branches, so that the compiler does all eight at once. */
static void find_meeting(const FootprintNode *restrict node, const Visit *restrict v,
			 int *restrict met)
{
	for (int i = 0; i < WIDTH; i++)
		met[i] = (node->lo[0][i] <= v->hi[0]) & (node->hi[0][i] >= v->lo[0]) &
			 (node->lo[1][i] <= v->hi[1]) & (node->hi[1][i] >= v->lo[1]) &
			 (node->lo[2][i] <= v->hi[2]) & (node->hi[2][i] >= v->lo[2]);
}

static void visit_node(const Visit *v, int level, uint32_t number)
{
	int met[WIDTH];
	find_meeting(&v->tree->nodes[v->tree->level_start[level] + number], v, met);
	for (int i = 0; i < WIDTH; i++) {
		if (!met[i])
			continue;
		if (level > 0)
			visit_node(v, level - 1, number * WIDTH + (uint32_t)i);
		else
			v->visit(v->data, number * WIDTH + (uint32_t)i);
	}
}

void footprint_tree_visit(const FootprintTree *tree, Box3 box, FootprintVisit *visit, void *data)
{
	Visit v = {tree, {(float)box.lo.x, (float)box.lo.y, (float)box.lo.z},
	           {(float)box.hi.x, (float)box.hi.y, (float)box.hi.z}, visit, data};
	if (tree->levels > 0)
		visit_node(&v, tree->levels - 1, 0);
}
