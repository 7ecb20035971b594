/* The photon record, the search tree against brute force, and photon maps as files. */
#include "photon/map.h"

#include <stdlib.h>
#include <unistd.h>

#include "base/arena.h"
#include "base/parallel.h"
#include "base/random.h"
#include "photon/tree_build.h"
#include "tests/unit/check.h"

static Vec3 random_direction(Sampler *s)
{
	double z = 2 * sampler_next(s) - 1, phi = 2 * M_PI * sampler_next(s), r = sqrt(1 - z * z);
	return vec3(r * cos(phi), r * sin(phi), z);
}

static void test_record(void)
{
	Sampler s = {1, 0, 0};
	for (int i = 0; i < 20000; i++) {
		Photon p;
		Vec3 d = i < 6 ? vec3(i % 3 == 0 ? 1 - 2 * (i / 3) : 0,
				      i % 3 == 1 ? 1 - 2 * (i / 3) : 0,
				      i % 3 == 2 ? 1 - 2 * (i / 3) : 0)
			       : random_direction(&s);
		photon_set_direction(&p, d);
		photon_set_normal(&p, d);
		double fine = vec3_distance(photon_direction(&p), d),
		       coarse = vec3_distance(photon_normal(&p), d);
		CHECK(i < 6 ? fine == 0 && coarse == 0 : fine < 1e-4 && coarse < 0.02);
		float scale = (float)exp(60 * (sampler_next(&s) - 0.5));
		Rgb flux = rgb(scale * (float)sampler_next(&s), scale * (float)sampler_next(&s),
			       scale * (float)sampler_next(&s)),
		    got;
		photon_set_flux(&p, flux);
		got = photon_flux(&p);
		CHECK_NEAR(got.r, flux.r, 1.6e-5 * rgb_max(flux));
		CHECK_NEAR(got.g, flux.g, 1.6e-5 * rgb_max(flux));
	}
	Photon p;
	const float hard[] = {0, 1, 0.99999994f, 65535.5f, 1e-30f, 1e30f};
	for (int i = 0; i < 6; i++) {
		photon_set_flux(&p, rgb(hard[i], 0, hard[i] / 3));
		CHECK_NEAR(photon_flux(&p).r, hard[i], 1.6e-5 * hard[i]);
		CHECK(photon_flux(&p).g == 0);
	}
}

/* ---- the tree ---- */

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

/* ---- maps and files ---- */

static PhotonMap *make_map(uint32_t count)
{
	PhotonMap *map = photon_map_create();
	Sampler s = {3, 0, 0};
	map->photons = calloc(count, sizeof(Photon));
	map->count = count;
	map->lights = calloc(2, sizeof(PhotonLight));
	map->light_count = 2;
	map->lights[1] = (PhotonLight){123456, 3.5, 2};
	for (uint32_t i = 0; i < count; i++) {
		Photon *p = &map->photons[i];
		p->position[0] = (float)sampler_next(&s);
		p->position[2] = (float)sampler_next(&s);
		p->emitter[1] = (float)sampler_next(&s);
		p->length = (float)i;
		p->light = (uint16_t)(i & 1);
		p->object = (uint16_t)i;
		p->edges = 3;
		photon_set_flux(p, rgb(1, 0.5f, (float)sampler_next(&s)));
		photon_set_direction(p, random_direction(&s));
		photon_set_normal(p, vec3(0, 1, 0));
	}
	return map;
}

static void check_round_trip(const PhotonMap *map, const char *path, Diag *diag)
{
	CHECK(photon_map_write(map, path, diag));
	PhotonMap *back = photon_map_read(path, diag);
	CHECK(back && back->count == map->count && back->light_count == 2 &&
	      back->lights[1].paths == 123456);
	for (uint32_t i = 0; back && i < map->count; i++)
		CHECK(memcmp(&back->photons[i], &map->photons[i], sizeof(Photon)) == 0);
	CHECK(back && back->relaxed == map->relaxed && !back->constraints == !map->constraints);
	for (uint32_t i = 0; back && map->constraints && i < map->count; i++) {
		const PhotonConstraint *a = &back->constraints[i], *b = &map->constraints[i];
		CHECK(memcmp(a->along, b->along, sizeof a->along) == 0);
		CHECK_NEAR(a->freedom, b->freedom, 1e-6);
	}
	photon_map_destroy(back);
}

/* As if relaxation under constraints had moved the photons, which lie on a plane across y. */
static void constrain(PhotonMap *map)
{
	map->relaxed = true;
	map->constraints = memory_alloc(sizeof(PhotonConstraint) * (map->count + 1));
	for (uint32_t i = 0; i < map->count; i++) {
		double angle = 2 * M_PI * random_uniform(5, i, 0);
		map->constraints[i] = (PhotonConstraint){{(float)cos(angle), 0, (float)sin(angle)},
							 (float)random_uniform(5, i, 1)};
	}
}

static void test_map(void)
{
	Diag *diag = diag_create(NULL);
	char path[] = "/tmp/photon-map-XXXXXX";
	close(mkstemp(path));
	PhotonMap *map = make_map(20000);
	photon_map_index(map, 0);
	CHECK_NEAR(map->spacing, sqrt(1.0 / 20000),
		   0.15 * sqrt(1.0 / 20000)); /* a unit square of uniform photons */
	check_round_trip(map, path, diag);
	constrain(map);
	check_round_trip(map, path, diag);
	CHECK(diag_errors(diag) == 0);
	CHECK(truncate(path, 5000) == 0 && !photon_map_read(path, diag) && diag_errors(diag) == 1);
	CHECK(truncate(path, 20) == 0 && !photon_map_read(path, diag) && diag_errors(diag) == 2);
	CHECK(!photon_map_read("/nowhere/map.ply", diag) &&
	      !photon_map_write(map, "/nowhere/map.ply", diag));
	photon_map_destroy(map);
	map = make_map(0);
	photon_map_index(map, 0);
	check_round_trip(map, path, diag);
	photon_map_destroy(map);
	unlink(path);
	diag_destroy(diag);
}

int main(void)
{
	test_record();
	for (int kind = 0; kind < 4; kind++) {
		test_tree(kind, POINTS, 0);
		test_tree(kind, POINTS, 1);
	}
	for (int count = 0; count < 20; count++)
		test_tree(0, count, 1);
	test_tree(0, 64, 0);
	test_tree(0, 65, 0);
	test_morton();
	test_map();
	return CHECK_RESULT();
}
