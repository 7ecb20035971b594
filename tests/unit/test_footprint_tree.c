/* The tree of footprints' boxes against looking at each of them, with and without vectors. */
#include "density/footprint_tree.c" /* for both ways to look at a node */

#include <stdbool.h>
#include <string.h>

#include "base/random.h"
#include "tests/unit/check.h"

enum { MOST = 5000, QUERIES = 100 };

typedef struct Found {
	uint32_t numbers[MOST];
	int count;
} Found;

static void take(void *data, const uint32_t *numbers, int count)
{
	Found *found = data;
	for (int i = 0; i < count && found->count < MOST; i++)
		found->numbers[found->count++] = numbers[i];
}

/* kind 0: some of each size, 1: flat ones, 2: all the same, 3: points. */
static Box3 make_box(Sampler *s, int kind)
{
	double size = pow(10, -3 * sampler_next(s));
	Vec3 at = vec3(sampler_next(s), sampler_next(s), sampler_next(s));
	Vec3 extent = vec3(size * sampler_next(s), size, size * sampler_next(s));
	if (kind == 1)
		at.y = extent.y = 0;
	if (kind == 2)
		at = extent = vec3_all(0.5);
	if (kind == 3)
		extent = vec3_all(0);
	return (Box3){vec3_sub(at, extent), vec3_add(at, extent)};
}

static bool box_meets(Box3 a, Box3 b)
{
	return a.lo.x <= b.hi.x && a.hi.x >= b.lo.x && a.lo.y <= b.hi.y && a.hi.y >= b.lo.y &&
	       a.lo.z <= b.hi.z && a.hi.z >= b.lo.z;
}

static void visit_with(const FootprintTree *tree, Box3 box, Meet *meet, Found *found)
{
	Visit v = {tree, {(float)box.lo.x, (float)box.lo.y, (float)box.lo.z},
		   {(float)box.hi.x, (float)box.hi.y, (float)box.hi.z}, meet, take, found};
	static const uint32_t root = 0;
	found->count = 0;
	if (tree->levels > 0)
		visit_nodes(&v, tree->levels - 1, &root, 1);
}

/* Every box that meets is found; what is found besides meets but for rounding to floats; numbers
 * rise. */
static void check_found(const Found *found, const Box3 *boxes, uint32_t count, Box3 box)
{
	Box3 wide = {vec3_sub(box.lo, vec3_all(1e-6)), vec3_add(box.hi, vec3_all(1e-6))};
	int at = 0;
	for (uint32_t i = 0; i < count; i++) {
		bool here = at < found->count && found->numbers[at] == i;
		CHECK(here ? box_meets(boxes[i], wide) : !box_meets(boxes[i], box));
		at += here;
	}
	CHECK(at == found->count);
}

static void check_tree(const FootprintTree *tree, const Box3 *boxes, uint32_t count, int kind)
{
	static Found found, plain;
	Sampler s = {5, (uint64_t)kind, count};
	for (int i = 0; i < QUERIES; i++) {
		/* floats, as look-ups are */
		Vec3 at = vec3((float)sampler_next(&s), (float)sampler_next(&s),
			       (float)sampler_next(&s));
		Vec3 reach = vec3_all(i % 3 == 0 ? 0 : i % 3 == 1 ? 0.015625 : 16);
		Box3 box = {vec3_sub(at, reach), vec3_add(at, reach)};
		found.count = 0;
		footprint_tree_visit(tree, box, take, &found);
		check_found(&found, boxes, count, box);
		visit_with(tree, box, meet_plain, &plain);
		CHECK(plain.count == found.count &&
		      memcmp(plain.numbers, found.numbers,
			     sizeof(uint32_t) * (size_t)found.count) == 0);
	}
}

static void test_boxes(int kind, uint32_t count)
{
	static Box3 boxes[MOST], ordered[MOST];
	static uint32_t order[MOST];
	static bool seen[MOST];
	Sampler s = {3, (uint64_t)kind, 0};
	memset(seen, 0, sizeof seen);
	for (uint32_t i = 0; i < count; i++)
		boxes[i] = make_box(&s, kind);
	footprint_tree_order(boxes, count, order);
	for (uint32_t i = 0; i < count; i++) {
		CHECK(order[i] < count && !seen[order[i]]);
		seen[order[i]] = true;
		ordered[i] = boxes[order[i]];
	}
	FootprintTree tree = footprint_tree_build(ordered, count);
	check_tree(&tree, ordered, count, kind);
	free(tree.nodes);
}

int main(void)
{
	for (int kind = 0; kind < 4; kind++)
		test_boxes(kind, MOST);
	for (uint32_t count = 0; count < 20; count++)
		test_boxes(0, count);
	test_boxes(0, 64);
	test_boxes(0, 65);
	test_boxes(0, 513);
	return CHECK_RESULT();
}
