/*
 * A photon's share of light is round in emitter space, with the area of a dozen photons at the
 * local density of emission, twice that where the map is straight. The ellipse has the
 * covariance that the fitted map gives it (footprint_fit.h): the linear part, and that of the
 * second-order part, which keeps it from vanishing at folds, where the first is singular; the
 * second-order part also moves its centre.
 *
 * Where neighbours are missing the sheet has ended: the kernel does too (footprint_border.h).
 *
 * Where no smooth map fits (rough surfaces, creases, too few photons of a kind) the ellipse turns
 * gradually, by what share of the neighbours' spread the fit leaves, into the disc that holds the
 * nearest photons on the surface.
 */
#include "density/footprint_shape.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/arena.h"
#include "base/parallel.h"
#include "density/footprint_hue.h"
#include "density/gather.h"

/* ---- groups ---- */

/* A photon's kind and its number. */
typedef struct Key { uint64_t kind; uint32_t photon; } Key;

static int compare_keys(const void *a, const void *b)
{
	const Key *x = a, *y = b;
	if (x->kind != y->kind)
		return x->kind < y->kind ? -1 : 1;
	return (x->photon > y->photon) - (x->photon < y->photon);
}

static Key *make_keys(const PhotonMap *map)
{
	Key *keys = memory_alloc(sizeof *keys * (map->count + 1));
	for (uint32_t i = 0; i < map->count; i++) {
		const Photon *p = &map->photons[i];
		uint64_t landed = (uint64_t)p->light << 16 | p->object;
		uint64_t way = (uint64_t)p->path << 8 | p->edges;
		keys[i] = (Key){landed << 24 | way, i};
	}
	qsort(keys, map->count, sizeof *keys, compare_keys);
	return keys;
}

/* ---- one photon's shape ---- */

typedef struct Group {
	const PhotonMap *map;
	const Key *keys;
	uint32_t count;
	PhotonTree *tree; /* over emitter coordinates; indices count keys */
	float *areas;     /* in emitter space, of each one's share as its neighbours are spaced */
	double share;     /* area of a kernel in emitter space, in photons of the group */
	double pass;      /* how much kernels have shrunk by this pass, 0..1 */
	double reach;
	FootprintHues hues;
	bool parted;      /* photons have hues */
	int room;         /* footprints a photon may have */
	Footprint *footprints; /* room for each photon of the group; kernels of no flux are empty */
} Group;

static Vec3 vec3_of(const float v[3]) { return vec3(v[0], v[1], v[2]); }

static const Photon *photon_of(const Group *g, uint32_t item)
{
	return &g->map->photons[g->keys[item].photon];
}

static bool is_planar(const PhotonMap *map, const Photon *p)
{
	return p->light < map->light_count && map->lights[p->light].parameter_dimensions == 2;
}

/* The plane of the parameters near a photon: the emitter's own, or the one that touches the
 * sphere of directions. */
static void parameter_frame(const PhotonMap *map, const Photon *p, Vec3 *u, Vec3 *v)
{
	if (is_planar(map, p)) {
		*u = vec3(1, 0, 0);
		*v = vec3(0, 1, 0);
	} else {
		vec3_frame(vec3_normalize(vec3_of(p->emitter)), u, v);
	}
}

/* Neighbours in emitter space, on the surface where no map fits, and in emitter space that tell how
 * dense photons are. The map is fitted to the disc of emitter space that holds FIT_COUNT: weights
 * fall beyond. */
enum { KNOWN_COUNT = 36, FALLBACK_COUNT = 24, AREA_COUNT = 10, FIT_COUNT = 24 };

/* Radius of the disc that holds the nearest photons here. */
static double nearest_radius(const Group *g, const Photon *p)
{
	GatherPoint point = {.position = vec3_of(p->position), .normal = photon_normal(p)};
	GatherTask task = {.map = g->map, .point = &point};
	Neighbor found[GATHER_ROOM(FALLBACK_COUNT)];
	double radius2 = 0;
	gather_nearest(&task, FALLBACK_COUNT, g->reach, found, &radius2);
	return sqrt(radius2);
}

static int find_neighbors(const Group *g, const Photon *p, int count, Neighbor *found)
{
	const float *e = p->emitter;
	NearestQuery query = {{e[0], e[1], e[2]}, INFINITY, count, NULL};
	return photon_tree_nearest(g->tree, &query, found);
}

/* ---- density in emitter space ---- */

static void set_area(void *data, long item, int thread)
{
	(void)thread;
	Group *g = data;
	Neighbor found[AREA_COUNT + 1 + 8 * TREE_SLACK];
	int count = find_neighbors(g, photon_of(g, (uint32_t)item), AREA_COUNT + 1, found);
	double radius2 = photon_tree_farthest(found, count);
	g->areas[item] = count > 1 ? (float)(M_PI * radius2 / (count - 1)) : 0;
}

