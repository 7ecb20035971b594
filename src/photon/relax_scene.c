/*
 * Relaxation on a scene's surfaces: a moved photon is put back on its object by a short ray along
 * the normal.
 */
#include "photon/relax.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/arena.h"
#include "scene/accel.h"
#include "scene/scene.h"
#include "scene/shade.h"
#include "scene/visit.h"

/*
 * Surfaces may bend away from the tangent plane by as much as the step is long: more than 45
 * degrees.
 */
static const double REACH = 1;

static bool accept_object(void *data, const Ray *ray, const Hit *hit)
{
	(void)ray;
	const RelaxPlace *place = data;
	const Surface *surface = hit->shape->owner;
	return (uint16_t)surface->id == place->object;
}

static bool project_on_scene(void *data, RelaxPlace *place, double step)
{
	const Scene *scene = data;
	double reach = REACH * step + 16 * shade_epsilon(place->position);
	Ray ray = {vec3_mad(place->position, reach, place->normal), vec3_neg(place->normal), 0,
		   2 * reach};
	Hit hit;
	ShadePoint point;
	if (!accel_nearest(scene->accel, &ray, accept_object, place, &hit))
		return false;
	shade_point_init(&point, &ray, &hit);
	if (vec3_dot(point.at.normal, place->normal) < 0.5)
		return false;
	place->position = point.at.world;
	place->normal = point.at.normal;
	return true;
}

/* ---- objects that keep their photons in place ---- */

typedef struct FixedObjects {
	bool *fixed;
	int count;
} FixedObjects;

static void note_surface(void *data, const Surface *surface)
{
	FixedObjects *objects = data;
	int id = (uint16_t)surface->id;
	objects->fixed[id] |= !surface->relaxation;
	objects->count = id + 1 > objects->count ? id + 1 : objects->count;
}

bool photon_relax_scene(PhotonMap *map, const Scene *scene, const volatile int *stop,
			RelaxStatistics *statistics)
{
	FixedObjects objects = {memory_alloc(sizeof(bool) * (UINT16_MAX + 1)), 0};
	memset(objects.fixed, 0, sizeof(bool) * (UINT16_MAX + 1));
	for (int i = 0; i < scene->shape_count; i++)
		shape_visit_surfaces(scene->shapes[i], note_surface, &objects);
	RelaxSurfaces surfaces = {objects.fixed, objects.count, project_on_scene, (void *)scene,
				  stop};
	bool moved = photon_relax(map, &scene->settings.photons.relaxation, &surfaces, statistics);
	free(objects.fixed);
	return moved;
}
