/*
 * A trial of relaxation in two dimensions: how far the density of the wave's caustic (wave.h) is
 * from the closed-form map's, by the nearest K photons under Epanechnikov's kernel, for several K:
 * of photons where they landed, relaxed plainly, and under constraints.
 *
 * Density is without bound at folds, and so is its square's integral: a value at a point is no
 * reference there, and the error depends on how large the pixels are. So both sides are means over
 * pixels. The reference counts paths, as many as 240 times the photons, one from each cell of a
 * grid over the light; its own noise is taken out with two halves of it, MSE = mean((picture -
 * a)(picture - b)). The estimate is sampled more closely than its discs are wide.
 *
 * Two waves. The gentle one, its 180 pixels a side for any number of photons and starts anywhere on
 * the light were chosen by the nearest photons alone, before anything was relaxed on it: at their
 * best K their RMSE was to be that of a trial of others, 0.50 with 15,000 photons and 0.36 with
 * 60,000 (it is 0.47 and 0.37), and with 600,000, where that trial had relaxed photons at K = 15
 * below 0.6 of nearest K = 15 and no lower than 0.8 of nearest at its best, K = 15 at least a third
 * worse than the best (it is). Halton's starts meet the first two with 256 pixels and not the last.
 * The detailed wave (-d) has finer structure than the photons resolve. It starts at Halton's
 * points, and its pixels are as large as holds two thirds of a photon on the average, so that
 * trials with more photons show finer pictures.
 *
 * The columns: RMSE and MRSE (eps 1e-2) of a picture whose mean is about 1, the errors' squares
 * averaged over the sets of photons; and RMSE without the brightest hundredth of the pixels, as a
 * few at the folds rule the whole.
 *
 * Usage: relaxation_trial [-d] [-r|-q] [-s SEED] [-n SETS] [-p PIXELS] [PHOTONS [SETTINGS ...]]
 * SETTINGS: PARAMETER_ITERATIONS,WORLD_ITERATIONS,RANGE,KC,KF; without any: the defaults, stage
 * one of them alone, and Spencer & Jones 2013's. -r: paths start anywhere, -q: at Halton's points.
 * -s: the first of the seeds, which shift Halton's points. -p: so many pixels a side.
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

/* A square picture of the unit square. */
typedef struct Image {
	int side;
	double *at;
} Image;

static Image image_create(int side)
{
	size_t size = sizeof(double) * (size_t)side * (size_t)side;
	Image image = {side, memory_alloc(size)};
	memset(image.at, 0, size);
	return image;
}

/* ---- the reference ---- */

/* What is tried: the wave, and how the photons of a set start. */
typedef struct Start {
	const WaveSheet *sheet;
	uint32_t paths;
	uint64_t seed;
	bool random;
	int sets, pixels;
} Start;

enum { HALVES = 2, STRIPS = 8, REFERENCE_FACTOR = 240 };

typedef struct Reference {
	Image halves[HALVES], mean;
	double bright; /* what a hundredth of the pixels is brighter than */
} Reference;

/* A strip of a half: each has a picture of its own, so that the sums have one order. */
typedef struct Counting {
	const WaveSheet *sheet;
	int grid; /* cells of a half along a side of the light */
	Image strips[HALVES * STRIPS];
} Counting;

static void count_path(const WaveSheet *sheet, Image *image, const double from[2])
{
	double to[2];
	wave_map(sheet, from[0], from[1], to);
	if (to[0] >= 0 && to[0] < 1 && to[1] >= 0 && to[1] < 1)
		image->at[(int)(to[1] * image->side) * image->side + (int)(to[0] * image->side)]++;
}

static void count_strip(void *data, long strip, int thread)
{
	(void)thread;
	Counting *counting = data;
	int grid = counting->grid;
	for (int row = (int)(strip / HALVES); row < grid; row += STRIPS) {
		for (int column = 0; column < grid; column++) {
			uint64_t cell = (uint64_t)row * (uint64_t)grid + (uint64_t)column;
			double from[2];
			for (int k = 0; k < 2; k++) {
				double at = random_uniform((uint64_t)(strip % HALVES), cell,
							   (uint64_t)k);
				from[k] = (at + (k == 0 ? column : row)) / grid *
						  wave_side(counting->sheet) -
					  counting->sheet->margin;
			}
			count_path(counting->sheet, &counting->strips[strip], from);
		}
	}
}

