/*
 * Shadow rays. An opaque surface ends the question; surfaces that let light through are collected,
 * put in order, and tint what passes: by their textures, by POV-Ray's fake caustics, and by the
 * attenuation of what lies between them, fog included for lights with media_attenuation.
 */
#include "render/atmosphere.h"
#include "render/caustics.h"
#include "scene/shade.h"

enum { SHADOW_MAX_HITS = 128 }; /* more transparent surfaces in one ray count as opaque */

static const float SHADOW_BLACK = 1e-4f;    /* less light than this is none */
static const double CAUSTICS_EXPONENT =
	45; /* of the cosine, for caustics 1; measured from POV-Ray's images */

typedef struct ShadowSearch {
	const Caustics *caustics;
	const Light *light;
	const Scene *fogs; /* the scene, where its fogs weaken this light; else NULL */
	const Shape *blocker;
	int count;
	Hit hits[SHADOW_MAX_HITS];
} ShadowSearch;

static bool visit_shadow(void *data, const Ray *ray, const Hit *hit)
{
	ShadowSearch *search = data;
	const Surface *surface = hit->shape->owner;
	(void)ray;
	if (surface->no_shadow)
		return false;
	bool photons = caustics_replace_shadow(search->caustics, search->light, surface);
	if (!surface->opaque && !photons && search->count < SHADOW_MAX_HITS) {
		search->hits[search->count++] = *hit;
		return false;
	}
	search->blocker = hit->shape->part ? NULL : hit->shape;
	return true;
}

static void sort_hits(Hit *hits, int count)
{
	for (int i = 1; i < count; i++) {
		Hit hit = hits[i];
		int k = i;
		for (; k > 0 && hits[k - 1].t > hit.t; k--)
			hits[k] = hits[k - 1];
		hits[k] = hit;
	}
}

/* What the surface lets through; POV-Ray's fake caustics gather it where it goes straight on. */
static Rgb surface_transmittance(const ShadePoint *point, const Shading *shading)
{
	Rgb sum = shade_transmittance(shading);
	const Interior *interior = point->surface->interior;
	if (interior && interior->caustics != 0 && shading->layer_count) {
		Vec3 normal = shading->layers[shading->layer_count - 1].normal;
		double straight = fabs(vec3_dot(normal, point->at.direction));
		sum = rgb_scale(sum,
				(float)(1 + pow(straight, CAUSTICS_EXPONENT * interior->caustics)));
	}
	return sum;
}

/* What fogs leave from one distance to another: none is in an object that is not hollow. */
static Rgb pass_fogs(const ShadowSearch *search, const Ray *ray, double from, double to,
		     const InsideStack *inside)
{
	if (!search->fogs || !inside_is_open(inside))
		return rgb_all(1);
	Ray part = {.origin = ray_at(ray, from), .direction = ray->direction};
	return atmosphere_transmittance(search->fogs, &part, to - from);
}

/* What is left of white light after the collected surfaces. inside: where the ray starts; changed.
 */
static Rgb pass_surfaces(const ShadowSearch *search, const Ray *ray, InsideStack *inside)
{
	Rgb left = rgb_all(1), air = rgb_all(1); /* lights that shine through fog may be strong */
	double from = 0;
	Shading shading;
	for (int i = 0; i < search->count && rgb_max(left) > SHADOW_BLACK; i++) {
		ShadePoint point;
		shade_point_init(&point, ray, &search->hits[i]);
		shade_textures(&point, &shading);
		air = rgb_mul(air, pass_fogs(search, ray, from, search->hits[i].t, inside));
		left = rgb_mul(left, surface_transmittance(&point, &shading));
		if (inside_has(inside, point.surface))
			left = rgb_mul(left, shade_attenuation(point.surface->interior,
							       search->hits[i].t - from));
		inside_cross(inside, point.surface);
		from = search->hits[i].t;
	}
	air = rgb_mul(air, pass_fogs(search, ray, from, ray->tmax, inside));
	return rgb_max(left) > SHADOW_BLACK ? rgb_mul(left, air) : rgb_all(0);
}

/* Neighbouring points are mostly shadowed by the same shape. */
static bool same_blocker(const Tracer *tracer, const Ray *ray, int light)
{
	const Shape *shape = tracer->blockers[light];
	Hit hit;
	return shape && shape_nearest(shape, ray, &hit) &&
	       ((const Surface *)hit.shape->owner)->opaque;
}

/* A light that is projected through a shape shines only where its rays cross it, and only from
 * there on. */
static bool project_through(const Shape *shape, Ray *ray)
{
	Hit hit;
	if (!shape_nearest(shape, ray, &hit))
		return false;
	ray->tmax = hit.t - shade_epsilon(ray_at(ray, hit.t));
	return true;
}

static const Scene *fogs_for(const Tracer *tracer, const Light *light)
{
	bool weakens = light->media_attenuation && light->media_interaction &&
		       tracer->quality.atmosphere && tracer->scene->fog_count > 0;
	return weakens ? tracer->scene : NULL;
}

Rgb shadow_visibility(Tracer *tracer, const LitPoint *at, int light, Vec3 direction,
		      double distance)
{
	double epsilon = shade_epsilon(at->p);
	Ray ray = {at->p, direction, epsilon, distance - epsilon};
	tracer->statistics.shadow_rays++;
	const Shape *through = tracer->scene->lights[light].projected_through;
	if (through && !project_through(through, &ray))
		return rgb_all(0);
	if (same_blocker(tracer, &ray, light))
		return rgb_all(0);
	ShadowSearch search;
	search.caustics = tracer->caustics;
	search.light = &tracer->scene->lights[light];
	search.fogs = fogs_for(tracer, search.light);
	search.blocker = NULL;
	search.count = 0;
	if (accel_any(tracer->scene->accel, &ray, visit_shadow, &search)) {
		tracer->blockers[light] = search.blocker;
		return rgb_all(0);
	}
	if (!search.count && !search.fogs)
		return rgb_all(1);
	sort_hits(search.hits, search.count);
	InsideStack inside;
	inside_copy(&inside, at->inside);
	return pass_surfaces(&search, &ray, &inside);
}
