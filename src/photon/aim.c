#include "photon/aim.h"

#include <math.h>
#include <string.h>

#include "base/random.h"
#include "geom/ray_box.h"
#include "geom/sphere.h"
#include "photon/autostop.h"
#include "scene/shade.h"
#include "scene/visit.h"

/* ---- targets: the primitives of one object together ---- */

typedef struct Target {
	int id;
	Box3 box;
	EmissionAim ball;
	bool tight;     /* the ball is the target */
	double spacing; /* of its photons beside the others' */
	const Surface *surface;
} Target;

static void find_target(void *data, const Surface *surface)
{
	const Surface **target = data;
	if (surface->photons_target)
		*target = surface;
}

static EmissionAim ball_around(Box3 box)
{
	Vec3 center = vec3_scale(vec3_add(box.lo, box.hi), 0.5);
	return (EmissionAim){.center = center, .radius = vec3_distance(center, box.hi), .reach = 1};
}

/* A whole ball is its own bound; its box has at least three times the ball's cross-section. False
 * for all else. */
static bool find_ball(const Shape *shape, EmissionAim *ball)
{
	double scale = 1;
	if (shape->class != &sphere_class || shape->clip_count || shape->bound_count ||
	    (shape->transform && !transform_is_similarity(shape->transform, &scale)))
		return false;
	const Sphere *sphere = shape->data;
	ball->center = shape->transform ? transform_point(shape->transform, sphere->center)
					: sphere->center;
	ball->radius = sphere->radius * scale;
	return true;
}

static Target make_target(const Surface *surface, const Shape *shape)
{
	Target target = {.id = surface->id,
			 .box = shape->box,
			 .ball = ball_around(shape->box),
			 .spacing = surface->photon_spacing,
			 .surface = surface};
	target.tight = find_ball(shape, &target.ball);
	return target;
}

static void widen_target(Target *target, Box3 box)
{
	target->box = box3_union(target->box, box);
	target->ball = ball_around(target->box);
	target->tight = false;
}

static void add_target(Target *targets, int *count, const Surface *surface, const Shape *shape)
{
	int i = 0;
	while (i < *count && targets[i].id != surface->id)
		i++;
	if (i == *count)
		targets[(*count)++] = make_target(surface, shape);
	else
		widen_target(&targets[i], shape->box);
}

static int find_targets(const Scene *scene, Target *targets)
{
	int count = 0;
	for (int i = 0; i < scene->shape_count; i++) {
		const Surface *target = NULL;
		shape_visit_surfaces(scene->shapes[i], find_target, &target);
		if (target && shape_is_bounded(scene->shapes[i]))
			add_target(targets, &count, target, scene->shapes[i]);
	}
	return count;
}

/* ---- aims ---- */

/* A light shoots at a target when both agree on at least one kind of event. */
static bool shoots(const Light *light, const Surface *surface)
{
	return shade_light_reaches(light, surface) && light->photons_share > 0 &&
	       ((light->photons_refraction && surface->photons_refraction) ||
		(light->photons_reflection && surface->photons_reflection));
}

static PhotonAim make_aim(const Scene *scene, int light, const Target *target, uint64_t seed)
{
	PhotonAim aim = {
		.light = light, .target = target->id, .box = target->box, .ball = target->ball,
		.tight = target->tight};
	uint64_t sequence = (uint64_t)light << 32 | (uint32_t)target->id;
	for (uint64_t k = 0; k < AIM_DIMENSIONS; k++)
		aim.shift[k] = random_uniform(seed, sequence, k);
	aim.region = emission_region(&scene->lights[light], &aim.ball);
	aim.ball.reach = photon_autostop(scene, &aim);
	aim.ball.half = vec3_scale(vec3_sub(target->box.hi, target->box.lo), 0.5);
	aim.region = emission_region(&scene->lights[light], &aim.ball);
	inside_start(&aim.inside, scene->accel, scene->lights[light].position);
	return aim;
}

bool photon_aim_hits(const PhotonAim *aim, const Emission *emission)
{
	if (aim->tight)
		return true;
	double range[2] = {0, INFINITY};
	Vec3 o = emission->origin, d = emission->direction;
	ray_slabs_clip(aim->box.lo.x, aim->box.hi.x, o.x, 1 / d.x, range);
	ray_slabs_clip(aim->box.lo.y, aim->box.hi.y, o.y, 1 / d.y, range);
	ray_slabs_clip(aim->box.lo.z, aim->box.hi.z, o.z, 1 / d.z, range);
	return range[0] <= range[1] * (1 + 1e-9) + 1e-12;
}

static const uint64_t HALTON_SKIP = 1; /* index 0 is a corner in every dimension */

/* A coordinate of Halton points from number `index` on, shifted by the seed, in [0, 1). */
static void halton_run(const PhotonAim *aim, uint64_t index, int dimension, int count, double *out)
{
	double shift = aim->shift[dimension];
	random_halton_run(index, dimension, count, out);
#pragma omp simd
	for (int i = 0; i < count; i++) {
		double number = out[i] + shift;
		out[i] = number >= 1 ? number - 1 : number;
	}
}

/* POV-Ray's jitter breaks the pattern of its photons: by at most half of it, as a share of the
 * photons' mean distance, in either direction. number: of the first path. */
static void jitter(const Scene *scene, const PhotonAim *aim, uint64_t number, int count,
		   double *s[2])
{
	double width = scene->settings.photons.jitter / sqrt((double)aim->paths);
	for (int i = 0; i < count; i++, number++) {
		for (uint64_t k = 0; k < 2; k++) {
			double *at = &s[k][i];
			*at += width * (random_uniform((uint64_t)aim->target, number, k) - 0.5);
			*at -= floor(*at);
		}
	}
}