static int compare_values(const void *a, const void *b)
{
	const double *x = a, *y = b;
	return (*x > *y) - (*x < *y);
}

static double brighter_than(const Image *image, double share)
{
	size_t count = (size_t)image->side * (size_t)image->side;
	double *sorted = memory_alloc(sizeof *sorted * count);
	memcpy(sorted, image->at, sizeof *sorted * count);
	qsort(sorted, count, sizeof *sorted, compare_values);
	double value = sorted[(size_t)((1 - share) * (double)count)];
	free(sorted);
	return value;
}

static Reference reference_create(const Start *start)
{
	int side = start->pixels;
	Counting counting = {.sheet = start->sheet,
			     .grid = (int)sqrt((double)start->paths * REFERENCE_FACTOR / HALVES)};
	Reference reference = {.mean = image_create(side)};
	for (int i = 0; i < HALVES * STRIPS; i++)
		counting.strips[i] = image_create(side);
	parallel_for((long)HALVES * STRIPS, 1, count_strip, &counting);
	double scale = pow(wave_side(start->sheet) * side / counting.grid, 2);
	for (int h = 0; h < HALVES; h++) {
		reference.halves[h] = image_create(side);
		for (int i = h; i < HALVES * STRIPS; i += HALVES) {
			for (int p = 0; p < side * side; p++) {
				double density = scale * counting.strips[i].at[p];
				reference.halves[h].at[p] += density;
				reference.mean.at[p] += density / HALVES;
			}
			free(counting.strips[i].at);
		}
	}
	reference.bright = brighter_than(&reference.mean, 0.01);
	return reference;
}

static void reference_free(Reference *reference)
{
	for (int h = 0; h < HALVES; h++)
		free(reference->halves[h].at);
	free(reference->mean.at);
}

/* ---- photons ---- */

/* Where path i starts: a point of the light, its margin included, moved round by the seed. */
static void start_path(const Start *start, uint32_t i, double from[2])
{
	double margin = start->sheet->margin, side = wave_side(start->sheet);
	wave_start(start->sheet, i + 1, from);
	for (int k = 0; k < 2; k++) {
		double at = random_uniform(start->seed, start->random ? i + 1 : 0, (uint64_t)k);
		if (!start->random)
			at += (from[k] + margin) / side;
		from[k] = (at - floor(at)) * side - margin;
	}
}

static PhotonMap *make_photons(const Start *start)
{
	uint32_t paths = start->paths;
	PhotonMap *map = photon_map_create();
	map->photons = memory_alloc(sizeof(Photon) * (paths + 1));
	map->lights = memory_alloc(sizeof(PhotonLight));
	map->lights[0] = (PhotonLight){paths, pow(wave_side(start->sheet), 2), 2};
	map->light_count = 1;
	double flux = pow(wave_side(start->sheet), 2) / paths;
	for (uint32_t i = 0; i < paths; i++) {
		double from[2], to[2];
		start_path(start, i, from);
		wave_map(start->sheet, from[0], from[1], to);
		Photon photon = {.position = {(float)to[0], 0, (float)to[1]},
				 .emitter = {(float)from[0], (float)from[1], 0},
				 .edges = 2};
		photon_set_flux(&photon, rgb((float)flux, (float)flux, (float)flux));
		photon_set_normal(&photon, vec3(0, 1, 0));
		map->photons[map->count++] = photon;
	}
	return map;
}

/* ---- the estimate ---- */

/* Density by the k nearest; *radius: the least so far of their discs. */
static double estimate(const PhotonMap *map, double x, double z, int k, double *radius)
{
	Neighbor near[k + 8 * TREE_SLACK];
	NearestQuery query = {{(float)x, 0, (float)z}, INFINITY, k, NULL};
	int count = photon_tree_nearest(map->tree, &query, near);
	double r2 = photon_tree_farthest(near, count), sum = 0;
	for (int i = 0; i < count; i++)
		sum += (double)photon_flux(&map->photons[near[i].index]).r *
		       (1 - near[i].distance2 / r2);
	*radius = fmin(*radius, sqrt(r2));
	return sum * 2 / (M_PI * r2);
}

