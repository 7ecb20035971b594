/*
 * A path starts with the flux that its first hit settles, and a photon has what that grows to
 * (light/emission.h). At each surface it leaves a photon if the surface collects and the path has
 * been bent or reflected before; then one of the surface's mirrors and passages is chosen by its
 * weight and the path goes on. Flux is divided by the choice's probability, so that its expectation
 * is right; under adc_bailout of what it started with, a path survives by Russian roulette (Arvo &
 * Kirk 1990).
 *
 * Energy: what a surface takes from a path counts as stored where a photon was left and as absorbed
 * elsewhere; what leaves the scene has escaped. The three, in the flux of the first hit, add up to
 * what was emitted onto targets.
 */
#include "photon/path.h"

#include <math.h>

#include "base/random.h"
#include "scene/accel.h"
#include "scene/inside.h"
#include "scene/shade.h"
#include "surface/bsdf.h"

/* Dimensions of a path's Halton point beyond those of its emission. How its first surfaces part the
 * light matters most; later choices are plain random numbers. */
enum {
	PATH_MAX_CROSSINGS = 250,
	DIMENSION_HUE = AIM_EMISSION_DIMENSIONS,
	DIMENSION_EVENT,
	HALTON_EVENTS = AIM_DIMENSIONS - DIMENSION_EVENT
};

typedef struct Path {
	const Scene *scene;
	const Light *light;
	const PhotonAim *aim;
	PhotonBuffer *out;
	Emission emission;
	Sampler sampler;
	Ray ray;
	Rgb flux;
	Rgb tint;            /* by what it has passed through on the way to its target */
	float start;         /* grey flux at the first hit */
	double length;       /* so far */
	double first_length, first_distance; /* at the first hit: of the path, and from the light */
	double hue;          /* 0.5 for white light */
	const PhotonTraceOptions *options;
	uint64_t number;
	bool colored;
	int edges; /* of the path so far; what POV-Ray counts as its levels */
	uint16_t kind;       /* hash of the way so far */
	InsideStack inside;
} Path;

/* Until it has met its target, a path goes straight through what is told to let it. */
static bool passes_by(const Path *path, const Surface *surface)
{
	return path->edges == 0 && surface->photons_pass_through &&
	       surface->id != path->aim->target;
}

static bool accept_on_the_way(void *data, const Ray *ray, const Hit *hit)
{
	(void)ray;
	const Path *path = data;
	const Surface *surface = hit->shape->owner;
	return !passes_by(path, surface) || !surface->no_shadow;
}

static void push_photon(PhotonBuffer *out, const Photon *photon)
{
	if (out->count == out->capacity) {
		out->capacity = out->capacity ? 2 * out->capacity : 1024;
		out->photons = memory_resize(out->photons, sizeof *out->photons * out->capacity);
	}
	out->photons[out->count++] = *photon;
}

/* Flat faces throw sheets of light of their own; each is known by its normal. */
static uint64_t face_of(const ShadePoint *point)
{
	static const double steps = 65536; /* the faces' normals are told apart with */
	if (!hit_is_flat(point->hit, point->at.world))
		return 0;
	Vec3 n = hit_normal(point->hit, point->at.world);
	return random_bits((uint64_t)llrint(steps * n.x), (uint64_t)llrint(steps * n.y),
			   (uint64_t)llrint(steps * n.z));
}

static void store(Path *path, const ShadePoint *point)
{
	Vec3 p = point->at.world, normal = point->at.normal;
	Photon photon = {
		.position = {(float)p.x, (float)p.y, (float)p.z},
		.emitter = {path->emission.coordinates[0], path->emission.coordinates[1],
			    path->emission.coordinates[2]},
		.length = (float)path->length,
		.light = (uint16_t)path->aim->light,
		.object = (uint16_t)point->surface->id,
		.edges = (uint8_t)(path->edges < 255 ? path->edges : 255),
		.path = (uint16_t)random_bits(path->kind, face_of(point), 0),
	};
	double farther = path->first_distance + path->length - path->first_length;
	photon_set_flux(&photon,
			rgb_scale(path->flux, (float)emission_growth(
						      path->light, path->first_distance, farther)));
	photon_set_direction(&photon, vec3_neg(path->ray.direction));
	photon_set_normal(&photon, normal);
	push_photon(path->out, &photon);
	path->out->statistics.stored++;
}

/* ---- at a surface ---- */

