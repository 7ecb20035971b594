/* Footprints on maps from emitter to surface that are known. */
#include "density/estimator.h"

#include <pthread.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "base/clock.h"
#include "base/parallel.h"
#include "density/footprint_fit.h"
#include "density/footprint_mesh.h"
#include "surface/texture.h"
#include "tests/bench/known_map.h"
#include "tests/unit/check.h"

static void straight(double u, double v, double to[2])
{
	to[0] = 2 * u + 0.3 * v;
	to[1] = 0.5 * v - 0.1 * u;
}

/* A fold along x = 0: density 1 / (2 sqrt(x)) over 0..1, of both sheets together. */
static void folded(double u, double v, double to[2])
{
	to[0] = (2 * u - 1) * (2 * u - 1);
	to[1] = v;
}

/* count photons of flux 1 / count, Halton's points of the unit square of a plane emitter. */
static PhotonMap *make_map(uint32_t count, uint64_t first, KnownWay *way)
{
	return known_map_make(&(KnownMap){way, 0, 1}, count, first);
}

static DensityEstimator *make(const PhotonMap *map, double radius)
{
	Diag *diag = diag_create(NULL);
	PhotonSettings settings = photon_settings_default();
	Estimator method = {.kind = ESTIMATOR_FOOTPRINT};
	EstimatorSetup setup = {&method, &settings, map, radius, NULL};
	DensityEstimator *estimator = estimator_create(&setup, diag);
	CHECK(estimator && diag_errors(diag) == 0);
	diag_destroy(diag);
	return estimator;
}

/* Stops what goes on when it has taken so much processor time. */
typedef struct Patience {
	double until;
	volatile int stop, over;
} Patience;

static void *lose_patience(void *data)
{
	Patience *patience = data;
	while (clock_cpu() < patience->until && !patience->over)
		nanosleep(&(struct timespec){.tv_nsec = 500000}, NULL);
	patience->stop = !patience->over;
	return NULL;
}

/* Processor seconds; when stopped, nothing is made. */
static double time_creation(const PhotonMap *map, double patience_for)
{
	Diag *diag = diag_create(NULL);
	PhotonSettings settings = photon_settings_default();
	Estimator method = {.kind = ESTIMATOR_FOOTPRINT};
	double begin = clock_cpu();
	Patience patience = {begin + patience_for, patience_for <= 0, 0};
	EstimatorSetup setup = {&method, &settings, map, 0, &patience.stop};
	pthread_t thread;
	CHECK(pthread_create(&thread, NULL, lose_patience, &patience) == 0);
	DensityEstimator *estimator = estimator_create(&setup, diag);
	double seconds = clock_cpu() - begin;
	patience.over = 1;
	pthread_join(thread, NULL);
	CHECK(!estimator == (patience_for < INFINITY) && diag_errors(diag) == 0);
	estimator_destroy(estimator);
	diag_destroy(diag);
	return seconds;
}

/* Stopped at any time, it ends soon. */
static void test_stop(void)
{
	PhotonMap *map = make_map(60000, 0, straight);
	double whole = time_creation(map, INFINITY);
	for (double share = 0; share < 0.5; share += 0.15)
		CHECK(time_creation(map, share * whole) < (share + 0.3) * whole);
	photon_map_destroy(map);
}

static double density(const DensityEstimator *estimator, double x, double z, double pixel)
{
	GatherPoint point = {
		.position = vec3(x, 0, z), .normal = vec3(0, 1, 0), .footprint = pixel};
	GatherResult result;
	estimator_gather(estimator, &point, known_map_white, NULL, &result);
	return result.radiance.g;
}

/* Each triangle's corners exchange a part of their values, border and inner edges alike. */
static void spread_plainly(const Sheet *s, double *values, int rounds)
{
	double *old = malloc(sizeof *old * s->count);
	for (int round = 0; round < rounds; round++) {
		memcpy(old, values, sizeof *old * s->count);
		for (uint32_t t = 0; t < s->triangle_count; t++) {
			const uint32_t *c = s->triangles[t];
			for (int k = 0; k < 3; k++)
				for (int j = 0; j < 3; j++)
					values[c[k]] += (old[c[j]] - old[c[k]]) / 24;
		}
	}
	free(old);
}

