/*
 * A trial of relaxation in two dimensions: how far the density of the wave's caustic (wave.h) is
 * from its reference, by the nearest K photons under Epanechnikov's kernel, for several K: of
 * photons where they landed, relaxed plainly, and under constraints. The reference is the
 * closed-form map itself, 12 million paths counted in pixels. The columns: RMSE and MRSE (eps
 * 1e-2) of a picture whose mean is about 1.
 *
 * Usage: relaxation_trial [PHOTONS [PARAMETER_ITERATIONS,WORLD_ITERATIONS,RANGE,KC,KF ...]]
 * Without settings: the defaults, and stage one alone.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/arena.h"
#include "base/parallel.h"
#include "photon/relax.h"
#include "tests/bench/wave.h"

enum { PIXELS = 200, SAMPLES = 2, REFERENCE_PATHS = 12000000 };

typedef struct Image { double at[PIXELS * PIXELS]; } Image;

static Image *make_reference(uint64_t paths)
{
	Image *image = memory_alloc(sizeof *image);
	memset(image, 0, sizeof *image);
	for (uint64_t i = 1; i <= paths; i++) {
		double from[2], to[2];
		wave_start(i, from);
		wave_map(from[0], from[1], to);
		if (to[0] >= 0 && to[0] < 1 && to[1] >= 0 && to[1] < 1)
			image->at[(int)(to[1] * PIXELS) * PIXELS + (int)(to[0] * PIXELS)]++;
	}
	double side = 1 + 2 * WAVE_MARGIN;
	for (int i = 0; i < PIXELS * PIXELS; i++)
		image->at[i] *= side * side * PIXELS * PIXELS / (double)paths;
	return image;
}

static PhotonMap *make_photons(uint32_t paths)
{
	PhotonMap *map = photon_map_create();
	map->photons = memory_alloc(sizeof(Photon) * (paths + 1));
	double side = 1 + 2 * WAVE_MARGIN, flux = side * side / paths;
	for (uint32_t i = 0; i < paths; i++) {
		double from[2], to[2];
		wave_start(i + 1, from);
		wave_map(from[0], from[1], to);
		Photon photon = {.position = {(float)to[0], 0, (float)to[1]},
				 .emitter = {(float)from[0], (float)from[1], 0},
				 .edges = 2};
		photon_set_flux(&photon, rgb((float)flux, (float)flux, (float)flux));
		photon_set_normal(&photon, vec3(0, 1, 0));
		map->photons[map->count++] = photon;
	}
	return map;
}

/* Density by the k nearest. */
static double estimate(const PhotonMap *map, double x, double z, int k)
{
	Neighbor near[k + 8 * TREE_SLACK];
	NearestQuery query = {{(float)x, 0, (float)z}, INFINITY, k, NULL};
	int count = photon_tree_nearest(map->tree, &query, near);
	double r2 = photon_tree_farthest(near, count), sum = 0;
	for (int i = 0; i < count; i++)
		sum += (double)photon_flux(&map->photons[near[i].index]).r *
		       (1 - near[i].distance2 / r2);
	return sum * 2 / (M_PI * r2);
}

typedef struct Job {
	const PhotonMap *map;
	int k;
	Image *image;
} Job;

static void estimate_row(void *data, long row, int thread)
{
	(void)thread;
	const Job *job = data;
	for (int column = 0; column < PIXELS; column++) {
		double sum = 0;
		for (int s = 0; s < SAMPLES * SAMPLES; s++) {
			double x = column + (s % SAMPLES + 0.5) / SAMPLES,
			       z = (double)row + (s / SAMPLES + 0.5) / SAMPLES;
			sum += estimate(job->map, x / PIXELS, z / PIXELS, job->k);
		}
		job->image->at[row * PIXELS + column] = sum / (SAMPLES * SAMPLES);
	}
}

typedef struct Errors { double rmse, mrse; } Errors;

static Errors errors_of(const Image *image, const Image *reference)
{
	double squares = 0, relative = 0;
	for (int i = 0; i < PIXELS * PIXELS; i++) {
		double d = image->at[i] - reference->at[i], r = reference->at[i];
		squares += d * d;
		relative += d * d / (r * r + 1e-2);
	}
	return (Errors){sqrt(squares / (PIXELS * PIXELS)), relative / (PIXELS * PIXELS)};
}

static const int counts[] = {6, 10, 15, 20, 30, 50};
enum { COUNTS = sizeof counts / sizeof *counts, FIFTEEN = 2 };

typedef struct Row { Errors at[COUNTS]; int best; } Row;

static Row measure(const char *name, PhotonMap *map, const Image *reference)
{
	Row row = {.best = 0};
	static Image image;
	photon_map_index(map, 0);
	printf("%-22s", name);
	for (int i = 0; i < COUNTS; i++) {
		Job job = {map, counts[i], &image};
		parallel_for(PIXELS, 1, estimate_row, &job);
		row.at[i] = errors_of(&image, reference);
		row.best = row.at[i].rmse < row.at[row.best].rmse ? i : row.best;
		printf(" %6.4f %6.4f", row.at[i].rmse, row.at[i].mrse);
	}
	printf("   best K %d\n", counts[row.best]);
	fflush(stdout);
	return row;
}

static void compare(const char *name, const Row *row, const Row *nearest)
{
	printf("%-22s K = 15: %.3f of nearest's K = 15; best K: %.3f of nearest's best\n", name,
	       row->at[FIFTEEN].rmse / nearest->at[FIFTEEN].rmse,
	       row->at[row->best].rmse / nearest->at[nearest->best].rmse);
}

static Row relaxed(const char *name, uint32_t paths, Relaxation settings, const Image *reference)
{
	const RelaxSurfaces everywhere = {NULL, 0, NULL, NULL};
	RelaxStatistics statistics;
	PhotonMap *map = make_photons(paths);
	photon_relax(map, &settings, &everywhere, &statistics);
	Row row = measure(name, map, reference);
	photon_map_destroy(map);
	return row;
}

static Relaxation read_settings(const char *text)
{
	Relaxation s = relaxation_default();
	sscanf(text, "%d,%d,%lf,%d,%d", &s.parameter_iterations, &s.world_iterations, &s.range,
	       &s.neighbors, &s.repulsion_neighbors);
	return s;
}

int main(int argc, char **argv)
{
	const char *const defaults[] = {"", "7,0"},
			  *const *settings = argc > 2 ? (const char *const *)argv + 2 : defaults;
	int count = argc > 2 ? argc - 2 : 2;
	uint32_t paths = argc > 1 ? (uint32_t)atoi(argv[1]) : 60000;
	Relaxation plain = relaxation_default();
	plain.constrained = false;
	plain.parameter_iterations = plain.world_iterations = 7;
	Image *reference = make_reference(REFERENCE_PATHS);
	printf("%-22s", "RMSE MRSE, by K");
	for (int i = 0; i < COUNTS; i++)
		printf(" %13d", counts[i]);
	printf("\n");
	PhotonMap *map = make_photons(paths);
	Row nearest = measure("nearest", map, reference),
	    row = relaxed("plain", paths, plain, reference);
	compare("plain", &row, &nearest);
	for (int i = 0; i < count; i++) {
		char name[64];
		snprintf(name, sizeof name, "constrained %s", settings[i]);
		row = relaxed(name, paths, read_settings(settings[i]), reference);
		compare(name, &row, &nearest);
	}
	photon_map_destroy(map);
	free(reference);
	return 0;
}
