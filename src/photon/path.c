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
#include <string.h>

#include "base/random.h"
#include "geom/plain.h"
#include "scene/accel.h"
#include "scene/inside.h"
#include "scene/shade.h"
#include "surface/bsdf_layer.h"

/* Dimensions of a path's Halton point beyond those of its emission. How its first surfaces part the
 * light matters most; later choices are plain random numbers. */
enum {
	PATH_MAX_CROSSINGS = 250,
	DIMENSION_HUE = AIM_EMISSION_DIMENSIONS,
	DIMENSION_EVENT,
	HALTON_EVENTS = AIM_DIMENSIONS - DIMENSION_EVENT
};

/* What is the same for all paths of a run, and what each begins anew. */
typedef struct Path {
	const Scene *scene;
	const Light *light;
	const PhotonAim *aim;
	PhotonBuffer *out;
	double share;        /* of the aim's region that a path stands for */
	float bailout;
	int most_levels;

	PhotonStarts starts; /* of this path and its neighbours */
	int at;              /* this path's place among the starts */
	Sampler sampler;
	Ray ray;
	Rgb flux;
	Rgb tint;            /* by what it has passed through on the way to its target */
	float gray, start;   /* grey flux, and what it was at the first hit */
	double length;       /* so far */
	double first_length, first_distance; /* at the first hit: of the path, and from the light */
	double hue;          /* 0.5 for white light */
	bool colored;
	int edges; /* of the path so far; what POV-Ray counts as its levels */
	uint16_t kind;       /* hash of the way so far */
	InsideStack inside;
} Path;

/* Where a path meets a surface. */
typedef struct Meeting {
	const Hit *hit;
	const Surface *surface;
	Vec3 place, normal; /* unit, on the side that the path comes from */
	int inside;         /* the surface's place among those that the path is in, or -1 */
} Meeting;

static const Emission *emission_of(const Path *path)
{
	return &path->starts.emissions[path->at];
}

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

static Photon *new_photon(PhotonBuffer *out)
{
	if (out->count == out->capacity) {
		out->capacity = out->capacity ? 2 * out->capacity : 1024;
		out->photons = memory_resize(out->photons, sizeof *out->photons * out->capacity);
	}
	return &out->photons[out->count++];
}

/*
 * Flat faces throw sheets of light of their own, and catch them; each is known by its normal on the
 * side that the light comes from and by how far it is along that from the middle of what the light
 * was aimed at, told apart to a thousandth of the aim's radius. Steps' ends are where no scene has
 * faces on purpose, so that rounding does not part a face.
 */
static uint64_t face_of(const Path *path, const Meeting *at)
{
	static const double steps = 65536; /* the faces' normals are told apart with */
	static const double distances = 1024, odd = 0.3819660113;
	if (!hit_is_flat(at->hit, at->place, at->normal))
		return 0;
	const EmissionAim *ball = &path->aim->ball;
	double distance = vec3_dot(at->normal, vec3_sub(at->place, ball->center)) / ball->radius;
	uint64_t normal = (uint64_t)llrint(steps * at->normal.x) +
			  ((uint64_t)llrint(steps * at->normal.y) << 20) +
			  ((uint64_t)llrint(steps * at->normal.z) << 40) + 1;
	double place = floor(distances * distance + odd);
	/* beside targets without a size there is no telling */
	return random_mix(normal) ^ (fabs(place) < 1e15 ? (uint64_t)(int64_t)place : 0);
}

/* The hash of a way that ends with an event at an object's face. */
static uint16_t way_of(unsigned before, int object, uint64_t face)
{
	return (uint16_t)random_mix(face * 0x9e3779b97f4a7c15u ^
				    ((uint64_t)before << 32 | (uint32_t)object));
}

static void store(Path *path, const Meeting *at)
{
	const float *emitter = emission_of(path)->coordinates;
	double farther = path->first_distance + path->length - path->first_length;
	double growth = emission_growth(path->light, path->first_distance, farther);
	Vec3 from = vec3_neg(path->ray.direction);
	Photon *photon = new_photon(path->out);
	vec3_to_floats(at->place, photon->position);
	memcpy(photon->emitter, emitter, sizeof photon->emitter);
	photon->length = (float)path->length;
	photon->light = (uint16_t)path->aim->light;
	photon->object = (uint16_t)at->surface->id;
	photon->edges = (uint8_t)(path->edges < 255 ? path->edges : 255);
	photon->path = way_of(path->kind, 0, face_of(path, at));
	photon_set_arrival(photon, rgb_scale(path->flux, (float)growth), &from, &at->normal);
	path->out->statistics.stored++;
}

