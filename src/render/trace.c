/*
 * Whitted's ray tracing as POV-Ray 3.7 does it: at a hit, light of the surface itself and of every
 * source, then one ray for each mirror and one for the passage through, weighted, until weights
 * fall under adc_bailout or max_trace_level is reached. A passage that does not bend does not count
 * as a level.
 */
#include "render/tracer.h"

#include <stdlib.h>
#include <string.h>

#include "render/atmosphere.h"
#include "render/caustics.h"
#include "render/lighting.h"
#include "scene/shade.h"

enum {
	TRACE_MAX_DEPTH = 250
}; /* recursion limit for surfaces in a row that let a ray straight through */

static const Seen SEEN_NOTHING = {.transmit = 0};

static void seen_add(Seen *sum, Seen part, Rgb weight)
{
	sum->color = rgb_add(sum->color, rgb_mul(part.color, weight));
	sum->caustic = rgb_add(sum->caustic, rgb_mul(part.caustic, weight));
	sum->transmit += part.transmit * ((weight.r + weight.g + weight.b) / 3);
}

static float seen_power(float value, float exponent)
{
	return value > 0 ? powf(value, 1 / exponent) : 0;
}

/* A reflection's exponent. The caustic's share of the light stays what it was. */
static void seen_raise(Seen *seen, float exponent)
{
	Rgb before = seen->color;
	seen->color = rgb(seen_power(before.r, exponent), seen_power(before.g, exponent),
			  seen_power(before.b, exponent));
	seen->caustic = rgb(before.r > 0 ? seen->caustic.r * seen->color.r / before.r : 0,
	                    before.g > 0 ? seen->caustic.g * seen->color.g / before.g : 0,
	                    before.b > 0 ? seen->caustic.b * seen->color.b / before.b : 0);
}

/* ---- where a ray goes on ---- */

/* A hit with one of its textures' stacks. */
typedef struct Shaded {
	const ShadePoint *point;
	const ShadingLayer *layers; /* of all stacks */
	const ShadingStack *stack;
} Shaded;

/* The largest share of any colour, taken positive: transmit may be negative. */
static double rgb_peak(Rgb color)
{
	return fmaxf(fabsf(color.r), fmaxf(fabsf(color.g), fabsf(color.b)));
}

static void count_event(RenderStatistics *statistics, const BsdfEvent *event, int level)
{
	if (event->kind == BSDF_REFLECT)
		statistics->reflected_rays++;
	else if (event->bent)
		statistics->refracted_rays++;
	else
		statistics->transmitted_rays++;
	if (level > statistics->deepest)
		statistics->deepest = level;
}

static void next_ray(const PathRay *path, const ShadePoint *point, const BsdfEvent *event,
		     PathRay *next)
{
	inside_copy(&next->inside, &path->inside);
	if (event->kind == BSDF_TRANSMIT && !event->total)
		inside_cross(&next->inside, point->surface);
	next->ray = (Ray){point->at.world, event->to, shade_epsilon(point->at.world), INFINITY};
	next->level = path->level + (event->kind == BSDF_REFLECT || event->bent);
	next->depth = path->depth + 1;
	next->distance = path->distance + point->hit->t;
	next->hue = path->hue;
	next->colored = path->colored;
	next->reflected = path->reflected || event->kind == BSDF_REFLECT || event->total;
}

/* sum: of the stack's light, which its weight is yet to lessen. */
static void follow_event(Tracer *tracer, const PathRay *path, const Shaded *shaded,
			 BsdfEvent *event, Seen *sum)
{
	const ShadePoint *point = shaded->point;
	if (event->kind == BSDF_TRANSMIT && inside_has(&path->inside, point->surface))
		event->weight = rgb_mul(event->weight,
					shade_attenuation(point->surface->interior, point->hit->t));
	PathRay next;
	next.weight = path->weight * shaded->stack->weight * rgb_peak(event->weight);
	if (next.weight < tracer->scene->settings.adc_bailout) {
		tracer->statistics.bailouts++;
		return;
	}
	next_ray(path, point, event, &next);
	count_event(&tracer->statistics, event, next.level);
	Seen seen = trace_ray(tracer, &next, NULL);
	if (event->exponent != 1)
		seen_raise(&seen, event->exponent);
	if (event->kind == BSDF_REFLECT)
		seen.transmit = 0;
	seen_add(sum, seen, event->weight);
}

/* ---- dispersion: a passage for each of the spectrum's samples, which together are white ---- */

enum { FEWEST_HUES = 2, MOST_HUES = 1000 };

static int hue_count(const Interior *interior)
{
	int count = interior->dispersion_samples;
	return count < FEWEST_HUES ? FEWEST_HUES : count > MOST_HUES ? MOST_HUES : count;
}

static Rgb hue_color(int i, int count)
{
	return interior_hue_color((i + 0.5) / count);
}

/* What makes the samples' colours white together. */
static Rgb hue_balance(int count)
{
	Rgb total = {0, 0, 0};
	for (int i = 0; i < count; i++)
		total = rgb_add(total, hue_color(i, count));
	return rgb(1 / total.r, 1 / total.g, 1 / total.b);
}

