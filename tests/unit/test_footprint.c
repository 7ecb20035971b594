/* Footprints of sheets without gaps, and few photons. */
#include <pthread.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "base/clock.h"
#include "density/footprint_fit.h"
#include "density/footprint_mesh.h"
#include "surface/texture.h"
#include "tests/unit/footprint_check.h"

/* A fold along x = 0: density 1 / (2 sqrt(x)) over 0..1, of both sheets together. */
static void folded(double u, double v, double to[2])
{
	to[0] = (2 * u - 1) * (2 * u - 1);
	to[1] = v;
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
	PhotonMap *map = map_by_way(60000, 0, straight_way);
	double whole = time_creation(map, INFINITY);
	for (double share = 0; share < 0.5; share += 0.15)
		CHECK(time_creation(map, share * whole) < (share + 0.3) * whole);
	photon_map_destroy(map);
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
	PhotonMap *map = map_by_way(COUNT, 0, straight_way);
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
	PhotonMap *map = map_by_way(4000, 0, straight_way);
	DensityEstimator *estimator = footprint_estimator(map, 0);
	double truth = 1 / (2 * 0.5 + 0.3 * 0.1), squares = 0, sum = 0;
	int points = 0;
	for (double u = 0.2; u < 0.8; u += 0.03) {
		for (double v = 0.2; v < 0.8; v += 0.03) {
			double at[2];
			straight_way(u, v, at);
			double value = footprint_light(estimator, at[0], at[1], 0);
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
	PhotonMap *map = map_by_way(3000, 0, folded);
	DensityEstimator *estimator = footprint_estimator(map, 0);
	double sum = 0, low = -0.5, width = 2;
	for (int j = 0; j < SIDE; j++)
		for (int i = 0; i < SIDE; i++)
			sum += footprint_light(estimator, low + (i + 0.5) / SIDE * width,
				       low + (j + 0.5) / SIDE * width, width / SIDE);
	CHECK_NEAR(sum * width / SIDE * width / SIDE, 1, 0.005);
	estimator_destroy(estimator);
	photon_map_destroy(map);
}

/* An even sheet is even up to its border, and beyond there is nothing. */
static void test_border(void)
{
	PhotonMap *map = map_by_way(4000, 0, straight_way);
	DensityEstimator *estimator = footprint_estimator(map, 0);
	double truth = 1 / (2 * 0.5 + 0.3 * 0.1), inside = 0, outside = 0;
	int points = 0;
	for (double v = 0.1; v < 0.9; v += 0.01, points++) {
		double at[2];
		straight_way(0.005, v, at);
		inside += footprint_light(estimator, at[0], at[1], 0) / truth;
		straight_way(-0.01, v, at);
		outside += footprint_light(estimator, at[0], at[1], 0) / truth;
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
		PhotonMap *alone = map_by_way(COUNT, 0, straight_way),
			  *both = map_by_way(2 * COUNT, 0, straight_way);
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
		DensityEstimator *one = footprint_estimator(alone, 0),
				 *two = footprint_estimator(both, 0);
		for (double u = 0.1; u < 0.9; u += 0.1) {
			double at[2], x, z;
			straight_way(u, 0.5, at);
			x = at[0];
			z = at[1];
			double alone_there = footprint_light(one, x, z, 0);
			CHECK_NEAR(footprint_light(two, x, z, 0), alone_there, 1e-6);
			if (!below)
				CHECK_NEAR(footprint_light(two, 10 - x, z, 0), alone_there, 0.01);
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
	PhotonMap *map = map_by_way(4000, 0, straight_way);
	for (uint32_t i = 0; i < map->count; i++)
		photon_set_flux(&map->photons[i],
				rgb_scale(interior_hue_color(random_halton(i + 1, 4)),
					  1 / (float)map->count));
	DensityEstimator *estimator = footprint_estimator(map, 0);
	double truth = 1 / (2 * 0.5 + 0.3 * 0.1), squares = 0;
	Rgb sum = {0, 0, 0};
	int points = 0;
	for (double u = 0.2; u < 0.8; u += 0.03) {
		for (double v = 0.2; v < 0.8; v += 0.03, points++) {
			double at[2];
			straight_way(u, v, at);
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
	PhotonMap *map = map_by_way(40, 0, folded);
	DensityEstimator *estimator = footprint_estimator(map, 0);
	double error = 0;
	for (int i = 0; i < 20; i++) {
		double x = 0.01 + 0.03 * i, truth = (sqrt(x + 0.5 * pixel) -
						     sqrt(fmax(0, x - 0.5 * pixel))) / pixel;
		error += pow(footprint_light(estimator, x, 0.5, pixel) / truth - 1, 2) / 20;
	}
	CHECK(sqrt(error) < 0.02);
	estimator_destroy(estimator);
	photon_map_destroy(map);
}

/* A photon alone in its group, and two and three, keep their light. */
static void test_alone(void)
{
	for (uint16_t strangers = 1; strangers < 4; strangers++) {
		PhotonMap *map = known_map_photons(&(KnownMap){even_way, 0, 1}, 400, 0);
		for (int i = 0; i < strangers; i++) {
			map->photons[100 + i].path = 7;
			photon_set_flux(&map->photons[100 + i], rgb(1, 1, 1));
		}
		photon_map_index(map, 0);
		DensityEstimator *estimator = footprint_estimator(map, 0);
		CHECK_NEAR(footprint_total(estimator, -0.5, 2, 200),
			   strangers + (400.0 - strangers) / 400, 0.01);
		estimator_destroy(estimator);
		photon_map_destroy(map);
	}
}

/* Few photons, or all at one place, are no reason to fail. */
static void test_few(void)
{
	for (uint32_t count = 0; count < 12; count++) {
		PhotonMap *map = map_by_way(count, 0, straight_way);
		DensityEstimator *estimator = footprint_estimator(map, 0);
		CHECK(isfinite(footprint_light(estimator, 1, 0.2, 0)));
		estimator_destroy(estimator);
		for (uint32_t i = 0; i < count; i++)
			map->photons[i].position[0] = map->photons[i].position[2] = 0;
		photon_map_index(map, 0);
		estimator = footprint_estimator(map, 0);
		CHECK(isfinite(footprint_light(estimator, 0, 0, 0)));
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
	test_few();
	test_stop();
	return CHECK_RESULT();
}