/* ---- at a surface ---- */

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
static double halton_number(Path *path, int dimension)
{
	return photon_start_number(&path->starts, path->at, dimension);
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
	path->gray = rgb_gray(path->flux);
}

/* The mirrors and passages of a surface, and whether these are all that it has. */
typedef struct Ways {
	BsdfEvent events[BSDF_MAX_EVENTS];
	int count;
	bool delta;
	bool directed;   /* the events know where they go; if not, the refraction does */
	Refraction bend;
} Ways;

static void find_uniform_ways(const Path *path, const Meeting *at, double ior, Ways *ways)
{
	const Texture *texture = at->surface->texture;
	double cosine = real_min(-vec3_dot(path->ray.direction, at->normal), 1);
	ways->bend = refraction_of(cosine, ior);
	ways->delta = bsdf_finish_is_delta(texture->finish);
	ways->count = 2;
	bsdf_layer_events(texture->finish, &texture->pigment->color, &ways->bend, ways->events);
}

static void find_textured_ways(Path *path, const Meeting *at, double ior, Ways *ways)
{
	ShadePoint point;
	Shading shading;
	Bsdf bsdf;
	shade_point_init(&point, &path->ray, at->hit);
	shade_textures(&point, &shading);
	const ShadingStack *stack = choose_stack(path, &shading);
	BsdfPlace place = {
		.from = vec3_neg(path->ray.direction),
		.geometric = at->normal,
		.world = at->place,
		.ior = ior,
		.mirror_ior = ior,
		.both_sides = at->surface->double_illuminate,
		.irid_wavelength = path->scene->settings.irid_wavelength,
		.grain = 0.5,
	};
	bsdf_init(&bsdf, &shading.layers[stack->first], stack->count, &place);
	ways->delta = bsdf_is_delta(&bsdf);
	ways->count = bsdf_events(&bsdf, TRANSPORT_FLUX, ways->events);
}

static void find_ways(Path *path, const Meeting *at, Ways *ways)
{
	double ior = inside_ratio_at(&path->inside, at->inside, at->surface, path->hue);
	ways->directed = !at->surface->uniform;
	if (ways->directed)
		find_textured_ways(path, at, ior, ways);
	else
		find_uniform_ways(path, at, ior, ways);
}

static bool allowed(const Path *path, const Surface *surface, const BsdfEvent *event)
{
	return event->kind == BSDF_REFLECT
		       ? surface->photons_reflection && path->light->photons_reflection
		       : surface->photons_refraction && path->light->photons_refraction;
}

/* Picks one event by its weight and multiplies its weight so that the expectation is all of them:
 * then it has the grey flux of all. NULL when none is left. */
static BsdfEvent *choose_event(Path *path, const Surface *surface, Ways *ways)
{
	float shares[BSDF_MAX_EVENTS], total = 0;
	BsdfEvent *events = ways->events;
	Rgb flux = rgb_gray_parts(path->flux);
	int last = -1, choices = 0;
	for (int i = 0; i < ways->count; i++) {
		Rgb weight = events[i].weight;
		float share = weight.r * flux.r + weight.g * flux.g + weight.b * flux.b;
		if (!(share > 0) || !allowed(path, surface, &events[i]))
			share = 0;
		shares[i] = share;
		total += share;
		choices += share > 0;
		last = share > 0 ? i : last;
	}
	path->gray = total;
	if (choices < 2)
		return choices ? &events[last] : NULL;
	float u = (float)event_number(path) * total;
	int at = 0;
	while (at < last && u >= shares[at])
		u -= shares[at++];
	events[at].weight = rgb_scale(events[at].weight, total / shares[at]);
	return &events[at];
}