static void follow_hues(Tracer *tracer, const PathRay *path, const Shaded *shaded,
			const Bsdf *white, Seen *sum)
{
	const Surface *surface = shaded->point->surface;
	int hues = hue_count(surface->interior);
	Rgb balance = hue_balance(hues);
	for (int i = 0; i < hues; i++) {
		PathRay colored = *path;
		BsdfEvent events[BSDF_MAX_EVENTS];
		Bsdf bsdf = *white;
		Rgb share = rgb_mul(hue_color(i, hues), balance);
		colored.colored = true;
		colored.hue = (i + 0.5) / hues;
		bsdf.ior = inside_ratio_of_hue(&path->inside, surface, colored.hue);
		int count = bsdf_events(&bsdf, TRANSPORT_RADIANCE, events);
		for (int k = 0; k < count; k++) {
			if (events[k].kind == BSDF_REFLECT)
				continue;
			events[k].weight = rgb_mul(events[k].weight, share);
			follow_event(tracer, &colored, shaded, &events[k], sum);
		}
	}
}

/* ---- one surface ---- */

/* Low quality: the bottom layer's colour, fully lit, nothing else. */
static Seen flat_color(const Shading *shading)
{
	Seen sum = SEEN_NOTHING;
	for (int i = 0; i < shading->stack_count; i++) {
		const ShadingStack *stack = &shading->stacks[i];
		if (stack->count)
			sum.color = rgb_mad(sum.color, stack->weight,
					    rgbft_rgb(shading->layers[stack->first].color));
	}
	return sum;
}

/* first: where to note the photons, or NULL. */
static void add_caustic(const Tracer *tracer, const LitPoint *lit, const Bsdf *bsdf, Seen *sum,
			FirstHit *first)
{
	GatherResult found;
	caustics_gather(tracer->caustics, lit, bsdf, &found);
	sum->caustic = rgb_add(sum->caustic, found.radiance);
	sum->color = rgb_add(sum->color, found.radiance);
	if (first) {
		first->photons = (float)found.photons;
		first->parameter = found.parameter;
		first->edges = found.edges;
		first->constraint = found.constraint;
	}
}

/* Scenes of POV-Ray's look as there; those of the extension have Fresnel's law everywhere. */
static double mirror_ratio(const Tracer *tracer, const PathRay *path, const Surface *surface)
{
	return tracer->scene->settings.cognac
		       ? inside_ratio_of_hue(&path->inside, surface, path->hue)
		       : inside_mirror_ratio_of_hue(&path->inside, surface, path->hue);
}

static void make_bsdf(Tracer *tracer, const PathRay *path, const Shaded *shaded, Bsdf *bsdf)
{
	const ShadePoint *point = shaded->point;
	const ShadingStack *stack = shaded->stack;
	const ShadingLayer *layers = &shaded->layers[stack->first];
	BsdfPlace place = {
		.from = vec3_neg(path->ray.direction),
		.geometric = point->at.normal,
		.world = point->at.world,
		.ior = inside_ratio_of_hue(&path->inside, point->surface, path->hue),
		.mirror_ior = mirror_ratio(tracer, path, point->surface),
		.both_sides = point->surface->double_illuminate,
		.legacy = tracer->legacy,
		.irid_wavelength = tracer->scene->settings.irid_wavelength,
		.cutoff = tracer->scene->settings.adc_bailout,
	};
	bool grainy = false;
	for (int i = 0; i < stack->count; i++)
		grainy = grainy || layers[i].finish->crand > 0;
	place.grain = grainy ? sampler_next(&tracer->sampler) : 0;
	bsdf_init(bsdf, layers, stack->count, &place);
}

static Seen shade_stack(Tracer *tracer, const PathRay *path, const Shaded *shaded, FirstHit *first)
{
	const ShadePoint *point = shaded->point;
	Bsdf bsdf;
	make_bsdf(tracer, path, shaded, &bsdf);
	double distance = path->distance + point->hit->t;
	double footprint = tracer->sample_width + tracer->sample_spread * distance;
	LitPoint lit = {.p = point->at.world, .surface = point->surface, .inside = &path->inside,
	                .footprint = footprint, .view = path->ray.direction,
	                .across = tracer->sample_across};
	Seen sum = {.color = bsdf_emission(&bsdf, tracer->ambient_light)};
	sum.color = rgb_add(sum.color, lighting_at(tracer, &lit, &bsdf));
	if (tracer->caustics)
		add_caustic(tracer, &lit, &bsdf, &sum, first);
	if (!tracer->quality.scatter)
		return sum;
	BsdfEvent events[BSDF_MAX_EVENTS];
	int count = bsdf_events(&bsdf, TRANSPORT_RADIANCE, events);
	bool parted = !path->colored && interior_disperses(point->surface->interior);
	for (int i = 0; i < count; i++)
		if (!parted || events[i].kind == BSDF_REFLECT)
			follow_event(tracer, path, shaded, &events[i], &sum);
	if (parted)
		follow_hues(tracer, path, shaded, &bsdf, &sum);
	return sum;
}

