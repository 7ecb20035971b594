/* The search tree against brute force: few points and many, equal ones, more wanted than there
 * are. */
#include "photon/tree_order.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/random.h"
#include "tests/unit/check.h"

enum { POINTS = 3000, QUERIES = 150, MOST = 200 };

typedef struct TestPoint {
	float position[3], emitter[3];
	uint16_t light;
} TestPoint;

static void make_points(TestPoint *points, int kind)
{
	Sampler s = {7, (uint64_t)kind, 0};
	for (int i = 0; i < POINTS; i++) {
		for (int k = 0; k < 3; k++) {
			double x = sampler_next(&s);
			points[i].position[k] = (float)(kind == 1 && k == 1 ? 0
							: kind == 2         ? floor(4 * x)
							: kind == 3         ? 0.5
									    : x * x * x);
			points[i].emitter[k] = (float)sampler_next(&s);
		}
		points[i].light = (uint16_t)(2 * sampler_next(&s));
	}
}

static int compare_neighbors(const void *a, const void *b)
{
	const Neighbor *x = a, *y = b;
	if (x->distance2 != y->distance2)
		return x->distance2 < y->distance2 ? -1 : 1;
	return (x->index > y->index) - (x->index < y->index);
}

static float distance2(const float *a, const float *b)
{
	float dx = a[0] - b[0], dy = a[1] - b[1], dz = a[2] - b[2];
	return dx * dx + dy * dy + dz * dz;
}

static int brute_force(const TestPoint *points, int count, const NearestQuery *query, Neighbor *out)
{
	int found = 0;
	for (int i = 0; i < count; i++) {
		float d2 = distance2(points[i].position, query->center);
		const EmitterRange *range = query->range;
		if (d2 < query->max_distance2 &&
		    (!range || (range->light == points[i].light &&
				distance2(points[i].emitter, range->center) <= range->radius2)))
			out[found++] = (Neighbor){d2, (uint32_t)i};
	}
	qsort(out, (size_t)found, sizeof *out, compare_neighbors);
	return found < query->count ? found : query->count;
}

typedef struct Sum { int count; double distance2; } Sum;

static void add_found(void *data, const Neighbor *found, int count)
{
	Sum *sum = data;
	sum->count += count;
	for (int i = 0; i < count; i++)
		sum->distance2 += found[i].distance2;
}

/* What a processor without vectors of eight would find. */
static void check_plain(const PhotonTree *tree, const NearestQuery *query, const Neighbor *found,
			int count)
{
	static Neighbor plain[MOST + 8 * TREE_SLACK];
	int got = tree_nearest_plain(tree, query, plain);
	qsort(plain, (size_t)got, sizeof *plain, compare_neighbors);
	CHECK(got == count);
	for (int i = 0; i < got && i < count; i++)
		CHECK(plain[i].index == found[i].index);
	WithinQuery all = {{query->center[0], query->center[1], query->center[2]}, 0.1f};
	Sum one = {0, 0}, other = {0, 0};
	tree_within_plain(tree, &all, add_found, &one);
	photon_tree_within(tree, query->center, 0.1f, add_found, &other);
	CHECK(one.count == other.count);
}

static void check_query(const PhotonTree *tree, const TestPoint *points, int count,
			const NearestQuery *query)
{
	static Neighbor expected[POINTS], found[MOST + 8 * TREE_SLACK];
	int want = brute_force(points, count, query, expected),
	    got = photon_tree_nearest(tree, query, found);
	qsort(found, (size_t)got, sizeof *found, compare_neighbors);
	CHECK(got == want);
	for (int i = 0; i < got && i < want; i++)
		CHECK(found[i].index == expected[i].index &&
		      fabsf(found[i].distance2 - expected[i].distance2) <= 1e-6f);
	check_plain(tree, query, found, got);
	if (query->range)
		return;
	NearestQuery all = {
		{query->center[0], query->center[1], query->center[2]}, 0.01f, POINTS, NULL};
	int near = brute_force(points, count, &all, expected);
	Sum sum = {0, 0};
	photon_tree_within(tree, query->center, 0.1f, add_found, &sum);
	CHECK(abs(sum.count - near) <= 1); /* a point at the very radius */
}

static void test_tree(int kind, int count, float weight)
{
	static TestPoint points[POINTS];
	make_points(points, kind);
	TreePoints given = {points->position, points->emitter, &points->light,
			    (uint32_t)count,  sizeof *points,  weight};
	PhotonTree *tree = photon_tree_create(&given);
	Sampler s = {9, (uint64_t)kind, 0};
	for (int q = 0; q < QUERIES; q++) {
		NearestQuery query = {.count = 1 +
					       (int)(sampler_next(&s) * (q % 3 == 0 ? 8 : MOST)),
				      .max_distance2 = INFINITY};
		EmitterRange range = {.radius2 = 0.3f, .light = (uint16_t)(q & 1)};
		for (int k = 0; k < 3; k++) {
			query.center[k] = (float)sampler_next(&s);
			range.center[k] = (float)sampler_next(&s);
		}
		if (q % 4 == 1)
			query.max_distance2 = 0.02f;
		if (q % 2)
			query.range = &range;
		check_query(tree, points, count, &query);
	}
	photon_tree_destroy(tree);
}