static int compare_areas(const void *a, const void *b)
{
	float x = *(const float *)a, y = *(const float *)b;
	return (x > y) - (x < y);
}

/* Near a border a photon's own neighbours are few for the area; those farther in know better. */
static double area_near(const Group *g, const Neighbor *found, int count)
{
	float areas[KNOWN_COUNT + 1];
	for (int i = 0; i < count; i++)
		areas[i] = g->areas[found[i].index];
	qsort(areas, (size_t)count, sizeof *areas, compare_areas);
	return count > 0 ? areas[count / 4] : 0;
}

/* ---- neighbourhoods ---- */

/* A photon's neighbours, in parameters in which the disc of FIT_COUNT photons has the radius 1. */
typedef struct Neighborhood {
	FitSample samples[KNOWN_COUNT + 1];
	int count;
	double area;   /* of a share */
	double window; /* all neighbours within this are known */
	FootprintPlane plane;
	/* of parted light, else 0: */
	int hues[KNOWN_COUNT + 1 + 8 * TREE_SLACK];
	double hue; /* the photon's own */
	Rgb white;  /* its flux if it had all hues */
} Neighborhood;

/*
 * Of parted light: each neighbour's hue, and what the sheet brings here of each primary if all hues
 * came: what the neighbours bring over what they would at strength 1. That ratio hardly depends on
 * which hues chance has drawn.
 */
static void find_hues(const Group *g, const Neighbor *found, int count, Neighborhood *n)
{
	double sum[3] = {0}, full[3] = {0};
	for (int i = 0; i < count; i++) {
		Rgb flux = photon_flux(photon_of(g, found[i].index));
		sum[0] += flux.r;
		sum[1] += flux.g;
		sum[2] += flux.b;
	}
	double mean = (sum[0] + sum[1] + sum[2]) / (3 * count);
	for (int i = 0; i < count && mean > 0; i++) {
		Rgb flux = photon_flux(photon_of(g, found[i].index));
		n->hues[i] = footprint_hue_of(&g->hues, rgb_scale(flux, (float)(1 / mean)));
		Rgb color = g->hues.color[n->hues[i]];
		full[0] += color.r;
		full[1] += color.g;
		full[2] += color.b;
	}
	n->white = rgb((float)(full[0] > 0 ? sum[0] / full[0] : 0),
	               (float)(full[1] > 0 ? sum[1] / full[1] : 0),
	               (float)(full[2] > 0 ? sum[2] / full[2] : 0));
}

/* Without p itself and what lies across an edge. */
static void take_samples(const Group *g, const Photon *p, const Neighbor *found, int count,
                         double scale, Neighborhood *n)
{
	Vec3 pu, pv;
	parameter_frame(g->map, p, &pu, &pv);
	for (int i = 0; i < count; i++) {
		const Photon *q = photon_of(g, found[i].index);
		Vec3 d = vec3_scale(vec3_sub(vec3_of(q->emitter), vec3_of(p->emitter)), scale);
		Vec3 x = vec3_sub(vec3_of(q->position), vec3_of(p->position));
		if (q == p)
			n->hue = (double)n->hues[i] / FOOTPRINT_HUES;
		if (q == p || vec3_dot(n->plane.normal, photon_normal(q)) < 0.5)
			continue;
		n->samples[n->count++] =
			(FitSample){{vec3_dot(d, pu), vec3_dot(d, pv)},
		                    {vec3_dot(x, n->plane.u), vec3_dot(x, n->plane.v)},
		                    (double)n->hues[i] / FOOTPRINT_HUES};
	}
}

static void look_around(const Group *g, const Photon *p, Neighborhood *n)
{
	Neighbor found[KNOWN_COUNT + 1 + 8 * TREE_SLACK];
	int count = find_neighbors(g, p, KNOWN_COUNT + 1, found);
	double area = area_near(g, found, count), scale = sqrt(M_PI / (FIT_COUNT * area));
	*n = (Neighborhood){.count = 0};
	n->area = M_PI / FIT_COUNT;
	n->plane.normal = photon_normal(p);
	vec3_frame(n->plane.normal, &n->plane.u, &n->plane.v);
	n->window = count == KNOWN_COUNT + 1 ? scale * sqrt(photon_tree_farthest(found, count))
	                                     : INFINITY;
	if (!(area > 0))
		return;
	if (g->parted)
		find_hues(g, found, count, n);
	take_samples(g, p, found, count, scale, n);
	for (int i = 0; i < n->count; i++)
		n->samples[i].hue -= n->hue;
}

/* ---- shapes ---- */

static Symmetric blend(Symmetric a, double s, Symmetric b, double t)
{
	return (Symmetric){s * a.uu + t * b.uu, s * a.uv + t * b.uv, s * a.vv + t * b.vv};
}

