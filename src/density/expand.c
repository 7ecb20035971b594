/*
 * How POV-Ray 3.7 gathers, for scenes that say nothing else: the nearest photons up to gather's maximum within a radius, their
 * flux over the disc that holds them; when fewer than gather's minimum are found, the radius is expanded, and the wider
 * search replaces the first unless it is denser by more than expand_thresholds' increase (an edge was crossed) and has at least
 * expand_thresholds' number of photons (manual, section "Adaptive Search Radius").
 */
#include <math.h>

#include "base/arena.h"
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

static const double expansion = 2;

static double automatic_radius(const PhotonMap *map, int most) { return map->spacing * sqrt(most / M_PI); }

static void *expand_create(const EstimatorSetup *setup, Diag *diag)
{
	const PhotonSettings *s = setup->photons;
	if (s->gather_max > ESTIMATOR_MOST_PHOTONS) {
		diag_fail(diag, "photons: gather's maximum %d is over %d", s->gather_max, ESTIMATOR_MOST_PHOTONS);
		return NULL;
	}
	Expand *e = memory_alloc(sizeof *e);
	*e = (Expand){.least = s->gather_min, .most = s->gather_max > 0 ? s->gather_max : 1,
	              .increase = s->expand_increase, .increase_least = s->expand_min, .kernel = setup->method->kernel};
	double factor = s->radii[0].factor > 0 ? s->radii[0].factor : 1;
	e->radius = factor * (s->radii[0].radius > 0 ? s->radii[0].radius : automatic_radius(setup->map, e->most));
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
	NearestQuery query = {{(float)p.x, (float)p.y, (float)p.z}, (float)(radius * radius), e->most, NULL};
	int count = photon_tree_nearest(task->map->tree, &query, s->found);
	s->radius2 = count == e->most ? photon_tree_farthest(s->found, count) : radius * radius;
	s->count = gather_filter(task, sqrt(s->radius2), s->found, count);
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
		bool edge = second.count * first.radius2 > (1 + e->increase) * first.count * second.radius2;
		if (second.count < e->increase_least || !edge)
			best = &second;
	}
	for (int i = 0; i < best->count && best->radius2 > 0; i++)
		gather_add(&sum, &task->map->photons[best->found[i].index],
		           kernel_value(e->kernel, best->found[i].distance2 / best->radius2) / best->radius2);
	gather_finish(&sum, sqrt(best->radius2), result);
}

const EstimatorMethod expand_method = {"POV-Ray's", expand_create, expand_gather};
