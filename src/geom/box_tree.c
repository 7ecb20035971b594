#include "geom/box_tree.h"

#include <stdlib.h>

enum { LEAF_ITEMS = 2, STACK_DEPTH = 64 };

typedef struct TreeNode {
	Box3 box;
	int right;        /* the left child follows its parent */
	int first, count; /* of a leaf; count 0: an inner node */
} TreeNode;

struct BoxTree {
	TreeNode *nodes;
	int node_count;
	int *items;
	int *unbounded; /* items to be visited always */
	int unbounded_count;
};

typedef struct SortItem {
	double key;
	int item;
} SortItem;

typedef struct Builder {
	BoxTree *tree;
	const Box3 *boxes;
	SortItem *order;
} Builder;

static Vec3 box_middle(const Box3 *box)
{
	return vec3_scale(vec3_add(box->lo, box->hi), 0.5);
}

static int compare_items(const void *a, const void *b)
{
	const SortItem *left = a, *right = b;
	if (left->key != right->key)
		return left->key < right->key ? -1 : 1;
	return (left->item > right->item) - (left->item < right->item);
}

/* Orders items by their middles along the axis where these spread most. */
static void sort_items(Builder *builder, int first, int count)
{
	Box3 spread = box3_empty();
	for (int i = first; i < first + count; i++)
		spread = box3_add(spread, box_middle(&builder->boxes[builder->order[i].item]));
	Vec3 size = vec3_sub(spread.hi, spread.lo);
	int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
	for (int i = first; i < first + count; i++)
		builder->order[i].key = vec3_axis(
			box_middle(&builder->boxes[builder->order[i].item]), axis);
	qsort(builder->order + first, (size_t)count, sizeof(SortItem), compare_items);
}

static void build_node(Builder *builder, int first, int count)
{
	TreeNode *node = &builder->tree->nodes[builder->tree->node_count++];
	node->box = box3_empty();
	for (int i = first; i < first + count; i++)
		node->box = box3_union(node->box, builder->boxes[builder->order[i].item]);
	if (count <= LEAF_ITEMS) {
		node->first = first;
		node->count = count;
		return;
	}
	sort_items(builder, first, count);
	build_node(builder, first, count / 2);
	node->right = builder->tree->node_count;
	build_node(builder, first + count / 2, count - count / 2);
}

static bool box_is_bounded(const Box3 *box)
{
	return vec3_is_finite(box->lo) && vec3_is_finite(box->hi);
}

const BoxTree *box_tree_create(Arena *arena, const Box3 *boxes, int count)
{
	BoxTree *tree = ARENA_NEW(arena, BoxTree);
	Builder builder = {tree, boxes, memory_alloc(sizeof(SortItem) * ((size_t)count + 1))};
	int bounded = 0;
	tree->unbounded = ARENA_ARRAY(arena, int, count);
	tree->nodes = ARENA_ARRAY(arena, TreeNode, 2 * count + 1);
	for (int i = 0; i < count; i++) {
		if (box3_is_empty(boxes[i]))
			continue;
		if (box_is_bounded(&boxes[i]))
			builder.order[bounded++].item = i;
		else
			tree->unbounded[tree->unbounded_count++] = i;
	}
	if (bounded)
		build_node(&builder, 0, bounded);
	tree->items = ARENA_ARRAY(arena, int, bounded);
	for (int i = 0; i < bounded; i++)
		tree->items[i] = builder.order[i].item;
	free(builder.order);
	return tree;
}

static bool visit_list(const int *items, int count, BoxTreeVisit *visit, void *data)
{
	for (int i = 0; i < count; i++)
		if (visit(data, items[i]))
			return true;
	return false;
}

typedef bool TouchBox(const void *query, const Box3 *box);

/* What of the tree `touches` says yes to, from the root. Inlined: asking a box is no call. */
static inline __attribute__((always_inline)) bool walk(const BoxTree *tree, TouchBox *touches,
						       const void *query, BoxTreeVisit *visit,
						       void *data)
{
	int stack[STACK_DEPTH], depth = 0;
	if (visit_list(tree->unbounded, tree->unbounded_count, visit, data))
		return true;
	if (tree->node_count)
		stack[depth++] = 0;
	while (depth) {
		int at = stack[--depth];
		const TreeNode *node = &tree->nodes[at];
		if (!touches(query, &node->box))
			continue;
		if (node->count) {
			if (visit_list(tree->items + node->first, node->count, visit, data))
				return true;
		} else {
			stack[depth++] = node->right;
			stack[depth++] = at + 1;
		}
	}
	return false;
}

static inline bool ray_touches(const void *ray, const Box3 *box)
{
	return ray_slabs_hit(ray, box);
}

static inline bool point_touches(const void *point, const Box3 *box)
{
	return box3_contains(*box, *(const Vec3 *)point);
}

bool box_tree_walk_ray(const BoxTree *tree, const RaySlabs *ray, BoxTreeVisit *visit, void *data)
{
	return walk(tree, ray_touches, ray, visit, data);
}

bool box_tree_walk_point(const BoxTree *tree, Vec3 p, BoxTreeVisit *visit, void *data)
{
	return walk(tree, point_touches, &p, visit, data);
}
