/* Footprints on maps from emitter to surface that are known. */
#include "density/estimator.h"

#include <stdlib.h>

#include "base/random.h"
#include "density/footprint_fit.h"
#include "surface/texture.h"
#include "tests/unit/check.h"

typedef void MapTo(double u, double v, double *x, double *y);

static void straight(double u, double v, double *x, double *y)
{
	*x = 2 * u + 0.3 * v;
	*y = 0.5 * v - 0.1 * u;
}

/* A fold along x = 0: density 1 / (2 sqrt(x)) over 0..1, of both sheets together. */
static void folded(double u, double v, double *x, double *y)
{
	*x = (2 * u - 1) * (2 * u - 1);
	*y = v;
}

/* count photons of flux 1 / count, Halton's points of the unit square of a plane emitter. */
static PhotonMap *make_map(uint32_t count, uint64_t first, MapTo *to)
{
	PhotonMap *map = photon_map_create();
	map->photons = calloc(count + 1, sizeof(Photon));
	map->lights = calloc(1, sizeof(PhotonLight));
	map->lights[0] = (PhotonLight){count, 1, 2};
	map->light_count = 1;
	map->count = count;
	for (uint32_t i = 0; i < count; i++) {
		Photon *p = &map->photons[i];
		double u = random_halton(first + i + 1, 0), v = random_halton(first + i + 1, 1), x,
		       y;
		to(u, v, &x, &y);
		*p = (Photon){.position = {(float)x, 0, (float)y},
			      .emitter = {(float)u, (float)v},
			      .edges = 2};
		photon_set_flux(p, rgb_scale(rgb(1, 1, 1), 1 / (float)count));
		photon_set_direction(p, vec3(0, 1, 0));
		photon_set_normal(p, vec3(0, 1, 0));
	}
	photon_map_index(map, 0);
	return map;
}

static Rgb white(void *data, Vec3 direction)
{
	(void)data;
	(void)direction;
	return rgb(1, 1, 1);
}

static DensityEstimator *make(const PhotonMap *map, double radius)
{
	Diag *diag = diag_create(NULL);
	PhotonSettings settings = photon_settings_default();
	Estimator method = {.kind = ESTIMATOR_FOOTPRINT};
	EstimatorSetup setup = {&method, &settings, map, radius};
	DensityEstimator *estimator = estimator_create(&setup, diag);
	CHECK(estimator && diag_errors(diag) == 0);
	diag_destroy(diag);
	return estimator;
}

static double density(const DensityEstimator *estimator, double x, double z, double pixel)
{
	GatherPoint point = {
		.position = vec3(x, 0, z), .normal = vec3(0, 1, 0), .footprint = pixel};
	GatherResult result;
	estimator_gather(estimator, &point, white, NULL, &result);
	return result.radiance.g;
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
			double x, y;
			straight(u, v, &x, &y);
			double value = density(estimator, x, y, 0);
			squares += (value / truth - 1) * (value / truth - 1);
			sum += value / truth;
			points++;
		}
	}
	CHECK_NEAR(sum / points, 1, 0.01);
	CHECK_NEAR(sqrt(squares / points), 0, 0.15);
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
		double x, y;
		straight(0.005, v, &x, &y);
		inside += density(estimator, x, y, 0) / truth;
		straight(-0.01, v, &x, &y);
		outside += density(estimator, x, y, 0) / truth;
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
			double x, z;
			straight(u, 0.5, &x, &z);
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
			double x, y;
			straight(u, v, &x, &y);
			GatherPoint point = {.position = vec3(x, 0, y), .normal = vec3(0, 1, 0)};
			GatherResult result;
			estimator_gather(estimator, &point, white, NULL, &result);
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

/* Passes of shrinking kernels come nearer to the truth beside a fold. */
static void test_passes(void)
{
	enum { PASSES = 64, POINTS = 20 };
	double sums[POINTS] = {0}, first = 0, last = 0;
	for (int pass = 0; pass < PASSES; pass++) {
		PhotonMap *map = make_map(600, (uint64_t)pass * 600, folded);
		double start = map->spacing * sqrt(50 / M_PI);
		DensityEstimator *estimator = make(map, start * pow(pass + 1, -1.0 / 6));
		double error = 0;
		for (int i = 0; i < POINTS; i++) {
			double x = 0.01 + 0.03 * i;
			sums[i] += density(estimator, x, 0.5, 0);
			error += pow(sums[i] / (pass + 1) * 2 * sqrt(x) - 1, 2) / POINTS;
		}
		first = pass == 0 ? sqrt(error) : first;
		last = sqrt(error);
		estimator_destroy(estimator);
		photon_map_destroy(map);
	}
	CHECK(last < 0.35 * first);
	CHECK(last < 0.1);
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
	CHECK_NEAR(fit.hessian[0].uu, 2, 0.1);
	CHECK_NEAR(fit.hessian[1].uv, 0.5, 0.05);
	CHECK(fit.roughness < 1e-3);
	CHECK(!footprint_fit(samples, 5, &fit));
}

int main(void)
{
	test_fit();
	test_even();
	test_energy();
	test_border();
	test_strangers();
	test_hues();
	test_passes();
	test_few();
	return CHECK_RESULT();
}
