/*
 * Relaxation: the constants of its constraints, what it does to noise and to edges, and what it
 * must not do.
 */
#include "photon/relax.h"

#include <stdlib.h>

#include "base/arena.h"
#include "base/parallel.h"
#include "base/random.h"
#include "photon/features.h"
#include "tests/unit/check.h"

static const RelaxSurfaces EVERYWHERE = {.project = NULL};

static PhotonMap *make_map(uint32_t count)
{
	PhotonMap *map = photon_map_create();
	map->photons = memory_alloc(sizeof(Photon) * (count + 1));
	map->count = count;
	for (uint32_t i = 0; i < count; i++) {
		map->photons[i] = (Photon){.length = 1, .edges = 2};
		photon_set_flux(&map->photons[i], rgb(1, 0.5f, 0.25f));
		photon_set_normal(&map->photons[i], vec3(0, 1, 0));
	}
	return map;
}

/* Light that falls straight down on the plane y = 0: emitter coordinates are x and z. */
static void place(Photon *photon, double x, double z)
{
	photon->position[0] = photon->emitter[0] = (float)x;
	photon->position[2] = photon->emitter[1] = (float)z;
	photon->position[1] = photon->emitter[2] = 0;
}

static PhotonMap *noise(uint32_t count)
{
	PhotonMap *map = make_map(count);
	for (uint32_t i = 0; i < count; i++)
		place(&map->photons[i], random_uniform(1, i, 0), random_uniform(1, i, 1));
	return map;
}

static Relaxation constrained(void) { return relaxation_default(); }

static Relaxation plain(void)
{
	return relaxation_plain();
}

/* ---- the constraint ---- */

/* SJ13 Fig. 7a: 100,000 sets of 100 uniform points of the unit disc. */
static void test_isotropic_noise(void)
{
	enum { SETS = 100000, POINTS = 100 };
	double sum = 0, squares = 0, points[POINTS][2];
	for (uint64_t set = 0; set < SETS; set++) {
		for (uint64_t i = 0; i < POINTS; i++) {
			double r = sqrt(random_uniform(2, set, 2 * i)),
			       phi = 2 * M_PI * random_uniform(2, set, 2 * i + 1);
			points[i][0] = r * cos(phi);
			points[i][1] = r * sin(phi);
		}
		double l2 = feature_axes((const double (*)[2])points, POINTS, 1).l2;
		sum += l2;
		squares += l2 * l2;
	}
	double mean = sum / SETS;
	CHECK_NEAR(mean, 0.2219, 0.0005);
	CHECK_NEAR(sqrt(squares / SETS - mean * mean), 0.0188, 0.0005);
}

static void test_freedom(void)
{
	const double half_disc = 0.25 - 16 / (9 * M_PI * M_PI),
		     strange[] = {-1e300, -1, 0, 0.1, 0.25, 1, 1e300, INFINITY, NAN};
	for (int count = 0; count < 300; count++) {
		for (int i = 0; i < 9; i++) {
			double free = feature_freedom(strange[i], count);
			CHECK(free >= 0 && free <= 1);
		}
		for (int i = 0; i <= 100; i++) {
			double free = feature_freedom(0.3 * i / 100, count);
			CHECK(free >= 0 && free <= 1);
		}
	}
	CHECK_NEAR(feature_freedom(half_disc, 1000), 0, 1e-6);
	CHECK_NEAR(feature_freedom(0.25, 1000), 1, 1e-3);
	/* The exact half disc: a grid of it, seen from the middle of its edge. */
	static double half[200 * 100][2];
	int count = 0;
	for (int i = 0; i < 200; i++) {
		for (int j = 0; j < 100; j++) {
			double x = (i + 0.5) / 100 - 1, y = (j + 0.5) / 100;
			if (x * x + y * y < 1) {
				half[count][0] = x;
				half[count++][1] = y;
			}
		}
	}
	FeatureAxes axes = feature_axes((const double (*)[2])half, count, 1);
	CHECK_NEAR(axes.l2, half_disc, 1e-4);
	CHECK_NEAR(fabs(axes.u[0]), 1, 1e-6);
	CHECK_NEAR(feature_freedom(axes.l2, count), 0, 1e-3);
}

/* Mean movement of the photons that start from x0 to x1, across the edge x = 0 and along it. */
typedef struct Movement {
	double across, along;
	int count;
} Movement;

