/* The estimators on photons whose density is known. */
#include "density/estimator.h"

#include <stdlib.h>

#include "base/random.h"
#include "tests/unit/check.h"

static PhotonMap *empty_map(uint32_t room)
{
	PhotonMap *map = photon_map_create();
	map->photons = calloc(room + 1, sizeof(Photon));
	return map;
}

static void add_photon(PhotonMap *map, Vec3 at, Vec3 normal, float flux)
{
	Photon *p = &map->photons[map->count++];
	*p = (Photon){.position = {(float)at.x, (float)at.y, (float)at.z}, .edges = 2};
	photon_set_flux(p, rgb_scale(rgb(1, 2, 3), flux));
	photon_set_direction(p, normal);
	photon_set_normal(p, normal);
}

/* Photons of red flux 1/count, uniform on the square from x = left to 1, z = 0 to 1, in the
 * plane y = height. */
static void add_uniform(PhotonMap *map, uint32_t count, double left, double height, Vec3 normal)
{
	Sampler s = {5, map->count, 0};
	for (uint32_t i = 0; i < count; i++) {
		double x = left + (1 - left) * sampler_next(&s), z = sampler_next(&s);
		add_photon(map, vec3(x, height, z), normal, 1 / (float)count);
	}
}

static const Vec3 up = {0, 1, 0}, down = {0, -1, 0};

static PhotonMap *uniform_map(uint32_t count)
{
	PhotonMap *map = empty_map(count);
	add_uniform(map, count, 0, 0, up);
	photon_map_index(map, 0);
	return map;
}

static Rgb white(void *data, Vec3 direction)
{
	(void)data;
	(void)direction;
	return rgb(1, 1, 1);
}

static DensityEstimator *make(const Estimator *method, const PhotonMap *map, double radius)
{
	Diag *diag = diag_create(NULL);
	PhotonSettings settings = photon_settings_default();
	EstimatorSetup setup = {method, &settings, map, radius, NULL};
	DensityEstimator *estimator = estimator_create(&setup, diag);
	CHECK(estimator && diag_errors(diag) == 0);
	diag_destroy(diag);
	return estimator;
}

static GatherResult gather(const DensityEstimator *estimator, double x, double y, double z)
{
	GatherPoint point = {.position = vec3(x, y, z), .normal = vec3(0, 1, 0)};
	GatherResult result;
	estimator_gather(estimator, &point, white, NULL, &result);
	return result;
}

/* The mean over the middle of the square, where no disc reaches the border. */
static double mean_density(const DensityEstimator *estimator, double *deviation)
{
	enum { POINTS = 400 };
	double sum = 0, sum2 = 0;
	Sampler s = {6, 0, 0};
	for (int i = 0; i < POINTS; i++) {
		double x = 0.3 + 0.4 * sampler_next(&s), z = 0.3 + 0.4 * sampler_next(&s);
		double value = gather(estimator, x, 0, z).radiance.r;
		sum += value;
		sum2 += value * value;
	}
	*deviation = sqrt(sum2 / POINTS - sum / POINTS * sum / POINTS);
	return sum / POINTS;
}

/* Relative noise of an estimate from k photons: sqrt(pi * integral of the kernel squared / k). */
static const struct { Estimator method; double radius, noise; } uniform_cases[] = {
	{{.kind = ESTIMATOR_NEAREST, .count = 50}, 0, 0.14},
	{{.kind = ESTIMATOR_NEAREST, .count = 50, .kernel = KERNEL_CONE}, 0, 0.17},
	{{.kind = ESTIMATOR_NEAREST, .count = 50, .kernel = KERNEL_EPANECHNIKOV}, 0, 0.16},
	{{.kind = ESTIMATOR_NEAREST, .count = 50, .kernel = KERNEL_GAUSSIAN}, 0, 0.19},
	{{.kind = ESTIMATOR_NEAREST, .radius = 0.02}, 0, 0.2},
	{{.kind = ESTIMATOR_NEAREST, .count = 50}, 0.03, 0.133},
	{{.kind = ESTIMATOR_NEAREST}, 0, 0.1},
	{{.kind = ESTIMATOR_DIFFUSION, .count = 200}, 0, 0.1},
};