static void test_spread(void)
{
	enum { COUNT = 500, ROUNDS = 4 };
	PhotonMap *map = make_map(COUNT, 0, straight);
	uint32_t photons[COUNT];
	for (uint32_t i = 0; i < COUNT; i++)
		photons[i] = i;
	Sheet sheet;
	footprint_mesh_make(&sheet, &(SheetTask){.map = map, .photons = photons, .count = COUNT});
	CHECK(sheet.triangle_count > COUNT && sheet.links.more_count > 0);
	Pair one[COUNT], two[COUNT][2];
	double plain[3][COUNT];
	for (uint32_t i = 0; i < COUNT; i++) {
		for (uint64_t k = 0; k < 3; k++)
			plain[k][i] = random_uniform(5, i, (uint32_t)k);
		one[i] = two[i][1] = (Pair){plain[0][i], plain[1][i]};
		two[i][0] = (Pair){plain[2][i], 0};
	}
	footprint_mesh_spread(&sheet, one, 1, ROUNDS);
	footprint_mesh_spread(&sheet, two[0], 2, ROUNDS);
	for (int k = 0; k < 3; k++)
		spread_plainly(&sheet, plain[k], ROUNDS);
	for (uint32_t i = 0; i < COUNT; i++) {
		CHECK_NEAR(one[i][0], plain[0][i], 1e-12);
		CHECK_NEAR(one[i][1], plain[1][i], 1e-12);
		CHECK_NEAR(two[i][0][0], plain[2][i], 1e-12);
		CHECK_NEAR(two[i][1][0], plain[0][i], 1e-12);
	}
	footprint_mesh_free(&sheet);
	photon_map_destroy(map);
}

/* An affine map of an even emission is even: within what Halton's points leave. */
static void test_even(void)
{
	PhotonMap *map = make_map(4000, 0, straight);
	DensityEstimator *estimator = make(map, 0);
	double truth = 1 / (2 * 0.5 + 0.3 * 0.1), squares = 0, sum = 0;
	int points = 0;
	for (double u = 0.2; u < 0.8; u += 0.03) {
		for (double v = 0.2; v < 0.8; v += 0.03) {
			double at[2];
			straight(u, v, at);
			double value = density(estimator, at[0], at[1], 0);
			squares += (value / truth - 1) * (value / truth - 1);
			sum += value / truth;
			points++;
		}
	}
	CHECK_NEAR(sum / points, 1, 0.01);
	CHECK_NEAR(sqrt(squares / points), 0, 0.02);
	estimator_destroy(estimator);
	photon_map_destroy(map);
}

/* What the floor receives is what the photons bring, also where kernels pass over the fold and
 * are widened to a pixel. */
static void test_energy(void)
{
	enum { SIDE = 300 };
	PhotonMap *map = make_map(3000, 0, folded);
	DensityEstimator *estimator = make(map, 0);
	double sum = 0, low = -0.5, width = 2;
	for (int j = 0; j < SIDE; j++)
		for (int i = 0; i < SIDE; i++)
			sum += density(estimator, low + (i + 0.5) / SIDE * width,
				       low + (j + 0.5) / SIDE * width, width / SIDE);
	CHECK_NEAR(sum * width / SIDE * width / SIDE, 1, 0.005);
	estimator_destroy(estimator);
	photon_map_destroy(map);
}

/* An even sheet is even up to its border, and beyond there is nothing. */
static void test_border(void)
{
	PhotonMap *map = make_map(4000, 0, straight);
	DensityEstimator *estimator = make(map, 0);
	double truth = 1 / (2 * 0.5 + 0.3 * 0.1), inside = 0, outside = 0;
	int points = 0;
	for (double v = 0.1; v < 0.9; v += 0.01, points++) {
		double at[2];
		straight(0.005, v, at);
		inside += density(estimator, at[0], at[1], 0) / truth;
		straight(-0.01, v, at);
		outside += density(estimator, at[0], at[1], 0) / truth;
	}
	CHECK_NEAR(inside / points, 1, 0.1);
	CHECK(outside / points < 0.05);
	estimator_destroy(estimator);
	photon_map_destroy(map);
}