static bool survives(Path *path)
{
	float left = path->gray, limit = path->bailout * path->start;
	if (left >= limit)
		return left > 0;
	if (sampler_next(&path->sampler) * limit >= left)
		return false;
	path->flux = rgb_scale(path->flux, limit / left);
	path->gray = limit;
	return true;
}

/* How far from its start a path meets surfaces again. Shapes of which single crossings are exact
 * need so little that none slips through an edge nearby; light that comes from afar is placed less
 * finely. */
static double start_of(const Meeting *at)
{
	double usual = shade_epsilon(at->place);
	if (!at->hit->shape->class->quick)
		return usual;
	Vec3 p = at->place;
	double scale = real_max(fabs(p.x), real_max(fabs(p.y), fabs(p.z)));
	return real_min(usual, 1e-8 * scale + 1e-12 * at->hit->t);
}

static void go_on(Path *path, const Meeting *at, const Ways *ways, const BsdfEvent *event)
{
	Vec3 to = ways->directed ? event->to
				 : bsdf_layer_direction(event, &ways->bend, path->ray.direction,
							at->normal);
	if (event->kind == BSDF_TRANSMIT && !event->total)
		inside_cross_at(&path->inside, at->inside, at->surface);
	path->flux = rgb_mul(path->flux, event->weight);
	path->ray = (Ray){at->place, to, start_of(at), INFINITY};
	int what = event->kind == BSDF_REFLECT ? 1 : event->total ? 2 : 3;
	path->kind = way_of(path->kind * 4u + (unsigned)what, at->surface->id, face_of(path, at));
}

/* What passes is tinted all the same, as a shadow is, unless the object has none: POV-Ray does so,
 * where its manual says that photons are unaffected. Returns whether light is left. */
static bool pass_by(Path *path, const Hit *hit)
{
	ShadePoint point;
	Shading shading;
	shade_point_init(&point, &path->ray, hit);
	shade_textures(&point, &shading);
	path->tint = rgb_mul(path->tint, shade_transmittance(&shading));
	path->ray.origin = point.at.world;
	path->ray.tmin = shade_epsilon(point.at.world);
	return !rgb_is_black(path->tint);
}

/* The first surface a path meets must be its target: others have paths of their own, or stand in
 * the way. */
static bool lands_on_target(Path *path, const Surface *surface, Vec3 p)
{
	if (surface->id != path->aim->target)
		return false;
	path->flux = emission_flux(path->light, emission_of(path), p, path->share,
				   &path->first_distance);
	path->flux = rgb_mul(path->flux, path->tint);
	path->first_length = path->length;
	path->gray = path->start = rgb_gray(path->flux);
	path->out->statistics.emitted_flux += path->start;
	return path->start > 0;
}

static void attenuate(Path *path, const Interior *interior, double distance)
{
	if (!interior || interior->fade_power <= 0 || interior->fade_distance <= 0)
		return;
	float before = path->gray;
	path->flux = rgb_mul(path->flux, shade_attenuation(interior, distance));
	path->gray = rgb_gray(path->flux);
	path->out->statistics.absorbed_flux += before - path->gray;
}

static bool collects(const Path *path, const Surface *surface)
{
	return path->edges > 1 && surface->photons_collect &&
	       shade_light_reaches(path->light, surface);
}

static void find_meeting(const Path *path, const Hit *hit, int inside, Meeting *out)
{
	Vec3 place = ray_at(&path->ray, hit->t), normal = plain_shading_normal(hit, place);
	bool back = vec3_dot(normal, path->ray.direction) > 0;
	*out = (Meeting){hit, hit->shape->owner, place, back ? vec3_neg(normal) : normal, inside};
}

/* At a surface that nothing leaves and that is nowhere a mere mirror: its textures need not be
 * asked. */
static void end_on(Path *path, const Hit *hit)
{
	PhotonStatistics *statistics = &path->out->statistics;
	Meeting at;
	if (!collects(path, hit->shape->owner)) {
		statistics->absorbed_flux += path->gray;
		return;
	}
	find_meeting(path, hit, -1, &at);
	store(path, &at);
	statistics->stored_flux += path->gray;
}

/* Leaves a photon if it may and goes on if the path does. inside: the surface's place among those
 * that the path is in. */