/* Roughness from which a fit starts to be doubted, and from which it counts no more. */
static double doubt_of(double roughness)
{
	static const double low = 0.02, high = 0.3;
	double t = fmax(0, fmin(1, (roughness - low) / (high - low)));
	return t * t * (3 - 2 * t);
}

/*
 * How much wider than the default a share may be, as a ratio of areas: where the map is nearly
 * linear, density is even and only the photons' noise counts. The curved part's variance beside
 * the linear part's across the ellipse grows as the area does and may reach a fiftieth: by trial,
 * 0.005 to 0.08 differ little. So may what neighbours beyond a crease are away from the fit.
 */
static double growth_of(const FootprintFit *fit, const FootprintSpread *spread, double most_growth)
{
	static const double allowed_curvature = 0.02;
	Symmetric l = spread->linear;
	double mean = 0.5 * (l.uu + l.vv), difference = 0.5 * (l.uu - l.vv);
	double least = mean - sqrt(difference * difference + l.uv * l.uv);
	double curvature = spread->curved.uu + spread->curved.vv + fit->misfit;
	if (!(curvature * most_growth > allowed_curvature * least))
		return most_growth;
	return fmax(1, allowed_curvature * least / curvature);
}

/* The share's square radius in the parameters. */
static double share2_of(const Group *g, const FootprintFit *fit)
{
	double share2 = g->share / FIT_COUNT, most_growth = fmax(1, 1 / share2);
	FootprintSpread spread = footprint_spread(fit, footprint_variance * share2);
	return share2 * growth_of(fit, &spread, most_growth) * g->pass * g->pass;
}

static void add_borders(const FootprintFit *fit, const Neighborhood *n, double share2,
                        FootprintShape *shape)
{
	static const double wider = 1.3; /* than the share, to see what is missing at its rim */
	double window = fmin(n->window, wider * sqrt(share2));
	BorderSearch search = {n->samples, n->count, window, n->area};
	Border borders[MOST_BORDERS];
	shape->borders = footprint_borders(&search, borders);
	for (int i = 0; i < shape->borders; i++) {
		const double *t = borders[i].toward, distance = borders[i].distance;
		for (int k = 0; k < 2; k++) {
			const double *j = fit->jacobian[k];
			shape->out[i][k] = j[0] * t[0] + j[1] * t[1];
			shape->along[i][k] = sqrt(share2) * (j[1] * t[0] - j[0] * t[1]);
			shape->point[i][k] = distance * shape->out[i][k];
		}
	}
}

static void add_fitted(const Group *g, const FootprintFit *fit, const Neighborhood *n, double trust,
                       FootprintShape *shape)
{
	double share2 = share2_of(g, fit);
	FootprintSpread spread = footprint_spread(fit, footprint_variance * share2);
	shape->center[0] = trust * spread.mean[0];
	shape->center[1] = trust * spread.mean[1];
	shape->covariance = blend(spread.linear, trust, spread.curved, trust);
	shape->covariance = blend(shape->covariance, 1, fit->residual, trust * g->pass * g->pass);
	if (trust > 0.5)
		add_borders(fit, n, share2, shape);
}

static Symmetric square_of(const double x[2], double scale)
{
	return (Symmetric){scale * x[0] * x[0], scale * x[0] * x[1], scale * x[1] * x[1]};
}

/* Into how many bands the spectrum is to be cut, so that they overlap. */
static int count_bands(const FootprintShape *shape, const FootprintFit *fit, int most)
{
	Symmetric c = shape->covariance, h = square_of(fit->hue, 1);
	double determinant = c.uu * c.vv - c.uv * c.uv;
	double distance2 = (c.vv * h.uu - 2 * c.uv * h.uv + c.uu * h.vv) / determinant;
	double bands = 1 + 0.5 * sqrt(fmax(distance2, 0)); /* two standard deviations apart */
	return bands < most ? (int)bands : most;
}

/* The photon's light in all hues, each where the map takes it. */
static void spread_hues(const Group *g, const Photon *p, const FootprintFit *fit,
                        const FootprintShape *white, const Neighborhood *n, Footprint *out)
{
	double least = 1e-6 * g->map->spacing * g->map->spacing;
	int bands = count_bands(white, fit, g->room);
	for (int i = 0; i < bands; i++) {
		FootprintShape shape = *white;
		double away = (i + 0.5) / bands - n->hue,
		       width2 = g->pass * g->pass / (12.0 * bands * bands);
		for (int k = 0; k < 2; k++)
			shape.center[k] += away * fit->hue[k] +
					   0.5 * away * away * fit->hue_curve[k];
		shape.covariance = blend(shape.covariance, 1, square_of(fit->hue, width2), 1);
		for (int b = 0; b < shape.borders; b++)
			for (int k = 0; k < 2; k++)
				shape.point[b][k] += shape.center[k] - white->center[k];
		out[i] = footprint_make(&shape, vec3_of(p->position), &n->plane, least);
		out[i].flux = rgb_mul(footprint_hue_band(&g->hues, i, bands), n->white);
	}
}