/* Photons that left another light at the same coordinates, for the same floor or for the other side
 * of it, are no neighbours: the first light's footprints stay, and the others add their own or
 * nothing. */
static void test_strangers(void)
{
	enum { COUNT = 2000 };
	for (int below = 0; below < 2; below++) {
		PhotonMap *alone = make_map(COUNT, 0, straight),
			  *both = make_map(2 * COUNT, 0, straight);
		both->lights = realloc(both->lights, 2 * sizeof(PhotonLight));
		both->lights[0] = both->lights[1] = alone->lights[0];
		both->light_count = 2;
		for (uint32_t i = 0; i < COUNT; i++) {
			Photon *p = &both->photons[COUNT + i];
			both->photons[i] = *p = alone->photons[i];
			p->light = 1;
			p->position[0] = 10 - p->position[0];
			if (below) {
				p->position[0] = alone->photons[i].position[0] + 0.001f;
				p->position[1] = -0.0005f;
				photon_set_normal(p, vec3(0, -1, 0));
			}
		}
		photon_map_index(both, 0);
		DensityEstimator *one = make(alone, 0), *two = make(both, 0);
		for (double u = 0.1; u < 0.9; u += 0.1) {
			double at[2], x, z;
			straight(u, 0.5, at);
			x = at[0];
			z = at[1];
			CHECK_NEAR(density(two, x, z, 0), density(one, x, z, 0), 1e-6);
			if (!below)
				CHECK_NEAR(density(two, 10 - x, z, 0), density(one, x, z, 0), 0.01);
		}
		estimator_destroy(one);
		estimator_destroy(two);
		photon_map_destroy(alone);
		photon_map_destroy(both);
	}
}

/* Light of which each photon has a hue of its own is white where hues go the same way, and no light
 * is lost of any primary. */
static void test_hues(void)
{
	PhotonMap *map = make_map(4000, 0, straight);
	for (uint32_t i = 0; i < map->count; i++)
		photon_set_flux(&map->photons[i],
				rgb_scale(interior_hue_color(random_halton(i + 1, 4)),
					  1 / (float)map->count));
	DensityEstimator *estimator = make(map, 0);
	double truth = 1 / (2 * 0.5 + 0.3 * 0.1), squares = 0;
	Rgb sum = {0, 0, 0};
	int points = 0;
	for (double u = 0.2; u < 0.8; u += 0.03) {
		for (double v = 0.2; v < 0.8; v += 0.03, points++) {
			double at[2];
			straight(u, v, at);
			GatherPoint point = {.position = vec3(at[0], 0, at[1]),
			                     .normal = vec3(0, 1, 0)};
			GatherResult result;
			estimator_gather(estimator, &point, known_map_white, NULL, &result);
			Rgb off = rgb_sub(rgb_scale(result.radiance, (float)(1 / truth)),
					  rgb_all(1));
			squares += (off.r * off.r + off.g * off.g + off.b * off.b) / 3;
			sum = rgb_add(sum, result.radiance);
		}
	}
	CHECK_NEAR(sum.r / points / truth, 1, 0.02);
	CHECK_NEAR(sum.g / points / truth, 1, 0.02);
	CHECK_NEAR(sum.b / points / truth, 1, 0.02);
	CHECK_NEAR(sqrt(squares / points), 0, 0.15);
	estimator_destroy(estimator);
	photon_map_destroy(map);
}

/* A map of second order is known from few photons, straight borders too. */
static void test_fold(void)
{
	static const double pixel = 0.02;
	PhotonMap *map = make_map(40, 0, folded);
	DensityEstimator *estimator = make(map, 0);
	double error = 0;
	for (int i = 0; i < 20; i++) {
		double x = 0.01 + 0.03 * i, truth = (sqrt(x + 0.5 * pixel) -
						     sqrt(fmax(0, x - 0.5 * pixel))) / pixel;
		error += pow(density(estimator, x, 0.5, pixel) / truth - 1, 2) / 20;
	}
	CHECK(sqrt(error) < 0.02);
	estimator_destroy(estimator);
	photon_map_destroy(map);
}