static void test_morton(void)
{
	float p[8][3];
	uint32_t order[8];
	for (int i = 0; i < 8; i++) {
		p[i][0] = (float)((7 - i) & 1);
		p[i][1] = (float)((7 - i) >> 1 & 1);
		p[i][2] = (float)((7 - i) >> 2);
	}
	photon_tree_morton(p[0], 8, sizeof p[0], order);
	for (uint32_t i = 0; i < 8; i++)
		CHECK(order[i] == 7 - i);
}

/* ---- many points ---- */

enum { MANY = 50000, RAREST = 5 };

/* Coordinates of few distinct values, in which cuts meet equal keys, and signed zeros. */
static TestPoint *make_many(int kind)
{
	TestPoint *points = calloc(MANY, sizeof *points);
	Sampler s = {11, (uint64_t)kind, 0};
	for (int i = 0; i < MANY; i++) {
		for (int k = 0; k < 3; k++) {
			double x = 2 * sampler_next(&s) - 1, y = sampler_next(&s);
			points[i].position[k] = (float)(kind == 0   ? x * x * x
							: kind == 1 ? round(RAREST * x) * y
							: kind == 2 ? 1e30 * floor(2 * x)
								    : (i < 3) * (0.0 * x + k));
			points[i].emitter[k] = (float)y;
		}
		points[i].light = (uint16_t)(i & 1);
	}
	return points;
}

static bool same_boxes(const TreeBoxes *a, const TreeBoxes *b, uint32_t count)
{
	return !a == !b && (!a || memcmp(a, b, sizeof *a * count) == 0);
}

/* Whatever the processor, the tree is the same. */
static void check_orderers(const PhotonTree *tree, const TreePoints *given)
{
	PhotonTree *plain = tree_create(given, &tree_orderer_plain);
	CHECK(plain->level_count == tree->level_count);
	CHECK(memcmp(plain->leaves, tree->leaves, sizeof *tree->leaves * tree->leaf_count) == 0);
	CHECK(!tree->emitters || memcmp(plain->emitters, tree->emitters,
					sizeof *tree->emitters * tree->leaf_count) == 0);
	for (int i = 0; i < tree->level_count; i++) {
		const TreeLevel *a = &plain->levels[i], *b = &tree->levels[i];
		CHECK(same_boxes(a->boxes, b->boxes, a->count));
		CHECK(same_boxes(a->emitter_boxes, b->emitter_boxes, a->count));
	}
	photon_tree_destroy(plain);
}

/* Every point once, by a radius that holds all: more nodes wait than there is room for at once. */
static void check_all_within(const PhotonTree *tree)
{
	Sum all = {0, 0}, plain = {0, 0};
	WithinQuery query = {{0, 0, 0}, 1e18f};
	photon_tree_within(tree, query.center, query.radius, add_found, &all);
	tree_within_plain(tree, &query, add_found, &plain);
	CHECK(all.count == MANY && plain.count == MANY && all.distance2 == plain.distance2);
}

static void check_many_nearest(const PhotonTree *tree, const TestPoint *points, int kind)
{
	static const int counts[] = {1, 7, 64, 500, 4000, MANY, MANY + 9};
	Neighbor *expected = malloc(sizeof *expected * MANY);
	Neighbor *found = malloc(sizeof *found * (MANY + 9 + 8 * TREE_SLACK));
	Sampler s = {13, (uint64_t)kind, 0};
	for (unsigned i = 0; i < 2 * sizeof counts / sizeof *counts; i++) {
		EmitterRange range = {{0.5f, 0.5f, 0.5f}, 0.05f, 1};
		NearestQuery query = {.count = counts[i / 2], .max_distance2 = INFINITY,
				      .range = i & 1 ? &range : NULL};
		for (int k = 0; k < 3; k++)
			query.center[k] = (float)(2 * sampler_next(&s) - 1);
		int want = brute_force(points, MANY, &query, expected);
		int got = photon_tree_nearest(tree, &query, found), wrong = 0;
		qsort(found, (size_t)got, sizeof *found, compare_neighbors);
		CHECK(got == want);
		for (int n = 0; n < got && n < want; n++)
			wrong += found[n].distance2 != expected[n].distance2;
		CHECK(wrong == 0);
	}
	free(expected);
	free(found);
}

static void test_many(int kind, bool with_emitters)
{
	TestPoint *points = make_many(kind);
	TreePoints given = {.position = points->position, .count = MANY, .stride = sizeof *points,
			    .emitter_weight = 1};
	if (with_emitters) {
		given.emitter = points->emitter;
		given.light = &points->light;
	}
	PhotonTree *tree = photon_tree_create(&given);
	check_orderers(tree, &given);
	if (kind != 2)
		check_all_within(tree);
	if (kind != 2 && with_emitters)
		check_many_nearest(tree, points, kind);
	photon_tree_destroy(tree);
	free(points);
}

int main(void)
{
	for (int kind = 0; kind < 4; kind++) {
		test_tree(kind, POINTS, 0);
		test_tree(kind, POINTS, 1);
		test_many(kind, false);
		test_many(kind, true);
	}
	for (int count = 0; count < 20; count++)
		test_tree(0, count, 1);
	test_tree(0, 64, 0);
	test_tree(0, 65, 0);
	test_morton();
	return CHECK_RESULT();
}