static Rgb stack_transmittance(const Shading *shading, const ShadingStack *stack)
{
	Rgb through = rgb_all(stack->weight);
	for (int i = 0; i < stack->count; i++)
		through = rgb_mul(through,
				  rgbft_transmittance(shading->layers[stack->first + i].color));
	return through;
}

/* One of the texture's stacks, by its weight. */
static const ShadingStack *choose_stack(Path *path, const Shading *shading)
{
	if (shading->stack_count == 1)
		return &shading->stacks[0];
	double u = sampler_next(&path->sampler);
	for (int i = 0; i + 1 < shading->stack_count; i++) {
		if (u < shading->stacks[i].weight)
			return &shading->stacks[i];
		u -= shading->stacks[i].weight;
	}
	return &shading->stacks[shading->stack_count - 1];
}

/* A later coordinate of the Halton point that the path started with. */
static double halton_number(const Path *path, int dimension)
{
	return photon_halton(path->aim, path->options, path->number, dimension);
}

/* What the choice at this surface is made by. */
static double event_number(Path *path)
{
	if (path->edges > HALTON_EVENTS)
		return sampler_next(&path->sampler);
	return halton_number(path, DIMENSION_EVENT + path->edges - 1);
}

/* White light that meets glass which bends colours differently becomes light of one hue. */
static void settle_hue(Path *path, const Surface *surface)
{
	if (path->colored || !interior_disperses(surface->interior))
		return;
	path->colored = true;
	path->hue = halton_number(path, DIMENSION_HUE);
	path->flux = rgb_mul(path->flux, interior_hue_color(path->hue));
}

static void make_bsdf(Path *path, const ShadePoint *point, const Shading *shading, Bsdf *bsdf)
{
	const ShadingStack *stack = choose_stack(path, shading);
	BsdfPlace place = {
		.from = vec3_neg(path->ray.direction),
		.geometric = point->at.normal,
		.world = point->at.world,
		.ior = inside_ratio_of_hue(&path->inside, point->surface, path->hue),
		.both_sides = point->surface->double_illuminate,
		.irid_wavelength = path->scene->settings.irid_wavelength,
		.grain = 0.5,
	};
	bsdf_init(bsdf, &shading->layers[stack->first], stack->count, &place);
}

static bool allowed(const Path *path, const Surface *surface, const BsdfEvent *event)
{
	bool reflection = surface->photons_reflection && path->light->photons_reflection;
	bool refraction = surface->photons_refraction && path->light->photons_refraction;
	return event->kind == BSDF_REFLECT ? reflection : refraction;
}

/* Picks one event by its weight and multiplies its weight so that the expectation is all of them;
 * false when none is left. */
static bool choose_event(Path *path, const Surface *surface, const Bsdf *bsdf, BsdfEvent *chosen)
{
	BsdfEvent events[BSDF_MAX_EVENTS];
	int count = bsdf_events(bsdf, TRANSPORT_FLUX, events), kept = 0;
	float total = 0;
	for (int i = 0; i < count; i++) {
		if (!allowed(path, surface, &events[i]))
			continue;
		events[kept] = events[i];
		total += rgb_gray(rgb_mul(events[i].weight, path->flux));
		kept++;
	}
	if (kept == 0 || !(total > 0))
		return false;
	float u = kept > 1 ? (float)event_number(path) * total : 0;
	for (int i = 0; i < kept; i++) {
		float share = rgb_gray(rgb_mul(events[i].weight, path->flux));
		*chosen = events[i];
		if (share > 0 && (u < share || i + 1 == kept)) {
			chosen->weight = rgb_scale(chosen->weight, total / share);
			return true;
		}
		u -= share;
	}
	return false;
}

static bool survives(Path *path)
{
	double bailout = path->scene->settings.photons.adc_bailout;
	if (bailout < 0)
		bailout = path->scene->settings.adc_bailout;
	float left = rgb_gray(path->flux), limit = (float)bailout * path->start;
	if (left >= limit)
		return left > 0;
	if (sampler_next(&path->sampler) * limit >= left)
		return false;
	path->flux = rgb_scale(path->flux, limit / left);
	return true;
}

static int most_levels(const Scene *scene)
{
	int own = scene->settings.photons.max_trace_level;
	return own > 0 ? own : scene->settings.max_trace_level;
}

static void go_on(Path *path, const ShadePoint *point, const BsdfEvent *event)
{
	if (event->kind == BSDF_TRANSMIT && !event->total)
		inside_cross(&path->inside, point->surface);
	path->flux = rgb_mul(path->flux, event->weight);
	path->ray = (Ray){point->at.world, event->to, shade_epsilon(point->at.world), INFINITY};
	int what = event->kind == BSDF_REFLECT ? 1 : event->total ? 2 : 3;
	path->kind = (uint16_t)random_bits(path->kind * 4u + (unsigned)what,
					   (uint64_t)point->surface->id, face_of(point));
}