/* Waves and folds that a hundred photons do not resolve. */
static void wavy(double u, double v, double to[2])
{
	double s = 2 * u - 1;
	to[0] = s * s + 0.05 * sin(14 * s);
	to[1] = v;
}

/* One that they do. */
static void gentle(double u, double v, double to[2])
{
	double s = 2 * u - 1;
	to[0] = s * s + 0.05 * sin(4 * s);
	to[1] = v;
}

/* The density of light from x - pixel / 2 to x + pixel / 2. */
static double folded_truth(KnownWay *way, double x, double pixel)
{
	enum { STEPS = 20000 };
	double to[2];
	int inside = 0;
	for (int i = 0; i < STEPS; i++) {
		way((i + 0.5) / STEPS, 0, to);
		inside += fabs(to[0] - x) < 0.5 * pixel;
	}
	return inside / (STEPS * pixel);
}

/* Some passes, of few photons each; radius: of the first, of the one that a render without a word
 * about it has; it falls with this power of the pass. */
typedef struct Passes {
	int count;
	double radius, power;
} Passes;

static DensityEstimator *make_pass(const PhotonMap *map, const Passes *passes, int pass)
{
	double whole = map->spacing * sqrt(50 / M_PI);
	return make(map, passes->radius * whole * pow(pass + 1, -passes->power));
}

/* Root mean square distance from the truth, relative to it, beside the fold, of the passes' mean
 * along it. */
static double folded_error(KnownWay *way, Passes passes)
{
	enum { POINTS = 20, ALONG = 12, PHOTONS = 150 };
	static const double pixel = 0.02;
	double sums[POINTS] = {0}, error = 0;
	for (int pass = 0; pass < passes.count; pass++) {
		PhotonMap *map = make_map(PHOTONS, (uint64_t)pass * PHOTONS, way);
		DensityEstimator *estimator = make_pass(map, &passes, pass);
		for (int i = 0; i < POINTS * ALONG; i++)
			sums[i % POINTS] += density(estimator, 0.01 + 0.03 * (i % POINTS),
						    0.1 + 0.8 * i / (POINTS * ALONG), pixel) /
					    (passes.count * ALONG);
		estimator_destroy(estimator);
		photon_map_destroy(map);
	}
	for (int i = 0; i < POINTS; i++)
		error += pow(sums[i] / folded_truth(way, 0.01 + 0.03 * i, pixel) - 1, 2) / POINTS;
	return sqrt(error);
}

/* The mean of passes converges as their patches shrink; else the few photons' polygons stay: 256
 * passes are no better than these 32. */
static void test_passes(void)
{
	double even = folded_error(wavy, (Passes){32, 1, 0});
	CHECK(folded_error(wavy, (Passes){256, 1, 1.0 / 3}) < 0.8 * even);
	CHECK(folded_error(wavy, (Passes){256, 0.01, 0}) < 0.4 * even);
}

/* What is right already stays whole for long: all shrinking alike, these have .015. */
static void test_gentle_passes(void)
{
	CHECK(folded_error(gentle, (Passes){64, 1, 1.0 / 6}) < 0.008);
}

/* Where light of this hue lands moves along x; an even sheet's border is an edge of colours. */
static double hue_shift(double hue) { return 0.2 * (hue - 0.5); }

static void even(double u, double v, double to[2])
{
	to[0] = u;
	to[1] = v;
}

static PhotonMap *make_parted(uint32_t count, uint64_t first)
{
	PhotonMap *map = known_map_photons(&(KnownMap){even, 0, 1}, count, first);
	for (uint32_t i = 0; i < count; i++) {
		double hue = random_halton(first + i + 1, 4);
		map->photons[i].position[0] += (float)hue_shift(hue);
		photon_set_flux(&map->photons[i],
				rgb_scale(interior_hue_color(hue), 1 / (float)count));
	}
	photon_map_index(map, 0);
	return map;
}