static void test_uniform(void)
{
	PhotonMap *map = uniform_map(20000);
	for (size_t i = 0; i < sizeof uniform_cases / sizeof *uniform_cases; i++) {
		DensityEstimator *estimator = make(&uniform_cases[i].method, map,
						   uniform_cases[i].radius);
		double deviation, mean = mean_density(estimator, &deviation),
				  noise = uniform_cases[i].noise;
		CHECK_NEAR(mean, 1, 0.02); /* the points' discs overlap: some 60 independent ones */
		CHECK(deviation > 0.7 * noise && deviation < 1.3 * noise);
		estimator_destroy(estimator);
	}
	photon_map_destroy(map);
}

/* What every test below asks of every method. */
static const Estimator every_method[] = {
	{.kind = ESTIMATOR_NEAREST},
	{.kind = ESTIMATOR_NEAREST, .count = 50, .kernel = KERNEL_EPANECHNIKOV},
	{.kind = ESTIMATOR_NEAREST, .radius = 0.05, .kernel = KERNEL_CONE},
	{.kind = ESTIMATOR_DIFFUSION, .count = 100},
};
enum { METHODS = sizeof every_method / sizeof *every_method };

static double value_at(const Estimator *method, const PhotonMap *map, double x, double y, double z)
{
	DensityEstimator *estimator = make(method, map, 0);
	double value = gather(estimator, x, y, z).radiance.r;
	estimator_destroy(estimator);
	return value;
}

/* Light on x > 0.5 only: full inside, about half on the edge for a disc of fixed radius, none
 * far outside. */
static void test_edge(void)
{
	PhotonMap *map = empty_map(20000);
	add_uniform(map, 20000, 0.5, 0, up);
	photon_map_index(map, 0);
	for (int i = 0; i < METHODS; i++) {
		DensityEstimator *estimator = make(&every_method[i], map, 0);
		double inside = 0, edge = 0, outside = 0;
		for (int k = 0; k < 100; k++) {
			double z = 0.2 + 0.006 * k;
			inside += gather(estimator, 0.75, 0, z).radiance.r / 100;
			edge += gather(estimator, 0.5, 0, z).radiance.r / 100;
			outside += gather(estimator, 0.4, 0, z).radiance.r / 100;
		}
		CHECK_NEAR(inside, 2, 0.1);
		CHECK(edge > 0.8 && edge < 1.6);
		CHECK(outside < 0.35);
		estimator_destroy(estimator);
	}
	photon_map_destroy(map);
}

/* How wide the edge is smeared, in x: the integral of 4 p (1 - p) for p rising from 0 to 1. */
static double edge_width(const DensityEstimator *estimator)
{
	double width = 0;
	for (int k = 0; k < 20; k++) {
		for (double x = 0.35; x < 0.65; x += 0.005) {
			double p = fmin(1, gather(estimator, x, 0, 0.2 + 0.03 * k).radiance.r / 2);
			width += 0.005 / 20 * 4 * p * (1 - p);
		}
	}
	return width;
}

/* The anisotropic kernel keeps an edge sharper than a round one from the same photons. */
static void test_diffusion_edge(void)
{
	PhotonMap *map = empty_map(20000);
	add_uniform(map, 20000, 0.5, 0, up);
	photon_map_index(map, 0);
	Estimator round = {.kind = ESTIMATOR_NEAREST, .count = 500, .kernel = KERNEL_GAUSSIAN};
	Estimator shaped = {.kind = ESTIMATOR_DIFFUSION, .count = 500};
	DensityEstimator *a = make(&round, map, 0), *b = make(&shaped, map, 0);
	double wide = edge_width(a), narrow = edge_width(b);
	CHECK(narrow < 0.7 * wide);
	estimator_destroy(a);
	estimator_destroy(b);
	photon_map_destroy(map);
}

/* Photons on the other side of a thin wall, on a shelf above, and on surfaces that stand
 * across do not count. */
static void test_other_surfaces(void)
{
	PhotonMap *map = empty_map(40000);
	add_uniform(map, 10000, 0, 0, up);
	add_uniform(map, 10000, 0, -0.0005, down);
	add_uniform(map, 10000, 0, 0.0002, vec3(1, 0, 0));
	add_uniform(map, 10000, 0, 0.05, up);
	photon_map_index(map, 0);
	for (int i = 0; i < METHODS; i++) {
		DensityEstimator *estimator = make(&every_method[i], map, 0);
		double sum = 0;
		for (int k = 0; k < 100; k++)
			sum += gather(estimator, 0.3 + 0.04 * (k % 10), 0, 0.3 + 0.004 * k)
				       .radiance.r /
			       100;
		CHECK_NEAR(sum, 1, 0.08);
		GatherPoint point = {
			.position = vec3(0.5, 0, 0.5), .normal = up, .both_sides = true};
		GatherResult one = gather(estimator, 0.5, 0, 0.5), both;
		estimator_gather(estimator, &point, white, NULL, &both);
		CHECK_NEAR(both.radiance.r, 2 * one.radiance.r, 0.8 * one.radiance.r);
		estimator_destroy(estimator);
	}
	photon_map_destroy(map);
}