/* What passes is tinted all the same, as a shadow is, unless the object has none: POV-Ray does so,
 * where its manual says that photons are unaffected. Returns whether light is left. */
static bool pass_by(Path *path, const ShadePoint *point)
{
	Shading shading;
	Rgb through = {0, 0, 0};
	shade_textures(point, &shading);
	for (int i = 0; i < shading.stack_count; i++)
		through = rgb_add(through, stack_transmittance(&shading, &shading.stacks[i]));
	path->tint = rgb_mul(path->tint, through);
	path->ray.origin = point->at.world;
	path->ray.tmin = shade_epsilon(point->at.world);
	return !rgb_is_black(path->tint);
}

/* The first surface a path meets must be its target: others have paths of their own, or stand in
 * the way. */
static bool lands_on_target(Path *path, const ShadePoint *point, double share)
{
	if (point->surface->id != path->aim->target)
		return false;
	path->flux = emission_flux(path->light, &path->emission, point->at.world, share,
				   &path->first_distance);
	path->flux = rgb_mul(path->flux, path->tint);
	path->first_length = path->length;
	path->start = rgb_gray(path->flux);
	path->out->statistics.emitted_flux += path->start;
	return path->start > 0;
}

/* Returns whether the path goes on. */
static bool meet(Path *path, const Hit *hit, double share)
{
	ShadePoint point;
	Shading shading;
	Bsdf bsdf;
	BsdfEvent event;
	PhotonStatistics *statistics = &path->out->statistics;
	shade_point_init(&point, &path->ray, hit);
	path->length += hit->t;
	if (passes_by(path, point.surface))
		return pass_by(path, &point);
	if (path->edges == 0 && !lands_on_target(path, &point, share))
		return false;
	path->edges++;
	float before = rgb_gray(path->flux);
	if (inside_has(&path->inside, point.surface))
		path->flux = rgb_mul(path->flux,
				     shade_attenuation(point.surface->interior, hit->t));
	statistics->absorbed_flux += before - rgb_gray(path->flux);
	shade_textures(&point, &shading);
	settle_hue(path, point.surface);
	make_bsdf(path, &point, &shading, &bsdf);
	before = rgb_gray(path->flux);
	bool stored = path->edges > 1 && point.surface->photons_collect && !bsdf_is_delta(&bsdf) &&
	              photon_light_reaches(path->light, point.surface);
	if (stored)
		store(path, &point);
	bool on = path->edges < most_levels(path->scene) &&
		  choose_event(path, point.surface, &bsdf, &event);
	if (on) {
		go_on(path, &point, &event);
		on = survives(path);
	}
	double taken = before - (on ? rgb_gray(path->flux) : 0);
	*(stored ? &statistics->stored_flux : &statistics->absorbed_flux) += taken;
	return on;
}

void photon_path(const Scene *scene, const PhotonAim *aim, const PhotonTraceOptions *options,
		 uint64_t number, PhotonBuffer *out)
{
	Path path = {
		.scene = scene,
		.light = &scene->lights[aim->light],
		.aim = aim,
		.out = out,
		.hue = 0.5,
		.tint = {1, 1, 1},
		.options = options,
		.number = number,
		.sampler = {random_bits(options->seed, options->pass, 1), aim->first + number, 0},
	};
	path.emission = photon_emission(scene, aim, options, number);
	out->statistics.paths++;
	if (!photon_aim_hits(aim, &path.emission))
		return;
	path.ray = (Ray){path.emission.origin, path.emission.direction, 0, INFINITY};
	inside_copy(&path.inside, &aim->inside);
	for (int i = 0; i < PATH_MAX_CROSSINGS; i++) {
		Hit hit;
		out->statistics.segments++;
		if (!accel_nearest(scene->accel, &path.ray, accept_on_the_way, &path, &hit)) {
			if (path.edges > 0) {
				out->statistics.escaped++;
				out->statistics.escaped_flux += rgb_gray(path.flux);
			}
			return;
		}
		if (!meet(&path, &hit, 1.0 / (double)aim->paths)) {
			out->statistics.absorbed++;
			return;
		}
	}
	out->statistics.absorbed++;
	out->statistics.absorbed_flux += rgb_gray(path.flux);
}
