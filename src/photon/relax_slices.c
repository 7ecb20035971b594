#include "photon/relax_slices.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/arena.h"
#include "base/cholesky.h"
#include "base/median.h"
#include "photon/group.h"
#include "photon/hue.h"
#include "photon/relax_set.h"

/* Photons of one kind along a curve through emitter space, with their hues. */
typedef struct Kind {
	const PhotonMap *map;
	const uint32_t *photons;
	const float *hues;
	uint32_t count;
} Kind;

/* ---- how far hues are apart ---- */

/* Some photons near one another where they left the light. */
enum { WINDOW = 128 };

/* Emitter coordinates and hue; then the place. */
enum { A, B, HUE, TERMS, X = TERMS, COLUMNS = X + 3 };

static void fill_row(const Kind *kind, uint32_t i, const Vec3 axes[2], double row[COLUMNS])
{
	const Photon *p = &kind->map->photons[kind->photons[i]];
	Vec3 e = vec3_of_floats(p->emitter);
	row[A] = vec3_dot(e, axes[0]);
	row[B] = vec3_dot(e, axes[1]);
	row[HUE] = (double)kind->hues[i];
	for (int k = 0; k < 3; k++)
		row[X + k] = (double)p->position[k];
}

typedef struct Window {
	double rows[WINDOW][COLUMNS]; /* less their means */
} Window;

static void look(const Kind *kind, uint32_t first, Window *window)
{
	Vec3 axes[2];
	double mean[COLUMNS] = {0};
	const Photon *p = &kind->map->photons[kind->photons[first]];
	relax_emitter_axes(p->emitter, photon_map_on_plane(kind->map, p), axes);
	for (uint32_t i = 0; i < WINDOW; i++) {
		fill_row(kind, first + i, axes, window->rows[i]);
		for (int c = 0; c < COLUMNS; c++)
			mean[c] += window->rows[i][c] / WINDOW;
	}
	for (int i = 0; i < WINDOW; i++)
		for (int c = 0; c < COLUMNS; c++)
			window->rows[i][c] -= mean[c];
}

static double covariance(const Window *window, int a, int b)
{
	double sum = 0;
	for (int i = 0; i < WINDOW; i++)
		sum += window->rows[i][a] * window->rows[i][b];
	return sum / WINDOW;
}

/* x = J e + D h by least squares: what the whole spectrum moves a photon by, per the spacing of
 * photons if all were of one hue. Infinite where the light tells nothing. */
static double smear(const Window *window)
{
	double matrix[TERMS][TERMS], x[3][TERMS];
	for (int a = 0; a < TERMS; a++)
		for (int b = 0; b < TERMS; b++)
			matrix[a][b] = covariance(window, a, b);
	double spread = matrix[A][A] * matrix[B][B] - matrix[A][B] * matrix[A][B];
	if (!cholesky_factor(matrix[0], TERMS, TERMS, 1e-6))
		return INFINITY;
	for (int k = 0; k < 3; k++) {
		for (int a = 0; a < TERMS; a++)
			x[k][a] = covariance(window, a, X + k);
		cholesky_forward(matrix[0], TERMS, TERMS, x[k]);
		cholesky_back(matrix[0], TERMS, TERMS, x[k]);
	}
	Vec3 by_a = vec3(x[0][A], x[1][A], x[2][A]), by_b = vec3(x[0][B], x[1][B], x[2][B]),
	     by_hue = vec3(x[0][HUE], x[1][HUE], x[2][HUE]);
	/* a square of variance v a side has an area of 12 v */
	double area = 12 * sqrt(spread) * vec3_length(vec3_cross(by_a, by_b)) / WINDOW;
	return vec3_length(by_hue) / sqrt(area);
}

static double median_smear(const Kind *kind)
{
	enum { LOOKS = 101 };
	uint32_t windows = kind->count / WINDOW, looks = windows < LOOKS ? windows : LOOKS;
	double all[LOOKS];
	for (uint32_t i = 0; i < looks; i++) {
		Window window;
		look(kind, (uint32_t)((uint64_t)i * windows / looks) * WINDOW, &window);
		all[i] = smear(&window);
	}
	return median(all, (int)looks);
}

/* ---- slices ---- */

enum { MOST = 64, LEAST_PHOTONS = 1000 }; /* in a slice */

/* n slices have photons sqrt(n) times as far apart, and each 1/n of the smear. */
static int choose_slices(const Kind *kind)
{
	double most = fmin(MOST, kind->count / LEAST_PHOTONS);
	double wanted = cbrt(pow(median_smear(kind), 2));
	return (int)fmax(1, fmin(round(wanted), most));
}

static void slice_kind(Kind *kind, uint8_t *slices)
{
	float *hues = memory_alloc(sizeof *hues * kind->count);
	photon_hue_find(kind->map, kind->photons, kind->count, hues);
	kind->hues = hues;
	int count = choose_slices(kind);
	for (uint32_t i = 0; i < kind->count; i++)
		slices[kind->photons[i]] = (uint8_t)(hues[i] * (float)count);
	free(hues);
}

uint8_t *relax_slices(const PhotonMap *map)
{
	size_t count = (size_t)map->count + 1;
	uint8_t *slices = memory_alloc(count);
	uint32_t *photons = memory_alloc(sizeof *photons * count),
		 *kinds = memory_alloc(sizeof *kinds * count);
	memset(slices, 0, count);
	photon_group_kinds(map, photons, kinds);
	for (uint32_t first = 0, size; first < map->count; first += size) {
		size = photon_group_size(kinds + first, sizeof *kinds, map->count - first);
		Kind kind = {map, photons + first, NULL, size};
		if (size >= 2 * LEAST_PHOTONS && photon_hue_parts(map, kind.photons, size))
			slice_kind(&kind, slices);
	}
	free(photons);
	free(kinds);
	return slices;
}