static void check_finite(const PhotonMap *map, double most)
{
	for (int i = 0; i < METHODS; i++) {
		double at = value_at(&every_method[i], map, 0.5, 0, 0.5);
		double near = value_at(&every_method[i], map, 0.51, 0, 0.5);
		CHECK(isfinite(at) && isfinite(near) && at >= 0 && near >= 0 && at <= most &&
		      near <= most);
	}
}

static void test_few_photons(void)
{
	for (uint32_t count = 0; count < 3; count++) {
		PhotonMap *map = empty_map(count);
		for (uint32_t i = 0; i < count; i++)
			add_photon(map, vec3(0.5 + 0.01 * i, 0, 0.5), up, 1);
		photon_map_index(map, 0);
		check_finite(map, count == 0 ? 0 : 1e5);
		photon_map_destroy(map);
	}
	PhotonMap *map = empty_map(500);
	for (int i = 0; i < 500; i++)
		add_photon(map, vec3(0.5, 0, 0.5), up, 0.002f);
	photon_map_index(map, 0);
	check_finite(map, 1e7);
	/* A kernel of known width: one photon of flux 1. */
	CHECK_NEAR(value_at(&every_method[2], map, 0.5, 0, 0.5), 3 / (M_PI * 0.05 * 0.05), 0.1);
	photon_map_destroy(map);
}

/* Seen slantwise by pixels wider than discs of k photons are, light is counted pixel by pixel: the
 * sum over all pixels is the photons' flux, each once. */
static void test_pixels(void)
{
	enum { ACROSS = 10, DOWN = 5 };
	PhotonMap *map = uniform_map(20000);
	for (int k = 0; k < 2; k++) {
		const Estimator method = {.kind = k ? ESTIMATOR_DIFFUSION : ESTIMATOR_NEAREST,
					  .count = 15};
		DensityEstimator *estimator = make(&method, map, 0);
		double width = 1.0 / ACROSS, length = 1.0 / DOWN, sum = 0, photons = 0;
		for (int i = 0; i < ACROSS * DOWN; i++) {
			GatherPoint point = {.position = vec3((i % ACROSS + 0.5) * width, 0,
							      (i / ACROSS + 0.5) * length),
					     .normal = up, .footprint = width,
					     .view = vec3(0, -width / length, -sqrt(0.75)),
					     .across = vec3(2, 0, 0)};
			GatherResult result;
			estimator_gather(estimator, &point, white, NULL, &result);
			sum += width * length * result.radiance.r;
			photons += result.photons;
		}
		CHECK_NEAR(sum, 1, 1e-4);
		CHECK_NEAR(photons, 20000, 0.5);
		estimator_destroy(estimator);
	}
	photon_map_destroy(map);
}

/* The result holds how many photons there were, their colours, and nothing of their order. */
static void test_order(void)
{
	PhotonMap *map = uniform_map(5000), *turned = empty_map(5000);
	turned->count = map->count;
	for (uint32_t i = 0; i < map->count; i++)
		turned->photons[map->count - 1 - i] = map->photons[i];
	photon_map_index(turned, 0);
	for (int i = 1; i < METHODS; i++) {
		DensityEstimator *a = make(&every_method[i], map, 0),
				 *b = make(&every_method[i], turned, 0);
		for (int k = 0; k < 50; k++) {
			GatherResult x = gather(a, 0.2 + 0.01 * k, 0, 0.5),
				     y = gather(b, 0.2 + 0.01 * k, 0, 0.5);
			CHECK_NEAR(y.radiance.r, x.radiance.r, 1e-4 * x.radiance.r);
			CHECK_NEAR(x.radiance.b, 3 * x.radiance.r, 1e-3 * x.radiance.b);
			CHECK(x.photons == y.photons && x.edges == 2 && x.parameter.g == 0.5f);
		}
		CHECK(every_method[i].count == 0 ||
		      gather(a, 0.5, 0, 0.5).photons == every_method[i].count);
		estimator_destroy(a);
		estimator_destroy(b);
	}
	photon_map_destroy(map);
	photon_map_destroy(turned);
}