static Movement movement(const PhotonMap *before, const PhotonMap *after, float x0, float x1)
{
	Movement m = {0, 0, 0};
	for (uint32_t i = 0; i < before->count; i++) {
		const float *p = after->photons[i].position, *q = before->photons[i].position;
		if (q[0] < x0 || q[0] > x1 || q[2] < 0.1f || q[2] > 0.9f)
			continue;
		m.across += fabs((double)p[0] - q[0]);
		m.along += fabs((double)p[2] - q[2]);
		m.count++;
	}
	m.across /= m.count;
	m.along /= m.count;
	return m;
}

/*
 * Half of the plane, up to x = 0, filled by an even pattern: what lies around a photon of its edge
 * is the half disc, and it does not move across. Without constraints it would move out by more
 * than half the distance to the next.
 */
static void test_half_disc(void)
{
	enum { SIDE = 60 };
	const double spacing = 1.0 / SIDE, shift = 0.5;
	double most[2] = {0, 0}; /* across: constrained, plain */
	for (int kind = 0; kind < 2; kind++) {
		PhotonMap *map = make_map(SIDE * SIDE), *before = make_map(SIDE * SIDE);
		for (uint32_t i = 0; i < SIDE * SIDE; i++) {
			double column = i / SIDE, row = i % SIDE + (i / SIDE % 2 ? shift : 0);
			place(&map->photons[i], sqrt(0.75) * spacing * column, spacing * row);
			before->photons[i] = map->photons[i];
		}
		Relaxation settings = kind ? plain() : constrained();
		photon_relax(map, &settings, &EVERYWHERE, NULL);
		for (uint32_t i = SIDE / 3; i < 2 * SIDE / 3; i++) {
			double moved = fabs((double)map->photons[i].position[0] -
					    before->photons[i].position[0]);
			most[kind] = fmax(most[kind], moved / spacing);
		}
		photon_map_destroy(map);
		photon_map_destroy(before);
	}
	CHECK(most[0] < 0.01 && most[1] > 0.5);
}

/* Photons up to an edge: those at it move along it; noise leaves a little movement across. */
static void test_edge(void)
{
	PhotonMap *free = noise(20000), *map = noise(20000), *before = noise(20000);
	Relaxation settings = constrained(), unconstrained = plain();
	photon_relax(map, &settings, &EVERYWHERE, NULL);
	photon_relax(free, &unconstrained, &EVERYWHERE, NULL);
	Movement edge = movement(before, map, 0, 0.002f),
		 inside = movement(before, map, 0.2f, 0.8f);
	CHECK(edge.count > 20 && edge.across < 0.35 * edge.along);
	CHECK(edge.across < 0.6 * inside.across);
	CHECK(edge.across < 0.15 * movement(before, free, 0, 0.002f).across);
	photon_map_destroy(map);
	photon_map_destroy(free);
	photon_map_destroy(before);
}

/* ---- what it does to noise ---- */

/*
 * Variance over square of mean of the distance to the nearest neighbour, away from the border:
 * 0.27 of white noise.
 */
static double unevenness(PhotonMap *map)
{
	photon_map_index(map, 0);
	double sum = 0, squares = 0;
	int count = 0;
	for (uint32_t i = 0; i < map->count; i++) {
		const float *p = map->photons[i].position;
		if (p[0] < 0.1f || p[0] > 0.9f || p[2] < 0.1f || p[2] > 0.9f)
			continue;
		Neighbor near[2 + 8 * TREE_SLACK];
		NearestQuery query = {{p[0], p[1], p[2]}, INFINITY, 2, NULL};
		double d2 = photon_tree_farthest(near,
						 photon_tree_nearest(map->tree, &query, near));
		sum += sqrt(d2);
		squares += d2;
		count++;
	}
	double mean = sum / count;
	return squares / count / (mean * mean) - 1;
}

static void test_noise(Relaxation settings)
{
	PhotonMap *map = noise(10000);
	RelaxStatistics statistics;
	double before = unevenness(map);
	CHECK_NEAR(before, 4 / M_PI - 1, 0.02);
	CHECK(photon_relax(map, &settings, &EVERYWHERE, &statistics));
	CHECK(!map->tree && statistics.moved == 10000 && statistics.mean_movement > 0 &&
	      statistics.mean_movement < 0.02);
	CHECK((map->constraints != NULL) == settings.constrained);
	CHECK(unevenness(map) < 0.1 * before);
	photon_map_destroy(map);
}

/* ---- what it leaves ---- */

