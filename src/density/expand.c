/*
 * How POV-Ray 3.7 gathers, for scenes that say nothing else (manual, section "Adaptive Search
 * Radius"): the nearest photons up to gather's maximum within a radius, their flux over the disc
 * that holds them, or over the whole disc when they are fewer. With fewer than gather's minimum
 * the search is repeated with three times the radius (measured: discs of single photons, and the
 * steps between densities of n and n + 1 photons), and replaces the first unless it is denser by
 * more than expand_thresholds' increase, as beyond an edge, and has expand_thresholds' number of
 * photons.
 *
 * Without a radius POV-Ray takes one from statistics of the photons. Measured by the light's reach
 * beyond the edge of a uniform patch, it is 1.2 to 3.4 times the distance to a photon's gather
 * maximum-th neighbour, falling with the number of photons; here it is twice the median, which
 * photons that went astray to the horizon do not widen.
 *
 * What differs: photons of other surfaces are refused (gather.h).
 */
#include <math.h>

#include "base/arena.h"
#include "base/median.h"
#include "density/gather.h"
#include "density/kernel.h"
#include "density/method.h"

typedef struct Expand {
	int least, most;       /* gather */
	double radius;         /* of the first search */
	double increase;       /* expand_thresholds */
	int increase_least;
	EstimatorKernel kernel;
} Expand;

static const double expansion = 3, automatic_factor = 2;

/* From the median distance to a photon's most-th neighbour, over some of the photons. */
static double automatic_radius(const PhotonMap *map, int most)
{
	enum { SAMPLES = 500 };
	uint32_t samples = map->count < SAMPLES ? map->count : SAMPLES;
	Neighbor found[most + 8 * TREE_SLACK];
	double distances[SAMPLES];
	for (uint32_t i = 0; i < samples; i++) {
		const float *p = map->photons[(uint64_t)i * map->count / samples].position;
		NearestQuery query = {{p[0], p[1], p[2]}, INFINITY, most, NULL};
		int count = photon_tree_nearest(map->tree, &query, found);
		distances[i] = sqrtf(photon_tree_farthest(found, count) * (float)most /
				     (float)count);
	}
	return samples ? automatic_factor * median(distances, (int)samples) : 0;
}

static void *expand_create(const EstimatorSetup *setup, Diag *diag)
{
	const PhotonSettings *s = setup->photons;
	(void)diag;
	Expand *e = memory_alloc(sizeof *e);
	*e = (Expand){.least = s->gather_min, .most = s->gather_max > 0 ? s->gather_max : 1,
	              .increase = s->expand_increase, .increase_least = s->expand_min,
	              .kernel = setup->method->kernel};
	double factor = s->radii[0].factor > 0 ? s->radii[0].factor : 1;
	double radius = s->radii[0].radius;
	e->radius = factor * (radius > 0 ? radius : automatic_radius(setup->map, e->most));
	return e;
}

/* One search: the accepted photons in a disc that just holds them. */
typedef struct Search {
	Neighbor *found;
	int count;
	double radius2;
} Search;

static void search(const Expand *e, const GatherTask *task, double radius, Search *s)
{
	Vec3 p = task->point->position;
	NearestQuery query = {
		.center = {(float)p.x, (float)p.y, (float)p.z},
		.max_distance2 = (float)(radius * radius), .count = e->most,
	};
	int count = photon_tree_nearest(task->map->tree, &query, s->found);
	s->radius2 = count == e->most ? photon_tree_farthest(s->found, count) : radius * radius;
	s->count = gather_filter(task, sqrt(s->radius2), s->found, count);
}

/* The farthest photon, at the disc's very edge, counts as well. */
static double kernel_in_disc(const Expand *e, double t2)
{
	return kernel_value(e->kernel, fmin(t2, 1 - 1e-9));
}

static void expand_gather(const void *method, const GatherTask *task, GatherResult *result)
{
	const Expand *e = method;
	Neighbor near[e->most + 8 * TREE_SLACK], far[e->most + 8 * TREE_SLACK];
	Search first = {near, 0, 0}, second = {far, 0, 0}, *best = &first;
	GatherSum sum = {.task = task};
	search(e, task, e->radius, &first);
	if (first.count < e->least) {
		search(e, task, expansion * e->radius, &second);
		bool edge = second.count * first.radius2 >
			    (1 + e->increase) * first.count * second.radius2;
		if (second.count < e->increase_least || !edge)
			best = &second;
	}
	for (int i = 0; i < best->count && best->radius2 > 0; i++)
		gather_add(&sum, &task->map->photons[best->found[i].index],
			   kernel_in_disc(e, best->found[i].distance2 / best->radius2) /
				   best->radius2);
	gather_finish(&sum, sqrt(best->radius2), result);
}

const EstimatorMethod expand_method = {"POV-Ray's", expand_create, expand_gather};
