/* The estimators on photons whose density is known. */
#include "density/estimator.h"

#include <stdlib.h>

#include "base/random.h"
#include "tests/unit/check.h"

/* Photons of flux 1/count, uniform on the unit square in the plane y = height, of normal (0, up, 0). */
static PhotonMap *uniform_map(uint32_t count, double height, double up)
{
	PhotonMap *map = photon_map_create();
	Sampler s = {5, 0, 0};
	map->photons = calloc(count + 1, sizeof(Photon));
	map->count = count;
	for (uint32_t i = 0; i < count; i++) {
		Photon *p = &map->photons[i];
		p->position[0] = (float)sampler_next(&s);
		p->position[1] = (float)height;
		p->position[2] = (float)sampler_next(&s);
		p->edges = 2;
		photon_set_flux(p, rgb_scale(rgb(1, 2, 3), 1 / (float)count));
		photon_set_direction(p, vec3(0, up, 0));
		photon_set_normal(p, vec3(0, up, 0));
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

static DensityEstimator *make(const Estimator *method, const PhotonMap *map, double radius)
{
	Diag *diag = diag_create(NULL);
	PhotonSettings settings = photon_settings_default();
	EstimatorSetup setup = {method, &settings, map, radius};
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
};

static void test_uniform(void)
{
	PhotonMap *map = uniform_map(20000, 0, 1);
	for (size_t i = 0; i < sizeof uniform_cases / sizeof *uniform_cases; i++) {
		DensityEstimator *estimator = make(&uniform_cases[i].method, map, uniform_cases[i].radius);
		double deviation, mean = mean_density(estimator, &deviation), noise = uniform_cases[i].noise;
		CHECK_NEAR(mean, 1, 0.02); /* the points' discs overlap: some 60 independent ones */
		CHECK(deviation > 0.7 * noise && deviation < 1.3 * noise);
		estimator_destroy(estimator);
	}
	photon_map_destroy(map);
}

int main(void)
{
	test_uniform();
	return CHECK_RESULT();
}
