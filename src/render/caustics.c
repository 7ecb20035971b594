#include "render/caustics.h"

#include <math.h>
#include <stdlib.h>

#include "base/clock.h"
#include "scene/shade.h"
#include "scene/visit.h"

/* The estimator of the objects that name these settings; the scene's own comes first. */
typedef struct Row {
	const Estimator *settings; /* NULL: the scene's */
	DensityEstimator *estimator;
} Row;

struct Caustics {
	PhotonMap *map;
	Row *rows;
	int count;
};

/* ---- what cannot be ---- */

typedef struct Check {
	Diag *diag;
	bool failed;
} Check;

static void check_surface(void *data, const Surface *surface)
{
	Check *check = data;
	const Estimator *estimator = surface->estimator;
	if (check->failed || !estimator || estimator->kind != ESTIMATOR_FOOTPRINT)
		return;
	check->failed = true;
	diag_error(check->diag, estimator->where,
		   "the estimator footprint needs emitter_coordinates");
}

bool caustics_check(const Scene *scene, const Estimator *switched, Diag *diag)
{
	Check check = {diag, false};
	if (scene->settings.photons.emitter_coordinates)
		return true;
	if (switched && switched->kind == ESTIMATOR_FOOTPRINT) {
		diag_fail(diag, "--estimator footprint needs the scene's emitter_coordinates");
		return false;
	}
	for (int i = 0; i < scene->shape_count && !switched; i++)
		shape_visit_surfaces(scene->shapes[i], check_surface, &check);
	return !check.failed;
}

/* ---- creation ---- */

typedef struct Creation {
	Caustics *caustics;
	EstimatorSetup setup;
	Diag *diag;
	bool failed;
} Creation;

static void add_row(Creation *creation, const Estimator *settings, const Estimator *method)
{
	Caustics *caustics = creation->caustics;
	creation->setup.method = method;
	DensityEstimator *estimator = estimator_create(&creation->setup, creation->diag);
	creation->failed = creation->failed || !estimator;
	caustics->rows = memory_resize(caustics->rows, sizeof(Row) * (size_t)(caustics->count + 1));
	caustics->rows[caustics->count++] = (Row){settings, estimator};
}

static const Row *find_row(const Caustics *caustics, const Estimator *settings)
{
	for (int i = 0; i < caustics->count; i++)
		if (caustics->rows[i].settings == settings)
			return &caustics->rows[i];
	return NULL;
}

static void visit_surface(void *data, const Surface *surface)
{
	Creation *creation = data;
	if (!find_row(creation->caustics, surface->estimator))
		add_row(creation, surface->estimator, surface->estimator);
}

Caustics *caustics_create(const Scene *scene, PhotonMap *map, const CausticOptions *options,
			  CausticTimes *times, Diag *diag)
{
	Caustics *caustics = memory_alloc(sizeof *caustics);
	*caustics = (Caustics){.map = map};
	double start = clock_wall();
	photon_map_index(map, 0); /* estimators ask for neighbours in the world */
	double indexed = clock_wall();
	Creation creation = {
		caustics,
		{.photons = &scene->settings.photons, .map = map, .radius = options->radius,
		 .stop = options->stop},
		diag,
		false};
	add_row(&creation, NULL,
		options->estimator ? options->estimator : &scene->settings.photons.estimator);
	for (int i = 0; i < scene->shape_count && !options->estimator; i++)
		shape_visit_surfaces(scene->shapes[i], visit_surface, &creation);
	times->index += indexed - start;
	times->estimators += clock_wall() - indexed;
	if (!creation.failed)
		return caustics;
	caustics_destroy(caustics);
	return NULL;
}

void caustics_destroy(Caustics *caustics)
{
	if (!caustics)
		return;
	for (int i = 0; i < caustics->count; i++)
		estimator_destroy(caustics->rows[i].estimator);
	free(caustics->rows);
	photon_map_destroy(caustics->map);
	free(caustics);
}

/* ---- gathering ---- */

/*
 * A photon's flux per area has the cosine of its arrival already, which the smooth lobes' value
 * counts once more. Highlights do not vanish at grazing angles as the diffuse lobe does, so the
 * cosine is kept from zero.
 */
static Rgb lobes_per_cosine(void *data, Vec3 direction)
{
	static const double least_cosine = 0.01;
	const Bsdf *bsdf = data;
	double cosine = fabs(vec3_dot(direction, bsdf->geometric));
	return rgb_scale(bsdf_eval(bsdf, direction, true), (float)(1 / fmax(cosine, least_cosine)));
}

void caustics_gather(const Caustics *caustics, const LitPoint *at, const Bsdf *bsdf,
		     GatherResult *result)
{
	*result = (GatherResult){.photons = 0};
	if (caustics->map->count == 0 || !at->surface->photons_collect || bsdf_is_delta(bsdf))
		return;
	const Row *row = find_row(caustics, at->surface->estimator);
	GatherPoint point = {
		.position = at->p, .normal = bsdf->geometric, .footprint = at->footprint,
		.view = at->view, .across = at->across,
		.object = (uint16_t)at->surface->id, .both_sides = bsdf_sees_back(bsdf),
	};
	estimator_gather(row ? row->estimator : caustics->rows[0].estimator, &point,
			 lobes_per_cosine, (void *)bsdf, result);
}

bool caustics_replace_shadow(const Caustics *caustics, const Light *light, const Surface *surface)
{
	return caustics && surface->photons_target && surface->photons_refraction &&
	       light->photons_refraction && shade_light_reaches(light, surface);
}
