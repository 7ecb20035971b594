/*
 * A photon's neighbours, those near in the world among those that left the light near where it
 * left, are one piece of one sheet. Where the piece ends, the neighbours lie on one side, and the
 * smaller principal component of their places is less than a disc's. By how much, and whether that
 * is more than chance, says how far the photon may move across the edge.
 *
 * As in Spencer & Jones 2013, but: sheets are also told apart by the object and the way there,
 * since a photon reflected and one refracted may have left the light together; density in
 * parameter space counts the photons that arrived by that way; with fewer neighbours than asked
 * for, mean and deviation of chance are those of the number found; and the constraint is whole
 * from one deviation above the half disc's l2 on, not only there. Photons stand inside the edge
 * that they make, half their distance on the average, so even the outermost of an even pattern
 * see a little more than a half disc: by eqs. 2 and 7 alone 50 neighbours let them go by a fifth
 * of their distance in 14 iterations. With many neighbours this is eq. 7 again.
 */
#include "photon/features.h"

#include <math.h>

#include "base/arena.h"
#include "photon/relax_forest.h"
#include "photon/relax_gradient.h"

FeatureAxes feature_axes(const double (*points)[2], int count, double radius)
{
	double x = 0, y = 0, xx = 0, xy = 0, yy = 0;
	for (int i = 0; i < count; i++) {
		x += points[i][0];
		y += points[i][1];
		xx += points[i][0] * points[i][0];
		xy += points[i][0] * points[i][1];
		yy += points[i][1] * points[i][1];
	}
	if (count == 0 || !(radius > 0))
		return (FeatureAxes){0, 0, {1, 0}};
	double per = 1 / (count * radius * radius), mean = 1 / (count * radius);
	x *= mean;
	y *= mean;
	xx = xx * per - x * x;
	xy = xy * per - x * y;
	yy = yy * per - y * y;
	double middle = 0.5 * (xx + yy), half = hypot(0.5 * (xx - yy), xy),
	       angle = 0.5 * atan2(2 * xy, xx - yy);
	return (FeatureAxes){middle + half, fmax(middle - half, 0), {cos(angle), sin(angle)}};
}

double feature_freedom(double l2, int count)
{
	const double disc = 0.25, half_disc = 0.25 - 16 / (9 * M_PI * M_PI);
	if (count < 1 || isnan(l2))
		return 1;
	double mean = disc - 0.2809 / sqrt(count),
	       deviation = 0.188 / sqrt(count); /* eqs. 5 and 4 */
	double edge = fmin(half_disc + deviation, 0.5 * (half_disc + disc));
	if (l2 <= edge)
		return 0;
	double migration = sqrt(disc - fmin(l2, disc)) / sqrt(disc - edge); /* M, SJ13 eq. 2 */
	double likelihood = 0.5 * (1 - erf((l2 - mean) / (M_SQRT2 * deviation))); /* Phi, eq. 6 */
	return fmin(fmax(1 - migration * likelihood, 0), 1);
}

/* ---- density in parameter space ---- */

/*
 * Neighbours that the density around one photon is taken from: its error, an eighth, is half as
 * much in the range.
 */
enum { DENSITY_NEIGHBORS = 16 };

typedef struct RangeJob {
	const RelaxForest *forest;
	double factor; /* beta^2 Kc */
} RangeJob;

static void range_run(RelaxSet *set, uint32_t first, uint32_t end, void *data)
{
	const RangeJob *job = data;
	Neighbor near[DENSITY_NEIGHBORS + 1 + 8 * TREE_SLACK];
	for (uint32_t i = first; i < end; i++) {
		RelaxPoint *point = &set->points[i];
		int count = relax_forest_nearest(job->forest, i, DENSITY_NEIGHBORS + 1, near);
		/* eq. 1 with rho = n / (pi r^2) */
		if (count == DENSITY_NEIGHBORS + 1)
			point->range2 = (float)(job->factor * photon_tree_farthest(near, count) /
						DENSITY_NEIGHBORS);
	}
}

static void find_ranges(RelaxSet *set, const Relaxation *settings)
{
	RelaxForest *forest = relax_forest_create(set, RELAX_EMITTER);
	relax_forest_grow(forest);
	RangeJob job = {forest, settings->range * settings->range * settings->neighbors};
	relax_set_each(set, range_run, &job);
	relax_forest_destroy(forest);
}

/* ---- constraints ---- */

typedef struct FeatureJob {
	const RelaxForest *forest;
	int count; /* Kc */
	bool gradient; /* is asked for */
	double pushing; /* Kf / Kc */
	RelaxPattern pattern;
} FeatureJob;

/* The neighbours in the photon's tangent plane. */
static int flatten(const RelaxSet *set, uint32_t i, Vec3 u, Vec3 v, const Neighbor *near, int found,
                   double (*flat)[2])
{
	const float *p = set->points[i].position;
	int count = 0;
	for (int j = 0; j < found; j++) {
		if (near[j].index == i)
			continue;
		const float *q = set->points[near[j].index].position;
		Vec3 d = vec3((double)q[0] - p[0], (double)q[1] - p[1], (double)q[2] - p[2]);
		flat[count][0] = vec3_dot(d, u);
		flat[count++][1] = vec3_dot(d, v);
	}
	return count;
}

static void find_basis(RelaxSet *set, const FeatureJob *job, uint32_t i, const Neighbor *near,
		       int found)
{
	RelaxBasis *basis = &set->bases[i];
	double flat[found + 1][2], radius = sqrt(photon_tree_farthest(near, found));
	RelaxPiece piece = {set, i, near, found, {{0, 0, 0}}, radius, job->pushing};
	Vec3 *axes = piece.axes, normal = vec3_normalize(vec3_of_floats(set->points[i].normal));
	vec3_frame(normal, &axes[0], &axes[1]);
	int count = flatten(set, i, axes[0], axes[1], near, found, flat);
	FeatureAxes features = feature_axes((const double (*)[2])flat, count, radius);
	Vec3 along = vec3_add(vec3_scale(axes[0], features.u[0]),
			      vec3_scale(axes[1], features.u[1]));
	vec3_to_floats(along, basis->u);
	vec3_to_floats(vec3_cross(normal, along), basis->v);
	basis->v_length = (float)feature_freedom(features.l2, radius > 0 ? count : 0);
	vec3_to_floats(job->gradient ? relax_gradient(&piece, &job->pattern) : vec3(0, 0, 0),
		       basis->gradient);
}

static void basis_run(RelaxSet *set, uint32_t first, uint32_t end, void *data)
{
	const FeatureJob *job = data;
	Neighbor near[job->count + 1 + 8 * TREE_SLACK];
	for (uint32_t i = first; i < end; i++) {
		int found = relax_forest_nearest(job->forest, i, job->count + 1, near);
		find_basis(set, job, i, near, found);
	}
}

void features_detect(RelaxSet *set, const Relaxation *settings)
{
	find_ranges(set, settings);
	set->bases = memory_alloc(sizeof *set->bases * ((size_t)set->count + 1));
	RelaxForest *forest = relax_forest_create(set, RELAX_PARAMETER);
	relax_forest_grow(forest);
	double pushing = (double)settings->repulsion_neighbors / settings->neighbors;
	FeatureJob job = {forest, settings->neighbors, settings->gradient, pushing,
			  relax_pattern()};
	relax_set_each(set, basis_run, &job);
	relax_forest_destroy(forest);
}