static bool same_but_place(const Photon *a, const Photon *b)
{
	Photon c = *a;
	memcpy(c.position, b->position, sizeof c.position);
	return memcmp(&c, b, sizeof c) == 0;
}

static void test_rest_unchanged(Relaxation settings)
{
	PhotonMap *map = noise(5000), *before = noise(5000);
	photon_relax(map, &settings, &EVERYWHERE, NULL);
	CHECK(map->count == before->count);
	int same = 0, flat = 0;
	for (uint32_t i = 0; i < map->count; i++) {
		same += same_but_place(&before->photons[i], &map->photons[i]);
		flat += map->photons[i].position[1] == 0;
	}
	CHECK(same == 5000 && flat == 5000);
	photon_map_destroy(map);
	photon_map_destroy(before);
}

static void test_threads(Relaxation settings)
{
	PhotonMap *one = noise(7000), *two = noise(7000);
	int threads = parallel_threads();
	parallel_set_threads(1);
	photon_relax(one, &settings, &EVERYWHERE, NULL);
	parallel_set_threads(2);
	photon_relax(two, &settings, &EVERYWHERE, NULL);
	parallel_set_threads(threads);
	CHECK(memcmp(one->photons, two->photons, sizeof(Photon) * 7000) == 0);
	photon_map_destroy(one);
	photon_map_destroy(two);
}

/* The other order of the same photons. */
static void test_order(Relaxation settings)
{
	uint32_t count = 3000;
	PhotonMap *map = noise(count), *turned = noise(count);
	for (uint32_t i = 0; i < count; i++)
		turned->photons[i] = map->photons[count - 1 - i];
	photon_relax(map, &settings, &EVERYWHERE, NULL);
	photon_relax(turned, &settings, &EVERYWHERE, NULL);
	double most = 0;
	for (uint32_t i = 0; i < count; i++) {
		for (int k = 0; k < 3; k++)
			most = fmax(most, fabs((double)map->photons[i].position[k] -
					       turned->photons[count - 1 - i].position[k]));
	}
	/* The sums of forces run in another order. */
	CHECK(most < 1e-4);
	photon_map_destroy(map);
	photon_map_destroy(turned);
}

static void test_fixed_object(Relaxation settings)
{
	PhotonMap *map = noise(4000), *before = noise(4000), *alone = noise(2000);
	for (uint32_t i = 2000; i < 4000; i++)
		map->photons[i].object = before->photons[i].object = 1;
	const bool fixed[] = {false, true};
	RelaxSurfaces surfaces = {.fixed = fixed, .fixed_count = 2};
	photon_relax(map, &settings, &surfaces, NULL);
	photon_relax(alone, &settings, &EVERYWHERE, NULL);
	CHECK(memcmp(map->photons + 2000, before->photons + 2000, sizeof(Photon) * 2000) == 0);
	/* Those of the other object move as if alone. */
	CHECK(memcmp(map->photons, alone->photons, sizeof(Photon) * 2000) == 0);
	for (uint32_t i = 2000; i < 4000 && map->constraints; i++)
		CHECK(map->constraints[i].freedom == 1);
	photon_map_destroy(map);
	photon_map_destroy(before);
	photon_map_destroy(alone);
}

/* Two sides of a thin wall, two objects side by side: each moves as if alone. */
static void test_strangers(Relaxation settings)
{
	for (int kind = 0; kind < 2; kind++) {
		PhotonMap *both = noise(4000), *alone = noise(2000);
		for (uint32_t i = 2000; i < 4000; i++) {
			if (kind == 0)
				photon_set_normal(&both->photons[i], vec3(0, -1, 0));
			else
				both->photons[i].object = 7;
			both->photons[i].light = 1;
		}
		photon_relax(both, &settings, &EVERYWHERE, NULL);
		photon_relax(alone, &settings, &EVERYWHERE, NULL);
		double most = 0;
		for (uint32_t i = 0; i < 2000; i++)
			for (int k = 0; k < 3; k++)
				most = fmax(most, fabs((double)both->photons[i].position[k] -
						       alone->photons[i].position[k]));
		CHECK(most < 0.002); /* a tenth of the spacing: neighbours may be cut off at the
					most asked for */
		photon_map_destroy(both);
		photon_map_destroy(alone);
	}
}

/* In parameter space photons of another light are no neighbours, even those that start at the same
 * coordinates and land at the same places. */