/* What the layers show: the first light lies on a plane of radius 2, the second is a point. */
static void test_layers(void)
{
	PhotonMap *map = empty_map(10);
	PhotonLight lights[] = {{1, 4 * M_PI, 2}, {1, 1, 3}};
	PhotonConstraint constraints[10];
	for (int i = 0; i < 10; i++) {
		add_photon(map, vec3(0.5 + 0.001 * i, 0, 0.5), up, 1);
		Photon *p = &map->photons[i];
		p->light = i >= 5;
		p->edges = (uint8_t)(i >= 5 ? 6 : 3);
		p->emitter[0] = p->light ? -1 : 1;
		constraints[i] = (PhotonConstraint){{1, 0, 0}, p->light ? 0.25f : 1};
	}
	map->lights = lights;
	map->light_count = 2;
	map->constraints = constraints;
	photon_map_index(map, 0);
	Estimator method = {.kind = ESTIMATOR_NEAREST, .count = 10};
	DensityEstimator *estimator = make(&method, map, 0);
	GatherResult all = gather(estimator, 0.5, 0, 0.5);
	CHECK(all.photons == 10);
	CHECK_NEAR(all.edges, 4.5, 1e-6);
	CHECK_NEAR(all.constraint, 0.375, 1e-6);
	/* 1/2 + 1/2 * 1 / 2 and 1/2 - 1/2. */
	CHECK_NEAR(all.parameter.r, (0.75 + 0) / 2, 1e-6);
	CHECK_NEAR(all.parameter.g, 0.5, 1e-6);
	estimator_destroy(estimator);
	map->lights = NULL;
	map->constraints = NULL;
	photon_map_destroy(map);
}

/* A search that finds too few is made three times as wide, but not over an edge: a lone photon
 * in the dark lights a disc. */
static void test_expansion(void)
{
	PhotonMap *map = empty_map(20000);
	PhotonSettings settings = photon_settings_default();
	settings.radii[0].radius = 0.015;
	Estimator plain = {.kind = ESTIMATOR_NEAREST};
	EstimatorSetup setup = {&plain, &settings, map, 0, NULL};
	Diag *diag = diag_create(NULL);
	add_uniform(map, 19000, 0.5, 0, up);
	add_photon(map, vec3(0.25, 0, 0.5), up, 1);
	photon_map_index(map, 0);
	DensityEstimator *estimator = estimator_create(&setup, diag);
	CHECK_NEAR(gather(estimator, 0.25, 0, 0.5).radius, 0.045, 1e-9);
	CHECK_NEAR(gather(estimator, 0.29, 0, 0.5).radiance.r, 1 / (M_PI * 0.045 * 0.045), 1e-2);
	CHECK(gather(estimator, 0.3, 0, 0.5).radiance.r == 0);
	/* Beyond the edge: the wider search is denser. */
	CHECK(gather(estimator, 0.48, 0, 0.5).radiance.r == 0);
	CHECK_NEAR(gather(estimator, 0.75, 0, 0.5).radius, 0.015, 1e-9);
	estimator_destroy(estimator);
	photon_map_destroy(map);
	diag_destroy(diag);
}

static void test_failures(void)
{
	PhotonMap *map = uniform_map(10);
	PhotonSettings settings = photon_settings_default();
	Estimator many = {.kind = ESTIMATOR_NEAREST, .count = 1000000};
	Estimator none = {.kind = ESTIMATOR_ADAPTIVE};
	EstimatorSetup setup = {&many, &settings, map, 0, NULL};
	Diag *diag = diag_create(NULL);
	CHECK(!estimator_create(&setup, diag) && diag_errors(diag) == 1);
	setup.method = &none;
	CHECK(!estimator_create(&setup, diag) && diag_errors(diag) == 2);
	estimator_destroy(NULL);
	photon_map_destroy(map);
	diag_destroy(diag);
}

int main(void)
{
	test_uniform();
	test_edge();
	test_diffusion_edge();
	test_other_surfaces();
	test_few_photons();
	test_pixels();
	test_order();
	test_layers();
	test_expansion();
	test_failures();
	return CHECK_RESULT();
}