static void note_first(FirstHit *first, const ShadePoint *point, const Shading *shading,
		       double depth)
{
	first->depth = depth;
	first->normal = point->at.normal;
	first->albedo = flat_color(shading).color;
}

static Seen shade_hit(Tracer *tracer, const PathRay *path, const Hit *hit, FirstHit *first)
{
	ShadePoint point;
	Shading shading;
	shade_point_init(&point, &path->ray, hit);
	shade_textures(&point, &shading);
	if (first)
		note_first(first, &point, &shading, hit->t);
	if (!tracer->quality.lights)
		return flat_color(&shading);
	Seen sum = SEEN_NOTHING;
	for (int i = 0; i < shading.stack_count; i++) {
		const Shaded shaded = {&point, shading.layers, &shading.stacks[i]};
		seen_add(&sum, shade_stack(tracer, path, &shaded, first),
			 rgb_all(shaded.stack->weight));
	}
	return sum;
}

/* ---- a ray ---- */

static bool accept_image(void *data, const Ray *ray, const Hit *hit)
{
	(void)data;
	(void)ray;
	return !((const Surface *)hit->shape->owner)->no_image;
}

static bool accept_reflection(void *data, const Ray *ray, const Hit *hit)
{
	(void)data;
	(void)ray;
	return !((const Surface *)hit->shape->owner)->no_reflection;
}

/* NULL where nothing is hidden: it costs less not to ask. */
static AccelFilter *filter_for(const Scene *scene, const PathRay *path)
{
	if (path->reflected)
		return scene->hides_from_reflection ? accept_reflection : NULL;
	return scene->hides_from_image ? accept_image : NULL;
}

Seen trace_ray(Tracer *tracer, const PathRay *path, FirstHit *first)
{
	if (path->level >= tracer->scene->settings.max_trace_level ||
	    path->depth >= TRACE_MAX_DEPTH) {
		tracer->statistics.bailouts++;
		return SEEN_NOTHING;
	}
	Hit hit;
	const Scene *scene = tracer->scene;
	bool met = accel_nearest(scene->accel, &path->ray, filter_for(scene, path), NULL, &hit);
	Seen seen = met ? shade_hit(tracer, path, &hit, first) : atmosphere_sky(tracer, path);
	if (tracer->quality.atmosphere && inside_is_open(&path->inside))
		seen = atmosphere_apply(tracer, &path->ray, met ? hit.t : INFINITY, seen);
	return seen;
}

/* ---- the eye ---- */

Seen trace_eye(Tracer *tracer, const Ray *ray, FirstHit *first)
{
	if (memcmp(&tracer->eye_place, &ray->origin, sizeof ray->origin) != 0) {
		inside_start(&tracer->eye, tracer->scene->accel, ray->origin);
		tracer->eye_place = ray->origin;
	}
	PathRay path = {.ray = *ray, .weight = 1, .hue = 0.5};
	inside_copy(&path.inside, &tracer->eye);
	tracer->statistics.eye_rays++;
	return trace_ray(tracer, &path, first);
}

/* ---- a thread's worker ---- */

static Quality quality_of(int level, const Scene *scene)
{
	return (Quality){
		.lights = level >= 2,
		.shadows = level >= 4,
		.area_lights = level >= 5,
		.scatter = level >= 8,
		.atmosphere = level >= 9 && scene->fog_count + scene->rainbow_count > 0,
	};
}

/* Radiosity replaces ambient light in scenes since version 3.7. */
static Rgb ambient_light(const Settings *settings)
{
	return settings->has_radiosity && settings->version >= 3.7 ? rgb_all(0)
								   : settings->ambient_light;
}

void tracer_init(Tracer *tracer, const Scene *scene, const RenderOptions *options)
{
	size_t grid = 1;
	for (int i = 0; i < scene->light_count; i++) {
		const Light *light = &scene->lights[i];
		if (light->area && (size_t)light->size1 * (size_t)light->size2 > grid)
			grid = (size_t)light->size1 * (size_t)light->size2;
	}
	*tracer = (Tracer){
		.scene = scene,
		.legacy = scene->settings.version < 3.7,
		.ambient_light = ambient_light(&scene->settings),
		.quality = quality_of(options->quality, scene),
		.alpha = options->alpha,
		.caustics = options->caustics,
		.blockers = memory_alloc(sizeof *tracer->blockers *
					 (size_t)(scene->light_count + 1)),
		.grid = memory_alloc(sizeof *tracer->grid * grid),
		.grid_known = memory_alloc(sizeof *tracer->grid_known * grid),
		.eye_place = {NAN, NAN, NAN},
		.sampler = {.seed = options->seed},
	};
	memset(tracer->blockers, 0, sizeof *tracer->blockers * (size_t)(scene->light_count + 1));
}

void tracer_free(Tracer *tracer)
{
	free(tracer->blockers);
	free(tracer->grid);
	free(tracer->grid_known);
}