static void test_other_light(void)
{
	Relaxation settings = constrained();
	settings.world_iterations = 0;
	PhotonMap *both = noise(4000), *alone = noise(2000);
	for (uint32_t i = 2000; i < 4000; i++) {
		both->photons[i] = both->photons[i - 2000];
		both->photons[i].position[0] += 1e-4f;
		both->photons[i].light = 1;
	}
	photon_relax(both, &settings, &EVERYWHERE, NULL);
	photon_relax(alone, &settings, &EVERYWHERE, NULL);
	double most = 0, moved = 0;
	for (uint32_t i = 0; i < 2000; i++) {
		const float *p = both->photons[i].position, *q = alone->photons[i].position;
		most = fmax(most, hypot(p[0] - q[0], p[2] - q[2]));
		moved = fmax(moved, hypot(q[0] - alone->photons[i].emitter[0],
					  q[2] - alone->photons[i].emitter[1]));
	}
	CHECK(most < 1e-6);
	CHECK(moved > 0.001);
	photon_map_destroy(both);
	photon_map_destroy(alone);
}

/* One photon in ten bears other light: what becomes of those. */
static double unevenness_of_tenth(Rgb light, Relaxation settings)
{
	enum { COUNT = 20000, TENTH = COUNT / 10 };
	PhotonMap *map = noise(COUNT), *tenth = make_map(TENTH);
	for (uint32_t i = 0; i < TENTH; i++)
		photon_set_flux(&map->photons[10 * i], light);
	photon_relax(map, &settings, &EVERYWHERE, NULL);
	for (uint32_t i = 0; i < TENTH; i++)
		tenth->photons[i] = map->photons[10 * i];
	double result = unevenness(tenth);
	photon_map_destroy(map);
	photon_map_destroy(tenth);
	return result;
}

/*
 * Few bright photons among many dim ones become even among themselves, and so do those of another
 * colour. A tenth of one even pattern keeps its noise, and so do photons without light.
 */
static void test_unlike_flux(void)
{
	Relaxation settings = constrained();
	double like = unevenness_of_tenth(rgb(1, 0.5f, 0.25f), settings);
	CHECK(like > 0.6 * (4 / M_PI - 1));
	CHECK(unevenness_of_tenth(rgb(100, 50, 25), settings) < 0.5 * like);
	CHECK(unevenness_of_tenth(rgb(0, 0, 10), settings) < 0.5 * like);
	CHECK(unevenness_of_tenth(rgb(0, 0, 0), settings) > 0.9 * like);
}

static double total_flux(const PhotonMap *map)
{
	double sum = 0;
	for (uint32_t i = 0; i < map->count; i++) {
		Rgb flux = photon_flux(&map->photons[i]);
		sum += (double)flux.r + (double)flux.g + (double)flux.b;
	}
	return sum;
}

/*
 * Two lights of unlike flux on one floor: all stay, each with its flux, and the sum is the same to
 * the last bit.
 */
static void test_total_flux(Relaxation settings)
{
	PhotonMap *map = noise(6000);
	for (uint32_t i = 0; i < 6000; i++) {
		map->photons[i].light = i % 3 == 0;
		if (i % 3 == 0)
			photon_set_flux(&map->photons[i], rgb(7, 0.1f * (float)(i % 100), 0));
	}
	double before = total_flux(map);
	CHECK(photon_relax(map, &settings, &EVERYWHERE, NULL));
	CHECK(before > 0 && total_flux(map) == before);
	photon_map_destroy(map);
}

/* A table that ends at x = 0.5: nothing moves past its edge. */
static bool table(void *data, RelaxPlace *at, double step)
{
	(void)data;
	(void)step;
	at->position.y = 0;
	return at->position.x <= 0.5;
}

static void test_edge_of_object(Relaxation settings)
{
	PhotonMap *map = noise(4000);
	for (uint32_t i = 0; i < 4000; i++)
		place(&map->photons[i], 0.5 * random_uniform(5, i, 0),
		      0.5 * random_uniform(5, i, 1));
	RelaxSurfaces surfaces = {.project = table};
	photon_relax(map, &settings, &surfaces, NULL);
	int past = 0;
	for (uint32_t i = 0; i < 4000; i++)
		past += map->photons[i].position[0] > 0.5f;
	CHECK(past == 0);
	photon_map_destroy(map);
}

/* ---- few and strange photons ---- */