typedef struct Job {
	const PhotonMap *map;
	int k;
	Image *image;
} Job;

static double pixel_mean(const Job *job, int column, int row, int samples, double *radius)
{
	double sum = 0, side = job->image->side;
	for (int s = 0; s < samples * samples; s++)
		sum += estimate(job->map, (column + (s % samples + 0.5) / samples) / side,
				(row + (s / samples + 0.5) / samples) / side, job->k, radius);
	return sum / (samples * samples);
}

/* Samples along a pixel's side: at first, and so many that a disc is at least two wide. */
enum { FIRST_SAMPLES = 3, MOST_SAMPLES = 16 };

static void estimate_row(void *data, long row, int thread)
{
	(void)thread;
	const Job *job = data;
	int side = job->image->side;
	for (int column = 0; column < side; column++) {
		double radius = INFINITY,
		       mean = pixel_mean(job, column, (int)row, FIRST_SAMPLES, &radius);
		int samples = (int)fmin(2 / (radius * side), MOST_SAMPLES);
		if (samples > FIRST_SAMPLES)
			mean = pixel_mean(job, column, (int)row, samples, &radius);
		job->image->at[row * side + column] = mean;
	}
}

/* ---- errors ---- */

typedef struct Errors { double squares, relative, dim; } Errors; /* means of squares */

static Errors errors_of(const Image *image, const Reference *reference)
{
	Errors sum = {0, 0, 0};
	int pixels = image->side * image->side, dim = 0;
	for (int i = 0; i < pixels; i++) {
		double square = (image->at[i] - reference->halves[0].at[i]) *
				(image->at[i] - reference->halves[1].at[i]),
		       r = reference->mean.at[i];
		sum.squares += square / pixels;
		sum.relative += square / (r * r + 1e-2) / pixels;
		if (r <= reference->bright) {
			sum.dim += square;
			dim++;
		}
	}
	sum.dim /= dim;
	return sum;
}

static const int counts[] = {4, 6, 10, 15, 20, 30, 42, 60, 85, 120};
enum { COUNTS = sizeof counts / sizeof *counts, FIFTEEN = 3 };

/* RMSE, MRSE and RMSE of the dimmer pixels by K, and which K has the least RMSE. */
typedef struct Row { double rmse[COUNTS], mrse[COUNTS], dim[COUNTS]; int best; } Row;

static void add_errors(const PhotonMap *map, const Reference *reference, int sets, Row *row)
{
	Image image = image_create(reference->mean.side);
	for (int i = 0; i < COUNTS; i++) {
		Job job = {map, counts[i], &image};
		parallel_for(image.side, 1, estimate_row, &job);
		Errors errors = errors_of(&image, reference);
		row->rmse[i] += errors.squares / sets;
		row->mrse[i] += errors.relative / sets;
		row->dim[i] += errors.dim / sets;
	}
	free(image.at);
}

static void print_values(const char *name, const double *values)
{
	printf(" %-5s", name);
	for (int i = 0; i < COUNTS; i++)
		printf(" %7.4f", values[i]);
	printf("\n");
}

/* settings NULL: photons stay. */
static Row measure(const char *name, Start start, const Relaxation *settings,
		   const Reference *reference)
{
	Row row = {.best = 0};
	const RelaxSurfaces everywhere = {.project = NULL};
	for (int i = 0; i < start.sets; i++, start.seed++) {
		PhotonMap *map = make_photons(&start);
		if (settings)
			photon_relax(map, settings, &everywhere, NULL);
		photon_map_index(map, 0);
		add_errors(map, reference, start.sets, &row);
		photon_map_destroy(map);
	}
	for (int i = 0; i < COUNTS; i++) {
		row.rmse[i] = sqrt(row.rmse[i]);
		row.dim[i] = sqrt(row.dim[i]);
		row.best = row.rmse[i] < row.rmse[row.best] ? i : row.best;
	}
	printf("%s, best K %d\n", name, counts[row.best]);
	print_values("RMSE", row.rmse);
	print_values("dim", row.dim);
	print_values("MRSE", row.mrse);
	fflush(stdout);
	return row;
}