/* What all hues bring to x: those whose sheet has begun there. */
static Rgb parted_truth(double x)
{
	enum { STEPS = 1000 };
	Rgb sum = {0, 0, 0};
	for (int i = 0; i < STEPS; i++) {
		double hue = (i + 0.5) / STEPS;
		if (x > hue_shift(hue))
			sum = rgb_add(sum, interior_hue_color(hue));
	}
	return rgb_scale(sum, 1.0f / STEPS);
}

/* Root mean square distance from the truth across the border, of the mean along it and of the
 * passes. */
static double parted_error(Passes passes)
{
	enum { POINTS = 24, ALONG = 60 };
	Rgb sums[POINTS] = {{0, 0, 0}};
	double squares = 0;
	for (int pass = 0; pass < passes.count; pass++) {
		PhotonMap *map = make_parted(1000, (uint64_t)pass * 1000);
		DensityEstimator *estimator = make_pass(map, &passes, pass);
		for (int i = 0; i < POINTS * ALONG; i++) {
			GatherPoint point = {.position = vec3(-0.12 + 0.01 * (i % POINTS), 0,
			                                      0.2 + 0.6 * i / (POINTS * ALONG)),
			                     .normal = vec3(0, 1, 0), .footprint = 0.01};
			GatherResult result;
			estimator_gather(estimator, &point, known_map_white, NULL, &result);
			sums[i % POINTS] = rgb_add(sums[i % POINTS], result.radiance);
		}
		estimator_destroy(estimator);
		photon_map_destroy(map);
	}
	for (int i = 0; i < POINTS; i++) {
		Rgb off = rgb_sub(rgb_scale(sums[i], 1 / (float)(passes.count * ALONG)),
				  parted_truth(-0.12 + 0.01 * i));
		squares += (off.r * off.r + off.g * off.g + off.b * off.b) / (3 * POINTS);
	}
	return sqrt(squares);
}

/* So they do across a border of parted light. */
static void test_parted_passes(void)
{
	double even = parted_error((Passes){32, 1, 0});
	CHECK(parted_error((Passes){256, 1, 1.0 / 3}) < 0.9 * even);
	CHECK(parted_error((Passes){64, 0.01, 0}) < 0.7 * even);
}

/* A sheet's light in a square of windows that leaves nothing out. */
static double total(const DensityEstimator *estimator, double low, double width, int side)
{
	double sum = 0, step = width / side;
	for (int j = 0; j < side; j++)
		for (int i = 0; i < side; i++)
			sum += density(estimator, low + (i + 0.5) * step,
				       low + (j + 0.5) * step, step);
	return sum * step * step;
}

/* A photon alone in its group, and two and three, keep their light. */
static void test_alone(void)
{
	for (uint16_t strangers = 1; strangers < 4; strangers++) {
		PhotonMap *map = known_map_photons(&(KnownMap){even, 0, 1}, 400, 0);
		for (int i = 0; i < strangers; i++) {
			map->photons[100 + i].path = 7;
			photon_set_flux(&map->photons[100 + i], rgb(1, 1, 1));
		}
		photon_map_index(map, 0);
		DensityEstimator *estimator = make(map, 0);
		CHECK_NEAR(total(estimator, -0.5, 2, 200), strangers + (400.0 - strangers) / 400,
			   0.01);
		estimator_destroy(estimator);
		photon_map_destroy(map);
	}
}

/* A crease: one half of the sheet lands elsewhere. No light falls in between, none is lost. */
static void torn(double u, double v, double to[2])
{
	to[0] = u + (u + 0.3 * v > 0.7 ? 1 : 0);
	to[1] = v;
}

static void test_crease(void)
{
	PhotonMap *map = make_map(3000, 0, torn);
	DensityEstimator *estimator = make(map, 0);
	double between = 0;
	for (double v = 0.05; v < 0.95; v += 0.01)
		for (double off = 0.1; off < 0.9; off += 0.1)
			between += density(estimator, 0.7 - 0.3 * v + off, v, 0.01) * 0.01 * 0.1;
	CHECK(between < 0.01);
	CHECK_NEAR(total(estimator, -0.5, 3, 300), 1, 0.005);
	estimator_destroy(estimator);
	photon_map_destroy(map);
}

