#include "density/footprint_tree.h"

#include <math.h>
#include <stdlib.h>

#include "base/arena.h"
#include "photon/tree.h"

#if defined(__x86_64__) && defined(__GNUC__)
#define HAS_AVX2 1
#include <immintrin.h>
#endif

enum { WIDTH = 8 };

/* ---- order ---- */

/* A box as a point for the search tree: its middle, and how far it reaches from there. */
typedef struct BoxPoint {
	float center[3], reach[3];
	uint16_t light; /* none */
} BoxPoint;

static BoxPoint box_point(Box3 box)
{
	Vec3 center = vec3_scale(vec3_add(box.lo, box.hi), 0.5), reach = vec3_sub(box.hi, center);
	return (BoxPoint){{(float)center.x, (float)center.y, (float)center.z},
			  {(float)reach.x, (float)reach.y, (float)reach.z}, 0};
}

void footprint_tree_order(const Box3 *boxes, uint32_t count, uint32_t *order)
{
	BoxPoint *points = memory_alloc(sizeof *points * ((size_t)count + 1));
	for (uint32_t i = 0; i < count; i++)
		points[i] = box_point(boxes[i]);
	/* Sizes count as much as places: by trial, 0.3 to 4 times as much is all the same. */
	TreePoints given = {points->center, points->reach, &points->light,
			    count, sizeof *points, 1};
	PhotonTree *tree = photon_tree_create(&given);
	photon_tree_order(tree, order);
	photon_tree_destroy(tree);
	free(points);
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

enum { BLOCK = WIDTH * WIDTH };

typedef struct Visit Visit;
/* Numbers of a node's children that meet the box, in ascending order, the first child's being
 * `first`; may write eight. Returns how many. */
typedef int Meet(const FootprintNode *node, const Visit *v, uint32_t first, uint32_t *out);

struct Visit {
	const FootprintTree *tree;
	float lo[3], hi[3];
	Meet *meet;
	FootprintVisit *visit;
	void *data;
};

static int meet_plain(const FootprintNode *node, const Visit *v, uint32_t first, uint32_t *out)
{
	int count = 0;
	for (uint32_t i = 0; i < WIDTH; i++) {
		out[count] = first + i;
		count += (node->lo[0][i] <= v->hi[0]) & (node->hi[0][i] >= v->lo[0]) &
			 (node->lo[1][i] <= v->hi[1]) & (node->hi[1][i] >= v->lo[1]) &
			 (node->lo[2][i] <= v->hi[2]) & (node->hi[2][i] >= v->lo[2]);
	}
	return count;
}

#ifdef HAS_AVX2
__attribute__((target("avx2,bmi2,popcnt"))) static __m256
axis_meets(const FootprintNode *node, const Visit *v, int axis)
{
	__m256 lo = _mm256_loadu_ps(node->lo[axis]), hi = _mm256_loadu_ps(node->hi[axis]);
	return _mm256_and_ps(_mm256_cmp_ps(lo, _mm256_set1_ps(v->hi[axis]), _CMP_LE_OQ),
			     _mm256_cmp_ps(hi, _mm256_set1_ps(v->lo[axis]), _CMP_GE_OQ));
}

__attribute__((target("avx2,bmi2,popcnt"))) static int
meet_avx2(const FootprintNode *node, const Visit *v, uint32_t first, uint32_t *out)
{
	__m256 met = _mm256_and_ps(axis_meets(node, v, 0), axis_meets(node, v, 1));
	met = _mm256_and_ps(met, axis_meets(node, v, 2));
	unsigned mask = (unsigned)_mm256_movemask_ps(met);
	/* Lane numbers of the mask's bits, packed to the front. */
	uint64_t bytes = _pdep_u64(mask, 0x0101010101010101u) * 0xff;
	__m128i lanes = _mm_cvtsi64_si128((long long)_pext_u64(0x0706050403020100u, bytes));
	__m256i numbers = _mm256_add_epi32(_mm256_cvtepu8_epi32(lanes),
					   _mm256_set1_epi32((int)first));
	_mm256_storeu_si256((__m256i *)out, numbers);
	return __builtin_popcount(mask);
}
#endif

static Meet *choose_meet(void)
{
#ifdef HAS_AVX2
	if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("bmi2"))
		return meet_avx2;
#endif
	return meet_plain;
}

/* Nodes of a level, eight at a time, so that there are many children to look at without a branch
 * in between. */
static void visit_nodes(const Visit *v, int level, const uint32_t *nodes, int count)
{
	const FootprintNode *all = v->tree->nodes + v->tree->level_start[level];
	for (int from = 0; from < count; from += WIDTH) {
		uint32_t met[BLOCK + WIDTH];
		int found = 0;
		for (int i = from; i < count && i < from + WIDTH; i++)
			found += v->meet(&all[nodes[i]], v, nodes[i] * WIDTH, met + found);
		if (found == 0)
			continue;
		if (level > 0)
			visit_nodes(v, level - 1, met, found);
		else
			v->visit(v->data, met, found);
	}
}

void footprint_tree_visit(const FootprintTree *tree, Box3 box, FootprintVisit *visit, void *data)
{
	Visit v = {tree, {(float)box.lo.x, (float)box.lo.y, (float)box.lo.z},
	           {(float)box.hi.x, (float)box.hi.y, (float)box.hi.z}, choose_meet(), visit, data};
	static const uint32_t root = 0;
	if (tree->levels > 0)
		visit_nodes(&v, tree->levels - 1, &root, 1);
}