static void add_fallback(const Group *g, const Photon *p, double doubt, FootprintShape *shape)
{
	double radius = g->pass * nearest_radius(g, p);
	double variance = doubt * footprint_variance * radius * radius;
	shape->covariance.uu += variance;
	shape->covariance.vv += variance;
}

static void set_shape(void *data, long item, int thread)
{
	(void)thread;
	Group *g = data;
	const Photon *p = photon_of(g, (uint32_t)item);
	Footprint *out = &g->footprints[item * g->room];
	FootprintShape shape = {.borders = 0};
	FootprintFit fit;
	Neighborhood n;
	look_around(g, p, &n);
	double doubt = footprint_fit(n.samples, n.count, &fit) ? doubt_of(fit.roughness) : 1;
	if (doubt < 1)
		add_fitted(g, &fit, &n, 1 - doubt, &shape);
	if (doubt > 0)
		add_fallback(g, p, doubt, &shape);
	memset(out, 0, sizeof *out * (size_t)g->room);
	if (g->parted && doubt < 0.5) {
		spread_hues(g, p, &fit, &shape, &n, out);
		return;
	}
	double least = 1e-6 * g->map->spacing * g->map->spacing;
	*out = footprint_make(&shape, vec3_of(p->position), &n.plane, least);
	out->flux = photon_flux(p);
}

static void set_group(Group *g)
{
	TreePoints points = {.count = g->count, .stride = 3 * sizeof(float)};
	float (*emitters)[3] = memory_alloc(sizeof *emitters * g->count);
	for (uint32_t i = 0; i < g->count; i++)
		memcpy(emitters[i], g->map->photons[g->keys[i].photon].emitter, sizeof *emitters);
	points.position = emitters[0];
	g->tree = photon_tree_create(&points);
	g->areas = memory_alloc(sizeof *g->areas * g->count);
	parallel_for(g->count, 64, set_area, g);
	parallel_for(g->count, 64, set_shape, g);
	photon_tree_destroy(g->tree);
	free(g->areas);
	free(emitters);
}

/* By trial (tests/bench/footprint_trial.c). */
static const double default_share = 12;

/* Whether the photons have hues: strongly coloured ones, red and violet. Looks at some. */
static bool is_parted(const Group *g)
{
	enum { LOOKS = 64 };
	int pure = 0, red = 0, looks = g->count < LOOKS ? (int)g->count : LOOKS;
	for (int i = 0; i < looks; i++) {
		Rgb flux = photon_flux(
			photon_of(g, (uint32_t)((uint64_t)i * g->count / (uint64_t)looks)));
		pure += footprint_hue_is_pure(flux);
		red += flux.r > flux.b;
	}
	return 2 * pure > looks && red > looks / 5 && red < looks - looks / 5;
}

static void add_group(Group *g, FootprintList *list)
{
	enum { MOST_BANDS = 8 };
	g->parted = is_parted(g);
	g->room = g->parted ? MOST_BANDS : 1;
	if (g->parted)
		g->hues = footprint_hues();
	g->footprints = memory_alloc(sizeof *g->footprints * g->count * (size_t)g->room);
	set_group(g);
	list->all = memory_resize(list->all,
				  sizeof *list->all *
					  (list->count + (size_t)g->count * (size_t)g->room + 1));
	for (uint32_t i = 0; i < g->count * (uint32_t)g->room; i++) {
		const Footprint *f = &g->footprints[i];
		if (rgb_is_black(f->flux))
			continue;
		list->all[list->count] = *f;
		list->all[list->count++].photon = g->keys[i / (uint32_t)g->room].photon;
	}
	free(g->footprints);
}

FootprintList footprint_shapes(const EstimatorSetup *setup)
{
	const PhotonMap *map = setup->map;
	Key *keys = make_keys(map);
	FootprintList list = {memory_alloc(sizeof *list.all), 0};
	Group g = {.map = map, .reach = gather_reach(map, FALLBACK_COUNT), .pass = 1};
	double scale = setup->method->scale > 0 ? setup->method->scale : 1;
	g.share = scale * scale * default_share;
	/* The radius that a render without a word about it starts with holds fifty photons. */
	if (setup->radius > 0 && map->spacing > 0)
		g.pass = fmin(1, setup->radius / (map->spacing * sqrt(50 / M_PI)));
	for (uint32_t first = 0; first < map->count; first += g.count) {
		g.keys = keys + first;
		for (g.count = 1;
		     first + g.count < map->count && g.keys[g.count].kind == g.keys->kind;)
			g.count++;
		add_group(&g, &list);
	}
	free(keys);
	return list;
}