/* ---- light that goes elsewhere ---- */

/* How likely a photon that leaves within a strip of u, or beyond it, goes elsewhere. */
typedef struct Leak {
	double from, to;
	double within, beyond;
	uint64_t seed;
} Leak;

/* An even sheet; what leaks is of another kind, and lands at another place. */
static PhotonMap *make_leaking(const Leak *leak)
{
	PhotonMap *map = known_map_photons(&(KnownMap){even, 0, 1}, 4000, 0);
	for (uint32_t i = 0; i < map->count; i++) {
		Photon *p = &map->photons[i];
		bool within = p->emitter[0] > leak->from && p->emitter[0] < leak->to;
		if (random_uniform(leak->seed, i, 0) < (within ? leak->within : leak->beyond)) {
			p->position[0] += 10;
			p->path = 7;
		}
	}
	photon_map_index(map, 0);
	return map;
}

/* The mean along a line of this u. */
static double density_along(const DensityEstimator *estimator, double u)
{
	double sum = 0;
	for (double v = 0.05; v < 0.95; v += 0.01)
		sum += density(estimator, u, v, 0) / 90;
	return sum;
}

/* The share of a strip's places that have less than this. */
static double dark_share(const DensityEstimator *estimator, double from, double to, double least)
{
	int dark = 0, points = 0;
	for (double v = 0.05; v < 0.95; v += 0.01)
		for (double u = from; u < to; u += 0.005, points++)
			dark += density(estimator, u, v, 0) < least;
	return dark / (double)points;
}

/* A gap hardly wider than photons are apart, known from the photons that went elsewhere. */
static void test_gap(void)
{
	static const Leak leak = {.from = 0.48, .to = 0.52, .within = 1};
	PhotonMap *map = make_leaking(&leak);
	DensityEstimator *estimator = make(map, 0);
	CHECK(density_along(estimator, 0.5 * (leak.from + leak.to)) < 0.2);
	CHECK_NEAR(total(estimator, -0.5, 2, 200), 1 - (leak.to - leak.from), 0.005);
	estimator_destroy(estimator);
	photon_map_destroy(map);
}

/* One in ten, at random, goes elsewhere: no gaps. */
static void test_split(void)
{
	PhotonMap *map = make_leaking(&(Leak){.beyond = 0.1, .seed = 12});
	DensityEstimator *estimator = make(map, 0);
	for (double u = 0.1; u < 0.9; u += 0.02)
		for (double v = 0.1; v < 0.9; v += 0.02)
			CHECK_NEAR(density(estimator, u, v, 0.01), 0.9, 0.3);
	estimator_destroy(estimator);
	photon_map_destroy(map);
}

/* A kind that is all of the light in a gap and, at random, a fortieth elsewhere: the gap stays one,
 * and there are hardly others. By chance alone, one place in a thousand is among triangles so large
 * that they are taken for gaps. */
static void test_gap_and_split(void)
{
	static const Leak leak = {
		.from = 0.48, .to = 0.56, .within = 1, .beyond = 0.025, .seed = 13};
	PhotonMap *map = make_leaking(&leak);
	DensityEstimator *estimator = make(map, 0);
	CHECK(density_along(estimator, 0.5 * (leak.from + leak.to)) < 0.02);
	CHECK(dark_share(estimator, 0.05, 0.43, 0.5) < 0.004);
	estimator_destroy(estimator);
	photon_map_destroy(map);
}

/* A kind that is all of the light on both sides of a strip and three tenths of it, at random, in
 * the strip, as between where total reflection begins: there the sheet has no gaps. */
static void test_split_strip(void)
{
	static const Leak leak = {
		.from = 0.45, .to = 0.55, .within = 0.3, .beyond = 1, .seed = 14};
	static const double edge = 0.02;
	PhotonMap *map = make_leaking(&leak);
	DensityEstimator *estimator = make(map, 0);
	CHECK(density_along(estimator, leak.from - edge) < 0.02);
	CHECK(dark_share(estimator, leak.from + edge, leak.to - edge, 0.2) < 0.01);
	estimator_destroy(estimator);
	photon_map_destroy(map);
}

