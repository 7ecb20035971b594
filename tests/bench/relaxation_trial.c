/*
 * A trial of relaxation in two dimensions: how far the density of the wave's caustic (wave.h) is
 * from its reference, by the nearest K photons under Epanechnikov's kernel, for several K: of
 * photons where they landed, relaxed plainly, and under constraints. The reference is the
 * closed-form map itself, 36 million paths counted in pixels. The columns: RMSE and MRSE (eps
 * 1e-2) of a picture whose mean is about 1, the errors' squares averaged over three sets of
 * photons.
 *
 * Usage: relaxation_trial [-r] [-s SEED] [PHOTONS [SETTINGS ...]]
 * SETTINGS: PARAMETER_ITERATIONS,WORLD_ITERATIONS,RANGE,KC,KF; without any: the defaults, stage
 * one of them alone, and Spencer & Jones 2013's. -r: paths start anywhere, not at Halton's points.
 * -s: the first of the seeds, which shift Halton's points.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "base/arena.h"
#include "base/parallel.h"
#include "base/random.h"
#include "photon/relax.h"
#include "tests/bench/wave.h"

enum { PIXELS = 200, SAMPLES = 2, REFERENCE_PATHS = 36000000, SETS = 3 };

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

/* How the photons of a trial start. */
typedef struct Start {
	uint32_t paths;
	uint64_t seed;
	bool random;
} Start;

/* Where path i starts: a point of the light, its margin included, moved round by the seed. */
static void start_path(const Start *start, uint32_t i, double from[2])
{
	const double side = 1 + 2 * WAVE_MARGIN;
	wave_start(i + 1, from);
	for (int k = 0; k < 2; k++) {
		double at = random_uniform(start->seed, start->random ? i + 1 : 0, (uint64_t)k);
		if (!start->random)
			at += (from[k] + WAVE_MARGIN) / side;
		from[k] = (at - floor(at)) * side - WAVE_MARGIN;
	}
}

static PhotonMap *make_photons(const Start *start)
{
	uint32_t paths = start->paths;
	PhotonMap *map = photon_map_create();
	map->photons = memory_alloc(sizeof(Photon) * (paths + 1));
	double side = 1 + 2 * WAVE_MARGIN, flux = side * side / paths;
	for (uint32_t i = 0; i < paths; i++) {
		double from[2], to[2];
		start_path(start, i, from);
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

static void add_errors(const PhotonMap *map, const Image *reference, Row *row)
{
	static Image image;
	for (int i = 0; i < COUNTS; i++) {
		Job job = {map, counts[i], &image};
		parallel_for(PIXELS, 1, estimate_row, &job);
		Errors errors = errors_of(&image, reference);
		row->at[i].rmse += errors.rmse * errors.rmse / SETS;
		row->at[i].mrse += errors.mrse / SETS;
	}
}

/* settings NULL: photons stay. */
static Row measure(const char *name, Start start, const Relaxation *settings,
		   const Image *reference)
{
	Row row = {.best = 0};
	const RelaxSurfaces everywhere = {NULL, 0, NULL, NULL};
	for (int i = 0; i < SETS; i++, start.seed++) {
		PhotonMap *map = make_photons(&start);
		if (settings)
			photon_relax(map, settings, &everywhere, NULL);
		photon_map_index(map, 0);
		add_errors(map, reference, &row);
		photon_map_destroy(map);
	}
	printf("%-22s", name);
	for (int i = 0; i < COUNTS; i++) {
		row.at[i].rmse = sqrt(row.at[i].rmse);
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

static Relaxation read_settings(const char *text)
{
	Relaxation s = relaxation_default();
	sscanf(text, "%d,%d,%lf,%d,%d", &s.parameter_iterations, &s.world_iterations, &s.range,
	       &s.neighbors, &s.repulsion_neighbors);
	return s;
}

static void try_settings(Start start, const char *const *settings, int count)
{
	Image *reference = make_reference(REFERENCE_PATHS);
	Relaxation plain = relaxation_plain();
	printf("%-22s", "RMSE MRSE, by K");
	for (int i = 0; i < COUNTS; i++)
		printf(" %13d", counts[i]);
	printf("\n");
	Row nearest = measure("nearest", start, NULL, reference),
	    row = measure("plain", start, &plain, reference);
	compare("plain", &row, &nearest);
	for (int i = 0; i < count; i++) {
		char name[64];
		Relaxation relaxation = read_settings(settings[i]);
		snprintf(name, sizeof name, "constrained %s", settings[i]);
		row = measure(name, start, &relaxation, reference);
		compare(name, &row, &nearest);
	}
	free(reference);
}

int main(int argc, char **argv)
{
	static const char *const defaults[] = {"", "4,0", "7,7,3"};
	Start start = {60000, 1, false};
	for (int c; (c = getopt(argc, argv, "rs:")) != -1;) {
		if (c == '?')
			return 1;
		start.random |= c == 'r';
		start.seed = c == 's' ? strtoull(optarg, NULL, 10) : start.seed;
	}
	if (optind < argc)
		start.paths = (uint32_t)atoi(argv[optind++]);
	if (optind < argc)
		try_settings(start, (const char *const *)argv + optind, argc - optind);
	else
		try_settings(start, defaults, 3);
	return 0;
}
