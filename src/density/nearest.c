/*
 * Photon density from the k nearest photons (Jensen 1996, 2001): flux times a kernel as wide as
 * the farthest of them is away, summed. With a radius and no count, or in a progressive pass, the
 * kernel has a fixed width instead and everything in it counts (Hachisuka et al. 2008).
 *
 * What differs: the k-th photon only sets the width, being where every kernel ends, so uniform
 * photons give their density on the average also with the uniform kernel (k - 1 over pi r_k^2 is
 * unbiased; Jensen counts all k). Photons of other surfaces are refused (gather.h) and replaced by
 * farther ones.
 *
 * Where the k nearest lie within a pixel, all photons in what the pixel sees count instead
 * (gather_pixel): picture by picture, k means nothing finer than that.
 *
 * What it does not do: correct for boundaries. Near an edge of the lit region, or of the surface,
 * the disc reaches where no photons can be and the estimate is low, as in the papers.
 */
#include <math.h>

#include "base/arena.h"
#include "density/gather.h"
#include "density/kernel.h"
#include "density/method.h"

typedef struct Nearest {
	int count;      /* 0: all within the radius */
	double radius;  /* the farthest to look; INFINITY when nothing is known */
	EstimatorKernel kernel;
} Nearest;

enum { DEFAULT_COUNT = 50 };

static void *nearest_create(const EstimatorSetup *setup, Diag *diag)
{
	(void)diag;
	const Estimator *e = setup->method;
	Nearest *n = memory_alloc(sizeof *n);
	*n = (Nearest){e->count, e->radius, e->kernel};
	if (setup->radius > 0)
		*n = (Nearest){0, setup->radius, e->kernel};
	if (n->count == 0 && !(n->radius > 0))
		n->count = DEFAULT_COUNT;
	if (!(n->radius > 0))
		n->radius = gather_reach(setup->map, n->count);
	return n;
}

/* ---- fixed radius ---- */

static double weight_in_disc(const void *data, const Photon *photon, double distance2)
{
	(void)photon;
	const Nearest *n = data;
	double scale = 1 / (n->radius * n->radius);
	return scale * kernel_value(n->kernel, scale * distance2);
}

/* ---- k nearest ---- */

static void gather_count(const Nearest *n, const GatherTask *task, GatherResult *result)
{
	Neighbor found[GATHER_ROOM(n->count)];
	GatherSum sum = {.task = task};
	Window pixel = window_around(task->point, 0);
	double radius2;
	int count = gather_nearest(task, n->count, n->radius, found, &radius2);
	if (radius2 < gather_least_radius2(&pixel)) {
		gather_pixel(task, &pixel, result);
		return;
	}
	if (!(radius2 > 0)) /* photons in one point: there is no area to have a density */
		count = 0;
	for (int i = 0; i < count; i++)
		gather_add(&sum, &task->map->photons[found[i].index],
		           kernel_value(n->kernel, found[i].distance2 / radius2) / radius2);
	gather_finish(&sum, sqrt(radius2), result);
}

static void nearest_gather(const void *method, const GatherTask *task, GatherResult *result)
{
	const Nearest *n = method;
	if (n->count == 0)
		gather_within(task, n->radius, weight_in_disc, n, result);
	else
		gather_count(n, task, result);
}

const EstimatorMethod nearest_method = {"nearest", nearest_create, nearest_gather};