static void compare(const Row *row, const Row *nearest)
{
	int best = 0, nearest_best = 0;
	for (int i = 0; i < COUNTS; i++) {
		best = row->dim[i] < row->dim[best] ? i : best;
		nearest_best = nearest->dim[i] < nearest->dim[nearest_best] ? i : nearest_best;
	}
	printf(" of nearest: K = 15 %.3f, best K %.3f; dim: K = 15 %.3f, best K %.3f\n",
	       row->rmse[FIFTEEN] / nearest->rmse[FIFTEEN],
	       row->rmse[row->best] / nearest->rmse[nearest->best],
	       row->dim[FIFTEEN] / nearest->dim[FIFTEEN],
	       row->dim[best] / nearest->dim[nearest_best]);
	fflush(stdout);
}

/*
 * What is left of the error at K = 15 without any noise, by discs as large over many times the
 * photons: no relaxation can do better.
 */
static void measure_blur(Start start, const Reference *reference, const Row *nearest)
{
	const int more = 16;
	start.paths *= (uint32_t)more;
	PhotonMap *map = make_photons(&start);
	photon_map_index(map, 0);
	Image image = image_create(reference->mean.side);
	Job job = {map, counts[FIFTEEN] * more, &image};
	parallel_for(image.side, 1, estimate_row, &job);
	Errors errors = errors_of(&image, reference);
	printf("blur alone, K = 15: RMSE %.4f dim %.4f MRSE %.4f; of nearest %.3f, dim %.3f\n",
	       sqrt(errors.squares), sqrt(errors.dim), errors.relative,
	       sqrt(errors.squares) / nearest->rmse[FIFTEEN],
	       sqrt(errors.dim) / nearest->dim[FIFTEEN]);
	free(image.at);
	photon_map_destroy(map);
}

/* ---- the whole ---- */

static Relaxation read_settings(const char *text)
{
	Relaxation s = relaxation_default();
	sscanf(text, "%d,%d,%lf,%d,%d", &s.parameter_iterations, &s.world_iterations, &s.range,
	       &s.neighbors, &s.repulsion_neighbors);
	return s;
}

static void try_settings(Start start, const char *const *settings, int count)
{
	Reference reference = reference_create(&start);
	Relaxation plain = relaxation_plain();
	printf("%u photons, %d pixels a side; by K", start.paths, start.pixels);
	for (int i = 0; i < COUNTS; i++)
		printf(" %d", counts[i]);
	printf("\n");
	Row nearest = measure("nearest", start, NULL, &reference), row;
	measure_blur(start, &reference, &nearest);
	row = measure("plain", start, &plain, &reference);
	compare(&row, &nearest);
	for (int i = 0; i < count; i++) {
		char name[64];
		Relaxation relaxation = read_settings(settings[i]);
		snprintf(name, sizeof name, "constrained %s", settings[i]);
		row = measure(name, start, &relaxation, &reference);
		compare(&row, &nearest);
	}
	reference_free(&reference);
}

/* What an option says beyond the first of a wave. */
static void read_option(Start *start, int option)
{
	if (option == 'd')
		*start = (Start){&wave_detailed, start->paths, start->seed, false, start->sets, 0};
	else if (option == 'r' || option == 'q')
		start->random = option == 'r';
	else if (option == 's')
		start->seed = strtoull(optarg, NULL, 10);
	else if (option == 'n')
		start->sets = atoi(optarg);
	else
		start->pixels = atoi(optarg);
}

int main(int argc, char **argv)
{
	static const char *const defaults[] = {"", "4,0", "7,7,3"};
	Start start = {&wave_gentle, 60000, 1, true, 3, 180};
	for (int c; (c = getopt(argc, argv, "drqs:n:p:")) != -1;) {
		if (c == '?')
			return 1;
		read_option(&start, c);
	}
	if (optind < argc)
		start.paths = (uint32_t)atoi(argv[optind++]);
	if (start.pixels <= 0)
		start.pixels = (int)sqrt(start.paths / 1.5);
	if (optind < argc)
		try_settings(start, (const char *const *)argv + optind, argc - optind);
	else
		try_settings(start, defaults, 3);
	return 0;
}
