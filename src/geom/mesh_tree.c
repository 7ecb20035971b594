#include "geom/mesh_tree.h"

#include <pthread.h>
#include <stdatomic.h>
#include <stdlib.h>

/*
 * Nodes are split at the middle of the longest axis of their centroids, at the median when that
 * leaves one side empty; leaves hold up to LEAF triangles. Good enough for what is left over by the
 * accelerator. Memory is set aside when the mesh is made, because arenas are not for threads.
 */

enum { LEAF = 4, DEPTH = 64 };

typedef struct TreeNode {
	float lo[3], hi[3];
	int first; /* leaf: first in order; inner: number of the right child, the left one follows
		      its parent */
	int count; /* leaf: triangles, at least 1; inner: 0 */
	int axis;
} TreeNode;

struct MeshTree {
	atomic_bool ready;
	pthread_mutex_t lock;
	TreeNode *nodes;
	int *order;
	int node_count;
};

typedef struct Builder {
	const Mesh *mesh;
	MeshTree *tree;
	float (*centers)[3];
} Builder;

MeshTree *mesh_tree_create(Arena *arena, int triangles)
{
	MeshTree *tree = ARENA_NEW(arena, MeshTree);
	tree->order = ARENA_ARRAY(arena, int, triangles);
	tree->nodes = ARENA_ARRAY(arena, TreeNode, 2 * (size_t)triangles);
	pthread_mutex_init(&tree->lock, NULL);
	return tree;
}

static void grow(float lo[3], float hi[3], const float p[3])
{
	for (int k = 0; k < 3; k++) {
		lo[k] = p[k] < lo[k] ? p[k] : lo[k];
		hi[k] = p[k] > hi[k] ? p[k] : hi[k];
	}
}

static void clear_box(float lo[3], float hi[3])
{
	for (int k = 0; k < 3; k++) {
		lo[k] = INFINITY;
		hi[k] = -INFINITY;
	}
}

static int partition(const Builder *b, int first, int count, int axis, float middle)
{
	int *order = b->tree->order + first, left = 0;
	for (int i = 0; i < count; i++) {
		if (b->centers[order[i]][axis] < middle) {
			int swap = order[i];
			order[i] = order[left];
			order[left++] = swap;
		}
	}
	return left;
}

static TreeNode *start_node(const Builder *b, int first, int count, float lo[3], float hi[3])
{
	TreeNode *node = &b->tree->nodes[b->tree->node_count++];
	clear_box(node->lo, node->hi);
	clear_box(lo, hi);
	for (int i = first; i < first + count; i++) {
		int triangle = b->tree->order[i];
		for (int k = 0; k < 3; k++)
			grow(node->lo, node->hi,
			     b->mesh->desc.vertices[b->mesh->desc.triangles[triangle][k]]);
		grow(lo, hi, b->centers[triangle]);
	}
	return node;
}

static void build(const Builder *b, int first, int count, int depth)
{
	float lo[3], hi[3];
	TreeNode *node = start_node(b, first, count, lo, hi);
	node->first = first;
	node->count = count;
	if (count <= LEAF || depth >= DEPTH - 1)
		return;
	int axis = hi[1] - lo[1] > hi[0] - lo[0] ? 1 : 0;
	if (hi[2] - lo[2] > hi[axis] - lo[axis])
		axis = 2;
	int left = partition(b, first, count, axis, 0.5f * (lo[axis] + hi[axis]));
	if (left == 0 || left == count)
		left = count / 2;
	node->count = 0;
	node->axis = axis;
	build(b, first, left, depth + 1);
	node->first = b->tree->node_count;
	build(b, first + left, count - left, depth + 1);
}

static void build_tree(const Mesh *mesh)
{
	MeshTree *tree = mesh->tree;
	int count = mesh->desc.triangle_count;
	Builder b = {mesh, tree, memory_alloc(sizeof(float[3]) * (size_t)count)};
	for (int i = 0; i < count; i++) {
		const int *t = mesh->desc.triangles[i];
		tree->order[i] = i;
		for (int k = 0; k < 3; k++)
			b.centers[i][k] = (mesh->desc.vertices[t[0]][k] +
					   mesh->desc.vertices[t[1]][k] +
					   mesh->desc.vertices[t[2]][k]) /
					  3;
	}
	if (count > 0)
		build(&b, 0, count, 0);
	free(b.centers);
}

static void ensure(const Mesh *mesh)
{
	MeshTree *tree = mesh->tree;
	if (atomic_load_explicit(&tree->ready, memory_order_acquire))
		return;
	pthread_mutex_lock(&tree->lock);
	if (!atomic_load_explicit(&tree->ready, memory_order_relaxed)) {
		build_tree(mesh);
		atomic_store_explicit(&tree->ready, true, memory_order_release);
	}
	pthread_mutex_unlock(&tree->lock);
}

/* Slab test, widened a little for the boxes' single precision. */
static bool meets(const TreeNode *node, const Ray *ray, const double inverse[3])
{
	const double origin[3] = {ray->origin.x, ray->origin.y, ray->origin.z};
	double near = ray->tmin, far = ray->tmax;
	for (int k = 0; k < 3; k++) {
		double a = (node->lo[k] - origin[k]) * inverse[k],
		       b = (node->hi[k] - origin[k]) * inverse[k];
		near = fmax(near, fmin(a, b)); /* fmax and fmin pass over NaN: a ray along a face
						  counts as inside */
		far = fmin(far, fmax(a, b));
	}
	return near <= far + 1e-9 * fabs(far);
}

void mesh_tree_visit(const Mesh *mesh, Ray *ray, MeshVisit *visit, void *data)
{
	ensure(mesh);
	const MeshTree *tree = mesh->tree;
	const double direction[3] = {ray->direction.x, ray->direction.y, ray->direction.z};
	const double inverse[3] = {1 / direction[0], 1 / direction[1], 1 / direction[2]};
	int stack[DEPTH + 1], top = 0;
	if (tree->node_count > 0)
		stack[top++] = 0;
	while (top > 0) {
		int number = stack[--top];
		const TreeNode *node = &tree->nodes[number];
		if (!meets(node, ray, inverse))
			continue;
		for (int i = 0; i < node->count; i++)
			visit(data, tree->order[node->first + i], ray);
		if (node->count == 0) {
			bool forward = direction[node->axis] >= 0;
			stack[top++] = forward ? node->first : number + 1;
			stack[top++] = forward ? number + 1 : node->first;
		}
	}
}
