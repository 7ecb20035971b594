#include "density/gather.h"

#include <math.h>
#include <stdlib.h>

static const double least_cosine = 0.5;

double gather_thickness(double radius)
{
	return 0.25 * radius;
}

bool gather_accepts(const GatherPoint *point, const Photon *photon, double radius)
{
	double cosine = vec3_dot(photon_normal(photon), point->normal);
	if ((point->both_sides ? fabs(cosine) : cosine) < least_cosine)
		return false;
	Vec3 at = vec3_of_floats(photon->position);
	double off = vec3_dot(vec3_sub(at, point->position), point->normal);
	return fabs(off) <= gather_thickness(radius);
}

/* Directions as they are; a plane's coordinates relative to the disc that was sampled. */
static void add_parameter(GatherSum *sum, const Photon *photon)
{
	const PhotonMap *map = sum->task->map;
	double scale = 1;
	if (photon_map_on_plane(map, photon) && map->lights[photon->light].parameter_area > 0)
		scale = sqrt(M_PI / map->lights[photon->light].parameter_area);
	for (int k = 0; k < 3; k++)
		sum->parameter[k] += 0.5 + 0.5 * fmax(-1, fmin(1, scale * photon->emitter[k]));
}

void gather_add(GatherSum *sum, const Photon *photon, double kernel)
{
	gather_add_flux(sum, photon, photon_flux(photon), kernel);
}

void gather_add_flux(GatherSum *sum, const Photon *photon, Rgb flux, double kernel)
{
	sum->photons++;
	sum->edges += photon->edges;
	add_parameter(sum, photon);
	const PhotonMap *map = sum->task->map;
	if (map->constraints)
		sum->constraint += 1 - map->constraints[photon - map->photons].freedom;
	if (kernel == 0)
		return;
	Rgb value = sum->task->bsdf(sum->task->data, photon_direction(photon));
	value = rgb_mul(value, flux);
	sum->radiance[0] += kernel * value.r;
	sum->radiance[1] += kernel * value.g;
	sum->radiance[2] += kernel * value.b;
}

void gather_finish(const GatherSum *sum, double radius, GatherResult *result)
{
	result->photons = sum->photons;
	result->radius = radius;
	if (sum->photons == 0)
		return;
	double share = 1.0 / sum->photons;
	const double *l = sum->radiance, *p = sum->parameter;
	result->radiance = rgb((float)l[0], (float)l[1], (float)l[2]);
	result->parameter = rgb((float)(share * p[0]), (float)(share * p[1]),
				(float)(share * p[2]));
	result->edges = (float)(share * sum->edges);
	result->constraint = (float)(share * sum->constraint);
}

int gather_filter(const GatherTask *task, double radius, Neighbor *found, int count)
{
	int kept = 0;
	for (int i = 0; i < count; i++) {
		if (gather_accepts(task->point, &task->map->photons[found[i].index], radius))
			found[kept++] = found[i];
	}
	return kept;
}

static int compare_distances(const void *a, const void *b)
{
	const Neighbor *x = a, *y = b;
	if (x->distance2 != y->distance2)
		return x->distance2 < y->distance2 ? -1 : 1;
	return (x->index > y->index) - (x->index < y->index);
}

int gather_nearest(const GatherTask *task, int wanted, double reach, Neighbor *found,
                   double *radius2)
{
	Vec3 p = task->point->position;
	NearestQuery query = {
		{(float)p.x, (float)p.y, (float)p.z}, (float)(reach * reach), wanted, NULL};
	for (int try = 1;; try++) {
		int count = photon_tree_nearest(task->map->tree, &query, found);
		bool full = count == query.count;
		*radius2 = full || reach == INFINITY ? photon_tree_farthest(found, count)
						     : reach * reach;
		int kept = gather_filter(task, sqrt(*radius2), found, count);
		if (kept > wanted) {
			qsort(found, (size_t)kept, sizeof *found, compare_distances);
			kept = wanted;
			*radius2 = found[kept - 1].distance2;
		}
		if (kept == wanted || !full || try == GATHER_TRIES)
			return kept;
		query.count *= 2;
	}
}

typedef struct Walk {
	GatherSum sum;
	double radius;
	GatherKernel *kernel;
	const void *data;
} Walk;

static void add_within(void *data, const Neighbor *found, int count)
{
	Walk *walk = data;
	for (int i = 0; i < count; i++) {
		const Photon *photon = &walk->sum.task->map->photons[found[i].index];
		double kernel = walk->kernel(walk->data, photon, found[i].distance2);
		if (kernel >= 0 && gather_accepts(walk->sum.task->point, photon, walk->radius))
			gather_add(&walk->sum, photon, kernel);
	}
}

void gather_within(const GatherTask *task, double radius, GatherKernel *kernel, const void *data,
		   GatherResult *result)
{
	Walk walk = {{.task = task}, radius, kernel, data};
	Vec3 p = task->point->position;
	float center[3] = {(float)p.x, (float)p.y, (float)p.z};
	photon_tree_within(task->map->tree, center, (float)radius, add_within, &walk);
	gather_finish(&walk.sum, radius, result);
}

double gather_least_radius2(const Window *pixel)
{
	return 0.5 * pixel->area;
}

static double weight_in_pixel(const void *data, const Photon *photon, double distance2)
{
	(void)distance2;
	const Window *pixel = data;
	double x, y;
	window_measure(pixel, pixel->at, photon->position, &x, &y);
	return x >= -0.5 && x < 0.5 && y >= -0.5 && y < 0.5 ? 1 / pixel->area : -1;
}

void gather_pixel(const GatherTask *task, const Window *pixel, GatherResult *result)
{
	gather_within(task, vec3_length(pixel->reach), weight_in_pixel, pixel, result);
}

double gather_reach(const PhotonMap *map, int count)
{
	double reach = 8 * map->spacing * sqrt(count / M_PI);
	return reach > 0 ? reach : INFINITY;
}