static void check_finite(PhotonMap *map, Relaxation settings, bool moves)
{
	RelaxStatistics statistics;
	CHECK(photon_relax(map, &settings, &EVERYWHERE, &statistics) == (map->count > 0));
	int finite = 0;
	for (uint32_t i = 0; i < map->count; i++) {
		const float *p = map->photons[i].position;
		finite += isfinite(p[0]) && isfinite(p[1]) && isfinite(p[2]);
		CHECK(!map->constraints || (map->constraints[i].freedom >= 0 &&
					    map->constraints[i].freedom <= 1));
	}
	CHECK(finite == (int)map->count);
	CHECK(moves || statistics.mean_movement == 0);
	photon_map_destroy(map);
}

static void test_few(Relaxation settings)
{
	for (uint32_t count = 0; count < 60; count++)
		check_finite(noise(count), settings, count > 1);
	PhotonMap *point = make_map(300), *line = make_map(300);
	for (uint32_t i = 0; i < 300; i++) {
		place(&point->photons[i], 0.3, 0.7);
		place(&line->photons[i], random_uniform(3, i, 0), 0.25);
	}
	check_finite(point, settings, false);
	check_finite(line, settings, true);
}

/* Photons in a line stay in it. */
static void test_line(void)
{
	PhotonMap *line = make_map(300);
	for (uint32_t i = 0; i < 300; i++)
		place(&line->photons[i], random_uniform(3, i, 0), 0.25);
	Relaxation settings = constrained();
	photon_relax(line, &settings, &EVERYWHERE, NULL);
	for (uint32_t i = 0; i < 300; i++)
		CHECK_NEAR(line->photons[i].position[2], 0.25, 1e-5);
	photon_map_destroy(line);
}

static void test_off(void)
{
	PhotonMap *map = noise(100), *before = noise(100);
	Relaxation settings = constrained();
	settings.on = false;
	CHECK(!photon_relax(map, &settings, &EVERYWHERE, NULL));
	CHECK(memcmp(map->photons, before->photons, sizeof(Photon) * 100) == 0);
	photon_map_destroy(map);
	photon_map_destroy(before);
}

/* Ends relaxation when so many steps are taken. */
typedef struct Impatience {
	int left;
	volatile int stop;
} Impatience;

static bool lose_patience(void *data, RelaxPlace *at, double step)
{
	(void)at;
	(void)step;
	Impatience *impatience = data;
	if (__atomic_sub_fetch(&impatience->left, 1, __ATOMIC_RELAXED) == 0)
		impatience->stop = 1;
	return true;
}

/* Stopped at any time, photons are as they landed. */
static void test_stop(Relaxation settings)
{
	enum { PHOTONS = 3000 };
	for (int left = 1; left < 14 * PHOTONS; left += PHOTONS) {
		PhotonMap *map = noise(PHOTONS), *before = noise(PHOTONS);
		Impatience impatience = {left, 0};
		RelaxSurfaces surfaces = {
			.project = lose_patience, .data = &impatience, .stop = &impatience.stop};
		RelaxStatistics statistics;
		bool moved = photon_relax(map, &settings, &surfaces, &statistics);
		CHECK(moved == !impatience.stop && map->relaxed == moved);
		size_t size = sizeof(Photon) * PHOTONS;
		CHECK(moved || memcmp(map->photons, before->photons, size) == 0);
		CHECK(moved || (!map->constraints && statistics.moved == 0));
		photon_map_destroy(map);
		photon_map_destroy(before);
	}
}

/* Settings that make no sense do no harm. */
static void test_settings(void)
{
	const int numbers[] = {-5, 0, 1, 100000};
	for (int i = 0; i < 4; i++) {
		Relaxation settings = constrained();
		settings.neighbors = settings.repulsion_neighbors = numbers[i];
		settings.range = numbers[i];
		settings.parameter_iterations = settings.world_iterations = i < 3 ? numbers[i] : 1;
		check_finite(noise(200), settings, true);
	}
}

int main(void)
{
	test_isotropic_noise();
	test_freedom();
	test_half_disc();
	test_edge();
	test_other_light();
	test_line();
	test_off();
	test_settings();
	test_unlike_flux();
	for (int i = 0; i < 2; i++) {
		Relaxation settings = i ? plain() : constrained();
		test_noise(settings);
		test_rest_unchanged(settings);
		test_threads(settings);
		test_order(settings);
		test_fixed_object(settings);
		test_strangers(settings);
		test_total_flux(settings);
		test_edge_of_object(settings);
		test_few(settings);
		test_stop(settings);
	}
	return CHECK_RESULT();
}