static void start_from_points(const Light *light, const PhotonAim *aim, int count, double *s[4],
			      Emission *out)
{
	for (int i = 0; i < count; i++) {
		double point[2] = {s[2][i], s[3][i]};
		EmissionRegion region = emission_region_from(light, &aim->ball, point);
		emission_run(&region, 1, &s[0][i], &s[1][i], &out[i]);
	}
}

static void start_emissions(const Scene *scene, const PhotonAim *aim, uint64_t index, int count,
			    Emission *out)
{
	double numbers[AIM_EMISSION_DIMENSIONS][PHOTON_STARTS_MAX], *s[AIM_EMISSION_DIMENSIONS];
	const Light *light = &scene->lights[aim->light];
	bool points = !aim->region.plane && emission_takes_point(light);
	for (int k = 0; k < (points ? 4 : 2); k++)
		halton_run(aim, index, k, count, s[k] = numbers[k]);
	if (scene->settings.photons.jitter > 0 && aim->paths > 0)
		jitter(scene, aim, index - HALTON_SKIP, count, s);
	if (points)
		start_from_points(light, aim, count, s, out);
	else
		emission_run(&aim->region, count, s[0], s[1], out);
}

void photon_starts(const Scene *scene, const PhotonAim *aim, const PhotonTraceOptions *options,
		   uint64_t path, int count, PhotonStarts *out)
{
	out->aim = aim;
	out->index = options->pass * aim->paths + path + HALTON_SKIP;
	out->count = count;
	memset(out->filled, 0, sizeof out->filled);
	start_emissions(scene, aim, out->index, count, out->emissions);
}

double photon_start_number(PhotonStarts *starts, int start, int dimension)
{
	double *row = starts->later[dimension];
	if (!starts->filled[dimension])
		halton_run(starts->aim, starts->index, dimension, starts->count, row);
	starts->filled[dimension] = true;
	return row[start];
}

/* The share of paths at the ball that meet the box. */
static double box_share(const Scene *scene, const PhotonAim *aim)
{
	enum { TRIES = 8 * PHOTON_STARTS_MAX };
	Emission emissions[PHOTON_STARTS_MAX];
	int met = 0;
	for (uint64_t first = 0; first < TRIES; first += PHOTON_STARTS_MAX) {
		start_emissions(scene, aim, first + HALTON_SKIP, PHOTON_STARTS_MAX, emissions);
		for (int i = 0; i < PHOTON_STARTS_MAX; i++)
			met += photon_aim_hits(aim, &emissions[i]);
	}
	return fmax(met, 1) / TRIES;
}

/* Of the disc that the ball is seen as, or the rectangle. */
static double aimed_area(const PhotonAim *aim)
{
	double radius = aim->ball.radius * aim->ball.reach;
	return aim->region.rectangle ? aim->region.measure : M_PI * radius * radius;
}

/* Of a target; more would not be done in a lifetime, and their numbers stay whole. */
static const double MOST_PATHS = 1e15;

/*
 * With `spacing` a target gets one path per spacing squared of its disc. With `count` that many
 * paths at the boxes are shared out by the same measure. Lights take `share` times as many.
 */
static void share_out(const Scene *scene, PhotonAims *aims, const double *density,
		      const PhotonTraceOptions *options)
{
	const PhotonSettings *settings = &scene->settings.photons;
	double total = 0, count = options->count ? (double)options->count : settings->count;
	for (int i = 0; i < aims->count; i++)
		total += aimed_area(&aims->aims[i]) * density[i] *
			 box_share(scene, &aims->aims[i]);
	for (int i = 0; i < aims->count; i++) {
		PhotonAim *aim = &aims->aims[i];
		double disc = aimed_area(aim) * density[i];
		double paths = count > 0 ? count * disc / total
					 : disc / (settings->spacing > 0
							   ? settings->spacing * settings->spacing
							   : 1);
		aim->paths = (uint64_t)fmin(fmax(ceil(paths * options->scale), 1), MOST_PATHS);
		aim->first = aims->paths;
		aims->paths += aim->paths;
	}
}

static void find_passable(void *data, const Surface *surface)
{
	bool *passes = data;
	*passes = *passes || surface->photons_pass_through;
}

static bool any_passes(const Scene *scene)
{
	bool passes = false;
	for (int i = 0; i < scene->shape_count && !passes; i++)
		shape_visit_surfaces(scene->shapes[i], find_passable, &passes);
	return passes;
}

PhotonAims photon_aims(const Scene *scene, const PhotonTraceOptions *options, Arena *arena)
{
	Target *targets = ARENA_ARRAY(arena, Target, scene->shape_count + 1);
	int count = find_targets(scene, targets);
	PhotonAims aims = {
		ARENA_ARRAY(arena, PhotonAim, (size_t)count * (size_t)scene->light_count + 1), 0,
		0};
	double *density = ARENA_ARRAY(arena, double, (size_t)count *(size_t)scene->light_count + 1);
	bool passes = any_passes(scene);
	for (int l = 0; l < scene->light_count; l++) {
		for (int t = 0; t < count; t++) {
			if (!shoots(&scene->lights[l], targets[t].surface))
				continue;
			double spacing = targets[t].spacing > 0 ? targets[t].spacing : 1;
			density[aims.count] = scene->lights[l].photons_share / (spacing * spacing);
			aims.aims[aims.count] = make_aim(scene, l, &targets[t], options->seed);
			aims.aims[aims.count++].passes = passes;
		}
	}
	share_out(scene, &aims, density, options);
	return aims;
}