static bool scatter(Path *path, const Hit *hit, int inside)
{
	Meeting at;
	Ways ways;
	BsdfEvent *chosen = NULL;
	PhotonStatistics *statistics = &path->out->statistics;
	find_meeting(path, hit, inside, &at);
	settle_hue(path, at.surface);
	find_ways(path, &at, &ways);
	float before = path->gray;
	bool stored = collects(path, at.surface) && !ways.delta, on = false;
	if (stored)
		store(path, &at);
	if (path->edges < path->most_levels)
		chosen = choose_event(path, at.surface, &ways);
	if (chosen) {
		go_on(path, &at, &ways, chosen);
		on = survives(path);
	}
	double taken = before - (on ? path->gray : 0);
	*(stored ? &statistics->stored_flux : &statistics->absorbed_flux) += taken;
	return on;
}

/* Returns whether the path goes on. */
static bool meet(Path *path, const Hit *hit)
{
	const Surface *surface = hit->shape->owner;
	path->length += hit->t;
	if (passes_by(path, surface))
		return pass_by(path, hit);
	if (path->edges == 0 && !lands_on_target(path, surface, ray_at(&path->ray, hit->t)))
		return false;
	path->edges++;
	int inside = inside_find(&path->inside, surface);
	if (inside >= 0)
		attenuate(path, surface->interior, hit->t);
	if (surface->ends_light) {
		end_on(path, hit);
		return false;
	}
	return scatter(path, hit, inside);
}

/* ---- runs of paths ---- */

static void follow(Path *path)
{
	PhotonStatistics *statistics = &path->out->statistics;
	for (int i = 0; i < PATH_MAX_CROSSINGS; i++) {
		Hit hit;
		statistics->segments++;
		AccelFilter *filter = path->edges == 0 && path->aim->passes ? accept_on_the_way
									 : NULL;
		if (!accel_nearest(path->scene->accel, &path->ray, filter, path, &hit)) {
			if (path->edges > 0) {
				statistics->escaped++;
				statistics->escaped_flux += path->gray;
			}
			return;
		}
		if (!meet(path, &hit)) {
			statistics->absorbed++;
			return;
		}
	}
	statistics->absorbed++;
	statistics->absorbed_flux += path->gray;
}

static void begin(Path *path, int at, uint64_t number)
{
	path->at = at;
	const Emission *emission = emission_of(path);
	path->sampler.index = path->aim->first + number;
	path->sampler.dimension = 0;
	path->ray = (Ray){emission->origin, emission->direction, 0, INFINITY};
	path->length = 0;
	path->hue = 0.5;
	path->colored = false;
	path->edges = 0;
	path->tint = rgb_all(1);
	path->kind = 0;
	inside_copy(&path->inside, &path->aim->inside);
}

static float bailout_of(const Settings *settings)
{
	return (float)(settings->photons.adc_bailout < 0 ? settings->adc_bailout
							 : settings->photons.adc_bailout);
}

static int most_levels(const Settings *settings)
{
	int own = settings->photons.max_trace_level;
	return own > 0 ? own : settings->max_trace_level;
}

void photon_paths(const Scene *scene, const PhotonAim *aim, const PhotonTraceOptions *options,
		  uint64_t first, uint64_t count, PhotonBuffer *out)
{
	Path path;
	path.scene = scene;
	path.light = &scene->lights[aim->light];
	path.aim = aim;
	path.out = out;
	path.share = 1.0 / (double)aim->paths;
	path.bailout = bailout_of(&scene->settings);
	path.most_levels = most_levels(&scene->settings);
	path.sampler.seed = random_bits(options->seed, options->pass, 1);
	out->statistics.paths += count;
	for (uint64_t done = 0; done < count; done += PHOTON_STARTS_MAX) {
		uint64_t left = count - done;
		int some = left < PHOTON_STARTS_MAX ? (int)left : PHOTON_STARTS_MAX;
		photon_starts(scene, aim, options, first + done, some, &path.starts);
		for (int i = 0; i < some; i++) {
			if (!photon_aim_hits(aim, &path.starts.emissions[i]))
				continue;
			begin(&path, i, first + done + (uint64_t)i);
			follow(&path);
		}
	}
}
