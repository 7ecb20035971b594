/*
 * The footprint estimator beside k nearest photons, on a map from emitter to floor that is known:
 * light refracted by a wavy sheet, with folds. The reference counts a great number of photons in
 * each pixel. Prints RMSE (mean density: 1) and microseconds a gather for each number of photons.
 *
 *   footprint_trial [photons ...]
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "base/clock.h"
#include "density/estimator.h"
#include "tests/bench/known_map.h"

enum { SIDE = 160, REFERENCE_SIDE = 6400 };

/* The sheet reaches a little over the floor's square [0, 1]^2, so that the square has no border. */
static const double margin = 0.15;

static void floor_of(double u, double v, double to[2])
{
	double a = 2 * M_PI;
	to[0] = u + 0.035 * cos(a * (2 * u + v)) + 0.03 * cos(a * (3 * u - 2 * v) + 1) +
	     0.012 * cos(a * 5 * v + 2);
	to[1] = v + 0.0175 * cos(a * (2 * u + v)) - 0.02 * cos(a * (3 * u - 2 * v) + 1) +
	     0.02 * cos(a * 4 * v);
}

static void add_sample(double *image, double u, double v, double flux)
{
	double to[2];
	floor_of(u, v, to);
	int i = (int)floor(to[0] * SIDE), j = (int)floor(to[1] * SIDE);
	if (i >= 0 && i < SIDE && j >= 0 && j < SIDE)
		image[j * SIDE + i] += flux * SIDE * SIDE;
}

static double *make_reference(void)
{
	double *image = calloc(SIDE * SIDE, sizeof *image), width = 1 + 2 * margin;
	double flux = width * width / REFERENCE_SIDE / REFERENCE_SIDE;
	for (int j = 0; j < REFERENCE_SIDE; j++)
		for (int i = 0; i < REFERENCE_SIDE; i++)
			add_sample(image, (i + 0.5) / REFERENCE_SIDE * width - margin,
				   (j + 0.5) / REFERENCE_SIDE * width - margin, flux);
	return image;
}

/* count photons on the sheet's part over the floor. */
static PhotonMap *make_map(long count)
{
	double width = 1 + 2 * margin;
	const KnownMap known = {floor_of, -margin, width};
	return known_map_make(&known, (uint32_t)(count * width * width), 0);
}

static void add_estimate(const PhotonMap *map, const Estimator *method, double radius,
			 double *image, double *seconds)
{
	Diag *diag = diag_create(NULL);
	PhotonSettings settings = photon_settings_default();
	EstimatorSetup setup = {method, &settings, map, radius, NULL};
	DensityEstimator *estimator = estimator_create(&setup, diag);
	double start = clock_cpu();
	for (int j = 0; j < SIDE; j++) {
		for (int i = 0; i < SIDE; i++) {
			GatherPoint point = {
				.position = vec3((i + 0.5) / SIDE, 0, (j + 0.5) / SIDE),
				.normal = vec3(0, 1, 0),
				.footprint = 1.0 / SIDE};
			GatherResult result;
			estimator_gather(estimator, &point, known_map_white, NULL, &result);
			image[j * SIDE + i] += result.radiance.r;
		}
	}
	*seconds = clock_cpu() - start;
	estimator_destroy(estimator);
	diag_destroy(diag);
}

static double error_of(const double *image, double scale, const double *reference)
{
	double sum = 0;
	for (int i = 0; i < SIDE * SIDE; i++)
		sum += (scale * image[i] - reference[i]) * (scale * image[i] - reference[i]);
	return sqrt(sum / (SIDE * SIDE));
}

static double measure(const PhotonMap *map, const Estimator *method, const double *reference,
		      double *seconds)
{
	double *image = calloc(SIDE * SIDE, sizeof *image);
	add_estimate(map, method, 0, image, seconds);
	double error = error_of(image, 1, reference);
	free(image);
	return error;
}

static void compare(long photons, const double *reference)
{
	static const int counts[] = {8, 15, 25, 50, 100, 200};
	static const double scales[] = {0.5, 0.7, 1, 1.4};
	double seconds, micro = 1e6 / SIDE / SIDE;
	PhotonMap *map = make_map(photons);
	for (int i = 0; i < 6; i++) {
		Estimator e = {.kind = ESTIMATOR_NEAREST,
			       .kernel = KERNEL_EPANECHNIKOV,
			       .count = counts[i]};
		double error = measure(map, &e, reference, &seconds);
		printf("%8ld  nearest %4d     %.4f  %6.2f us\n", photons, counts[i], error,
		       seconds * micro);
	}
	for (int i = 0; i < 4; i++) {
		Estimator e = {.kind = ESTIMATOR_FOOTPRINT, .scale = scales[i]};
		double error = measure(map, &e, reference, &seconds);
		printf("%8ld  footprint %4.1f   %.4f  %6.2f us\n", photons, scales[i], error,
		       seconds * micro);
	}
	photon_map_destroy(map);
}

int main(int argc, char **argv)
{
	double *reference = make_reference();
	for (int i = 1; i < argc; i++)
		compare(atol(argv[i]), reference);
	if (argc < 2)
		compare(15000, reference);
	free(reference);
	return 0;
}
