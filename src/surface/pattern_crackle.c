/*
 * Crackle, cells and facets: a random point in every unit cube of space. The points are POV-Ray's:
 * a cube hashes, by the noise's table, to an entry of the Mersenne twister's first numbers (default
 * seed), and that entry and the next two are its point. Measured by trilateration with `crackle
 * form <1, 0, 0>`.
 */
#include <math.h>

#include "surface/noise.h"
#include "surface/pattern_classes.h"
#include "surface/pattern_data.h"

static const double cube_epsilon = 1e-10;

static Vec3 cube_of(Vec3 p)
{
	return vec3(floor(p.x + cube_epsilon), floor(p.y + cube_epsilon),
		    floor(p.z + cube_epsilon));
}

static double value_cells(const Pattern *pattern, const SurfacePoint *at)
{
	(void)pattern;
	return noise_cube_random(cube_of(at->p)).x;
}

/* The nearest points: distances, before the root of the metric, and where the first one is. Only
 * `wanted` are needed. */
typedef struct Nearest {
	double distance[3];
	Vec3 point;
	double metric;
	int wanted;
} Nearest;

static double metric_power(double d, double metric)
{
	return metric == 2 ? d * d : metric == 1 ? fabs(d) : pow(fabs(d), metric);
}

static double metric_distance(Vec3 d, double metric)
{
	return metric_power(d.x, metric) + metric_power(d.y, metric) + metric_power(d.z, metric);
}

static void nearest_add(Nearest *n, Vec3 p, Vec3 cube)
{
	Vec3 point = vec3_add(cube, noise_cube_random(cube));
	double distance = metric_distance(vec3_sub(p, point), n->metric);
	if (distance >= n->distance[2])
		return;
	int place = 2;
	for (; place > 0 && distance < n->distance[place - 1]; place--)
		n->distance[place] = n->distance[place - 1];
	n->distance[place] = distance;
	if (place == 0)
		n->point = point;
}

/* The cubes' offsets along an axis, nearest first, and how far at least a place in the middle cube
 * is from each by the metric. */
static const int cube_offsets[5] = {0, -1, 1, -2, 2};

static void axis_gaps(double place, double metric, double gaps[5])
{
	for (int n = 0; n < 5; n++) {
		int i = cube_offsets[n];
		gaps[n] = metric_power(i > 0 ? i - place : i < 0 ? place - i - 1 : 0, metric);
	}
}

/* The row of five cubes along z, as far as they can hold a nearer point. In the shell round the
 * inner 27 POV-Ray searches the faces only, not their edges. */
static void search_row(Nearest *n, Vec3 p, Vec3 row, const double gaps[5], double gap, bool shell)
{
	for (int k = 0; k < (shell ? 3 : 5); k++)
		if (gap + gaps[k] < n->distance[n->wanted - 1])
			nearest_add(n, p, vec3(row.x, row.y, row.z + cube_offsets[k]));
}

static Nearest nearest_find(Vec3 p, double metric, int wanted)
{
	Nearest n = {{HUGE_VAL, HUGE_VAL, HUGE_VAL}, p, metric, wanted};
	Vec3 middle = cube_of(p);
	double x[5], y[5], z[5];
	axis_gaps(p.x - middle.x, metric, x);
	axis_gaps(p.y - middle.y, metric, y);
	axis_gaps(p.z - middle.z, metric, z);
	for (int i = 0; i < 5; i++)
		for (int j = 0; j < 5; j++) {
			bool shell = i > 2 || j > 2, edge = i > 2 && j > 2;
			Vec3 row = {middle.x + cube_offsets[i], middle.y + cube_offsets[j],
				    middle.z};
			if (!edge && x[i] + y[j] < n.distance[wanted - 1])
				search_row(&n, p, row, z, x[i] + y[j], shell);
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
	Nearest n = nearest_find(at->p, crackle->metric, crackle->form.z != 0 ? 3 : 2);
	if (crackle->solid)
		return noise_value(n.point, pattern_generator(pattern));
	double d[3] = {0, 0, 0},
	       offset = metric_distance(vec3(crackle->offset, 0, 0), crackle->metric);
	for (int i = 0; i < n.wanted; i++)
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

/* With coords, each of crackle's cells is tilted its own way; else the normal itself snaps to the
 * nearest of crackle's points in the space of normals. */
static void bump_facets(const Pattern *pattern, const SurfacePoint *at, double amount, Vec3 *normal)
{
	static const FacetsData usual = {0, 0.1};
	const FacetsData *facets = pattern->data ? pattern->data : &usual;
	(void)amount;
	if (facets->coords == 0) {
		*normal = vec3_normalize(
			nearest_find(vec3_scale(*normal, 1 / facets->size), 2, 1).point);
		return;
	}
	Vec3 cell = nearest_find(vec3_scale(at->p, 1 / facets->size), 2, 1).point;
	Vec3 tilt = noise_vector(cell, pattern_generator(pattern));
	tilt = vec3_mad(tilt, -vec3_dot(tilt, *normal), *normal);
	*normal = vec3_mad(*normal, facets->coords, tilt);
}

const PatternClass pattern_cells = {"cells", value_cells, 0, NULL, 0};
const PatternClass pattern_crackle = {"crackle", value_crackle, 0, NULL, 0};
const PatternClass pattern_facets = {"facets", value_facets, 0, bump_facets, 0};