/* ---- thinned out ---- */

typedef double Share(double u);

static double gentle_share(double u) { return 0.2 + 0.6 * u; }

/* Over the way of some five photons. */
static double steep_share(double u)
{
	double t = fmax(0, fmin(1, (u - 0.5) / 0.04 + 0.5));
	return 0.1 + 0.8 * t * t * (3 - 2 * t);
}

/* Of photons that a surface thins out at random to a share that depends on u: the
 * density's relative error between two places. */
static double thinned_error(Share *share, double from, double to)
{
	PhotonMap *map = known_map_photons(&(KnownMap){even, 0, 1}, 16000, 0);
	uint32_t kept = 0;
	for (uint32_t i = 0; i < map->count; i++)
		if (random_uniform(11, i, 0) < share(map->photons[i].emitter[0]))
			map->photons[kept++] = map->photons[i];
	map->count = kept;
	photon_map_index(map, 0);
	DensityEstimator *estimator = make(map, 0);
	double squares = 0;
	int points = 0;
	for (double u = from; u < to; u += (to - from) / 40) {
		for (double v = 0.1; v < 0.9; v += 0.02, points++) {
			double off = density(estimator, u, v, 0) / share(u) - 1;
			squares += off * off;
		}
	}
	estimator_destroy(estimator);
	photon_map_destroy(map);
	return sqrt(squares / points);
}

/* One way in some places and another in others: the density stays smooth, yet follows. */
static void test_thinned(void)
{
	/* A window of 30 photons' noise would be 0.18. */
	CHECK_NEAR(thinned_error(gentle_share, 0.1, 0.9), 0, 0.1);
	/* 0.65 by a window of 120 photons alone. */
	CHECK_NEAR(thinned_error(steep_share, 0.44, 0.56), 0, 0.6);
}

/* Few photons, or all at one place, are no reason to fail. */
static void test_few(void)
{
	for (uint32_t count = 0; count < 12; count++) {
		PhotonMap *map = make_map(count, 0, straight);
		DensityEstimator *estimator = make(map, 0);
		CHECK(isfinite(density(estimator, 1, 0.2, 0)));
		estimator_destroy(estimator);
		for (uint32_t i = 0; i < count; i++)
			map->photons[i].position[0] = map->photons[i].position[2] = 0;
		photon_map_index(map, 0);
		estimator = make(map, 0);
		CHECK(isfinite(density(estimator, 0, 0, 0)));
		estimator_destroy(estimator);
		photon_map_destroy(map);
	}
}

/* A quadratic map is found as it is. */
static void test_fit(void)
{
	FitSample samples[16];
	FootprintFit fit;
	for (int i = 0; i < 16; i++) {
		double u = 2 * random_halton((uint64_t)i + 1, 0) - 1,
		       v = 2 * random_halton((uint64_t)i + 1, 1) - 1;
		samples[i] = (FitSample){{u, v}, {3 * u + v + u * u, u - v + 0.5 * u * v}, 0};
	}
	CHECK(footprint_fit(samples, 16, &fit));
	CHECK_NEAR(fit.jacobian[0][0], 3, 0.02);
	CHECK_NEAR(fit.jacobian[1][1], -1, 0.02);
	CHECK(fit.roughness < 1e-3);
	CHECK(!footprint_fit(samples, 5, &fit));
}

int main(void)
{
	test_fit();
	test_spread();
	test_even();
	test_energy();
	test_border();
	test_strangers();
	test_hues();
	test_fold();
	test_alone();
	test_crease();
	test_gap();
	test_split();
	test_gap_and_split();
	test_split_strip();
	test_thinned();
	test_few();
	test_stop();
	parallel_set_threads(1); /* more would wait for each other: passes' sheets are small */
	test_passes();
	test_gentle_passes();
	test_parted_passes();
	return CHECK_RESULT();
}
