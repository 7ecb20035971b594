/*
 * Crackle, cells and facets: a random point in every unit cube of space. The points are POV-Ray's: a cube hashes, by the
 * noise's table, to an entry of the Mersenne twister's first numbers (default seed), and that entry and the next two are its
 * point. Measured by trilateration with `crackle form <1, 0, 0>`.
 */
#include <math.h>
#include <stdlib.h>

#include "surface/noise.h"
#include "surface/pattern_classes.h"
#include "surface/pattern_data.h"

static const double cube_epsilon = 1e-10;

static Vec3 cube_of(Vec3 p)
{
	return vec3(floor(p.x + cube_epsilon), floor(p.y + cube_epsilon), floor(p.z + cube_epsilon));
}

static double value_cells(const Pattern *pattern, const SurfacePoint *at)
{
	(void)pattern;
	return noise_cube_random(cube_of(at->p)).x;
}

/* The three nearest points: distances, before the root of the metric, and where the nearest one is. */
typedef struct Nearest { double distance[3]; Vec3 point; } Nearest;

static double metric_distance(Vec3 d, double metric)
{
	if (metric == 2)
		return vec3_length2(d);
	if (metric == 1)
		return fabs(d.x) + fabs(d.y) + fabs(d.z);
	return pow(fabs(d.x), metric) + pow(fabs(d.y), metric) + pow(fabs(d.z), metric);
}

static void nearest_add(Nearest *n, Vec3 p, Vec3 cube, double metric)
{
	Vec3 point = vec3_add(cube, noise_cube_random(cube));
	double distance = metric_distance(vec3_sub(p, point), metric);
	if (distance >= n->distance[2])
		return;
	int place = 2;
	for (; place > 0 && distance < n->distance[place - 1]; place--)
		n->distance[place] = n->distance[place - 1];
	n->distance[place] = distance;
	if (place == 0)
		n->point = point;
}

/* How far, by the metric, the cube with the given offset along each axis is from a place in the middle cube. */
static double cube_distance(Vec3 place, int i, int j, int k, double metric)
{
	Vec3 d = {i > 0 ? i - place.x : i < 0 ? place.x - i - 1 : 0, j > 0 ? j - place.y : j < 0 ? place.y - j - 1 : 0,
	          k > 0 ? k - place.z : k < 0 ? place.z - k - 1 : 0};
	return metric_distance(d, metric);
}

/* Cubes of the outer shell are searched on the faces only: 27 inner ones and 54 of the shell's 98, as POV-Ray does. */
static bool cube_is_searched(int i, int j, int k)
{
	return (abs(i) == 2) + (abs(j) == 2) + (abs(k) == 2) <= 1;
}

static Nearest nearest_find(Vec3 p, double metric)
{
	Nearest n = {{HUGE_VAL, HUGE_VAL, HUGE_VAL}, p};
	Vec3 middle = cube_of(p), place = vec3_sub(p, middle);
	for (int i = -1; i <= 1; i++)
		for (int j = -1; j <= 1; j++)
			for (int k = -1; k <= 1; k++)
				nearest_add(&n, p, vec3_add(middle, vec3(i, j, k)), metric);
	for (int i = -2; i <= 2; i++)
		for (int j = -2; j <= 2; j++)
			for (int k = -2; k <= 2; k++) {
				bool shell = abs(i) == 2 || abs(j) == 2 || abs(k) == 2;
				if (shell && cube_is_searched(i, j, k) && cube_distance(place, i, j, k, metric) < n.distance[2])
					nearest_add(&n, p, vec3_add(middle, vec3(i, j, k)), metric);
			}
	return n;
}

static double unpower(double sum, double metric)
{
	return metric == 2 ? sqrt(sum) : metric == 1 ? sum : pow(sum, 1 / metric);
}

static double value_crackle(const Pattern *pattern, const SurfacePoint *at)
{
	static const CrackleData usual = {{-1, 1, 0}, 2, 0, false};
	const CrackleData *crackle = pattern->data ? pattern->data : &usual;
	Nearest n = nearest_find(at->p, crackle->metric);
	if (crackle->solid)
		return noise_value(n.point, pattern_generator(pattern));
	double d[3], offset = metric_distance(vec3(crackle->offset, 0, 0), crackle->metric);
	for (int i = 0; i < 3; i++)
		d[i] = unpower(n.distance[i] + offset, crackle->metric);
	double v = crackle->form.x * d[0] + crackle->form.y * d[1] + crackle->form.z * d[2];
	return v < 0 ? 0 : v > 1 ? 1 : v;
}

/* Facets bend normals only; POV-Ray refuses them elsewhere. */
static double value_facets(const Pattern *pattern, const SurfacePoint *at)
{
	(void)pattern;
	(void)at;
	return 0;
}

/* With coords, each of crackle's cells is tilted its own way; else the normal itself snaps to the nearest of crackle's points
 * in the space of normals. */
static void bump_facets(const Pattern *pattern, const SurfacePoint *at, double amount, Vec3 *normal)
{
	static const FacetsData usual = {0, 0.1};
	const FacetsData *facets = pattern->data ? pattern->data : &usual;
	(void)amount;
	if (facets->coords == 0) {
		*normal = vec3_normalize(nearest_find(vec3_scale(*normal, 1 / facets->size), 2).point);
		return;
	}
	Vec3 cell = nearest_find(vec3_scale(at->p, 1 / facets->size), 2).point;
	Vec3 tilt = noise_vector(cell, pattern_generator(pattern));
	tilt = vec3_mad(tilt, -vec3_dot(tilt, *normal), *normal);
	*normal = vec3_mad(*normal, facets->coords, tilt);
}

const PatternClass pattern_cells = {"cells", value_cells, 0, NULL, 0};
const PatternClass pattern_crackle = {"crackle", value_crackle, 0, NULL, 0};
const PatternClass pattern_facets = {"facets", value_facets, 0, bump_facets, 0};
