/*
 * Each photon's own footprint. Photons of one light that went the same way (same objects, same
 * events) to the same object sample one map from emitter coordinates (Spencer & Jones 2013,
 * section 4.1) to the surface. From its neighbours in emitter space a photon knows that map
 * nearby (footprint_fit.h), and so the ellipse over which its share of the light spreads: photon
 * differentials (Schjøth et al. 2007) without tracing any. Density is the sum of flux times the
 * ellipses' normalised kernels over those that cover the gather point.
 *
 * The share is round in emitter space, with the area of a dozen photons at the local density of
 * emission, up to three times that where the map is straight. The ellipse has the covariance
 * that the fitted map gives it: the linear part, and
 * that of the second-order part, which keeps it from vanishing at folds, where the first is
 * singular; the second-order part also moves its centre.
 *
 * Where no smooth map fits (rough surfaces, creases, too few photons of a kind) the ellipse turns
 * gradually, by what share of the neighbours' spread the fit leaves, into the disc that holds the
 * nearest photons on the surface.
 *
 * In a progressive pass all shares shrink in proportion to the pass' radius, so the mean over
 * passes converges as Knaus & Zwicker's does: a kernel keeps its integral and its place whatever
 * its shape.
 *
 * What it does not do: end a kernel at the border of a sheet or of an object; what passes over is
 * lost to the picture.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/arena.h"
#include "base/parallel.h"
#include "density/footprint_fit.h"
#include "density/footprint_tree.h"
#include "density/gather.h"
#include "density/kernel.h"

/* A footprint: distances from `at` along its axes, over their lengths, are a . x and b . x; a is
 * the shorter one. */
typedef struct Footprint {
	float at[3], a[3], b[3];
	float least, most; /* lengths of the axes */
	uint32_t photon;
} Footprint;

typedef struct FootprintMap {
	FootprintTree tree;
	uint32_t count;
	Footprint *footprints;
} FootprintMap;

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

/*
 * Colours that glass has spread come by ways of their own: white light of neighbours in emitter
 * space takes hues at random. So strongly coloured photons are told apart by hue, the rest is one kind.
 */
static unsigned kind_of_hue(Rgb flux)
{
	enum { HUES = 16 };
	static const float least_saturation = 0.3f;
	float most = rgb_max(flux), least = fminf(flux.r, fminf(flux.g, flux.b)), range = most - least;
	if (!(range > least_saturation * most))
		return 0;
	float sixth = most == flux.r   ? (flux.g - flux.b) / range + 6
	              : most == flux.g ? (flux.b - flux.r) / range + 2
	                               : (flux.r - flux.g) / range + 4;
	return 1 + (unsigned)(sixth * HUES / 6 + 0.5f) % HUES;
}

static Key *make_keys(const PhotonMap *map)
{
	Key *keys = memory_alloc(sizeof *keys * (map->count + 1));
	for (uint32_t i = 0; i < map->count; i++) {
		const Photon *p = &map->photons[i];
		uint64_t landed = (uint64_t)p->light << 16 | p->object;
		uint64_t way = (uint64_t)p->path << 8 | p->edges;
		uint64_t kind = landed << 24 | way << 8 | kind_of_hue(photon_flux(p));
		keys[i] = (Key){kind, i};
	}
	qsort(keys, map->count, sizeof *keys, compare_keys);
	return keys;
}

/* ---- one photon's shape ---- */

typedef struct Shape {
	double shift[2];
	Symmetric covariance;
} Shape;

typedef struct Group {
	const PhotonMap *map;
	const Key *keys;
	uint32_t count;
	PhotonTree *tree; /* over emitter coordinates; indices count keys */
	double share;     /* area of a kernel in emitter space, in photons of the group */
	double pass;      /* how much kernels have shrunk by this pass, 0..1 */
	double reach;
	Shape *shapes;    /* of each photon */
} Group;

static Vec3 vec3_of(const float v[3]) { return vec3(v[0], v[1], v[2]); }

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

/* Neighbours in emitter space that the map is fitted to, and on the surface where none fits. */
enum { FIT_COUNT = 24, FALLBACK_COUNT = 24 };

/* The kernel's variance along an axis over that axis' square. */
static const double variance_of_kernel = 1.0 / 6;

/* Variance of the kernel of nearest photons here. */
static double nearest_variance(const Group *g, const Photon *p)
{
	GatherPoint point = {.position = vec3_of(p->position), .normal = photon_normal(p)};
	GatherTask task = {.map = g->map, .point = &point};
	Neighbor found[GATHER_ROOM(FALLBACK_COUNT)];
	double radius2 = 0;
	gather_nearest(&task, FALLBACK_COUNT, g->reach, found, &radius2);
	return variance_of_kernel * radius2;
}

typedef struct NeighborList {
	const Neighbor *found;
	int count;
	double scale;
} NeighborList;

/* The neighbours found, parameters multiplied by scale, without p itself and what lies across an
 * edge. */
static int take_samples(const Group *g, const Photon *p, NeighborList near, FitSample *out)
{
	Vec3 pu, pv, u, v;
	int taken = 0;
	parameter_frame(g->map, p, &pu, &pv);
	vec3_frame(photon_normal(p), &u, &v);
	for (int i = 0; i < near.count; i++) {
		const Photon *q = &g->map->photons[g->keys[near.found[i].index].photon];
		Vec3 d = vec3_scale(vec3_sub(vec3_of(q->emitter), vec3_of(p->emitter)), near.scale);
		Vec3 x = vec3_sub(vec3_of(q->position), vec3_of(p->position));
		if (q == p || vec3_dot(photon_normal(p), photon_normal(q)) < 0.5)
			continue;
		out[taken++] = (FitSample){{vec3_dot(d, pu), vec3_dot(d, pv)},
		                           {vec3_dot(x, u), vec3_dot(x, v)}};
	}
	return taken;
}

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

/* Fits the photon's neighbours, in parameters in which the farthest is 1 away; returns how many
 * those are, 0: no fit. */
static int fit_neighbors(const Group *g, const Photon *p, FootprintFit *fit)
{
	Neighbor found[FIT_COUNT + 1 + 8 * TREE_SLACK];
	FitSample samples[FIT_COUNT + 1];
	const float *e = p->emitter;
	NearestQuery query = {{e[0], e[1], e[2]}, INFINITY, FIT_COUNT + 1, NULL};
	int count = photon_tree_nearest(g->tree, &query, found);
	double farthest = sqrt(photon_tree_farthest(found, count));
	if (!(farthest > 0))
		return 0;
	int taken = take_samples(g, p, (NeighborList){found, count, 1 / farthest}, samples);
	return footprint_fit(samples, taken, fit) ? count - 1 : 0;
}

/*
 * How much wider than the default a share may be, as a ratio of areas: where the map is nearly
 * linear, density is even and only the photons' noise counts. The curved part's variance beside
 * the linear part's across the ellipse grows as the area does and may reach a fiftieth: by trial,
 * 0.005 to 0.08 differ little. So may what neighbours beyond a crease are away from the fit.
 */
static double growth_of(const FootprintFit *fit, const FootprintSpread *spread)
{
	static const double most_growth = 3, allowed_curvature = 0.02;
	Symmetric l = spread->linear;
	double mean = 0.5 * (l.uu + l.vv), difference = 0.5 * (l.uu - l.vv);
	double least = mean - sqrt(difference * difference + l.uv * l.uv);
	double curvature = spread->curved.uu + spread->curved.vv + fit->misfit;
	if (!(curvature * most_growth > allowed_curvature * least))
		return most_growth;
	return fmax(1, allowed_curvature * least / curvature);
}

static void add_fitted(const Group *g, const FootprintFit *fit, int neighbors, double trust,
                       Shape *shape)
{
	double shrunk2 = g->pass * g->pass;
	double share2 = g->share / neighbors; /* of the circle that holds the neighbours */
	FootprintSpread spread = footprint_spread(fit, variance_of_kernel * share2);
	spread = footprint_spread(fit, variance_of_kernel * share2 * growth_of(fit, &spread) * shrunk2);
	shape->shift[0] = trust * spread.mean[0];
	shape->shift[1] = trust * spread.mean[1];
	shape->covariance = blend(spread.linear, trust, spread.curved, trust);
	shape->covariance = blend(shape->covariance, 1, fit->residual, trust * shrunk2);
}

static void set_shape(void *data, long item, int thread)
{
	(void)thread;
	Group *g = data;
	uint32_t index = g->keys[item].photon;
	const Photon *p = &g->map->photons[index];
	FootprintFit fit;
	int neighbors = fit_neighbors(g, p, &fit);
	double doubt = neighbors > 0 ? doubt_of(fit.roughness) : 1;
	Shape *shape = &g->shapes[index];
	*shape = (Shape){{0, 0}, {0, 0, 0}};
	if (doubt < 1)
		add_fitted(g, &fit, neighbors, 1 - doubt, shape);
	if (doubt > 0) {
		double variance = doubt * g->pass * g->pass * nearest_variance(g, p);
		shape->covariance.uu += variance;
		shape->covariance.vv += variance;
	}
}

static void set_group(Group *g)
{
	TreePoints points = {.count = g->count, .stride = 3 * sizeof(float)};
	float (*emitters)[3] = memory_alloc(sizeof *emitters * g->count);
	for (uint32_t i = 0; i < g->count; i++)
		memcpy(emitters[i], g->map->photons[g->keys[i].photon].emitter, sizeof *emitters);
	points.position = emitters[0];
	g->tree = photon_tree_create(&points);
	parallel_for(g->count, 64, set_shape, g);
	photon_tree_destroy(g->tree);
	free(emitters);
}

/* ---- ellipses ---- */

static Footprint make_footprint(const Photon *p, const Shape *shape, double least_variance)
{
	Vec3 u, v;
	vec3_frame(photon_normal(p), &u, &v);
	Symmetric c = shape->covariance;
	double mean = 0.5 * (c.uu + c.vv), difference = 0.5 * (c.uu - c.vv);
	double spread = sqrt(difference * difference + c.uv * c.uv);
	double angle = 0.5 * atan2(c.uv, difference);
	double most = fmax(mean + spread, least_variance);
	double least = fmax(mean - spread, fmax(least_variance, 1e-6 * most));
	Vec3 along = vec3_mad(vec3_scale(u, cos(angle)), sin(angle), v);
	Vec3 across = vec3_mad(vec3_scale(v, cos(angle)), -sin(angle), u);
	double b = sqrt(most / variance_of_kernel), a = sqrt(least / variance_of_kernel);
	Vec3 at = vec3_mad(vec3_mad(vec3_of(p->position), shape->shift[0], u), shape->shift[1], v);
	return (Footprint){
		.at = {(float)at.x, (float)at.y, (float)at.z}, .least = (float)a, .most = (float)b,
		.a = {(float)(across.x / a), (float)(across.y / a), (float)(across.z / a)},
		.b = {(float)(along.x / b), (float)(along.y / b), (float)(along.z / b)},
	};
}

/* Along the normal as far as photons are accepted (gather.h). */
static Box3 footprint_box(const Footprint *f, Vec3 normal)
{
	double a2 = pow(f->least, 4), b2 = pow(f->most, 4);
	double extent[3], n[3] = {normal.x, normal.y, normal.z};
	for (int k = 0; k < 3; k++)
		extent[k] = sqrt(a2 * f->a[k] * f->a[k] + b2 * f->b[k] * f->b[k]) +
		            0.25 * f->most * fabs(n[k]);
	Vec3 at = vec3_of(f->at), e = vec3(extent[0], extent[1], extent[2]);
	return (Box3){vec3_sub(at, e), vec3_add(at, e)};
}

/* In the tree's order, in one block with it. */
static FootprintMap *arrange(const Footprint *footprints, const Box3 *boxes, uint32_t count)
{
	uint32_t *order = memory_alloc(sizeof *order * (count + 1));
	Box3 *ordered = memory_alloc(sizeof *ordered * (count + 1));
	footprint_tree_order(boxes, count, order);
	for (uint32_t i = 0; i < count; i++)
		ordered[i] = boxes[order[i]];
	FootprintTree tree = footprint_tree_build(ordered, count);
	size_t nodes = tree.levels > 0 ? tree.level_start[tree.levels - 1] + 1u : 0;
	size_t size = sizeof(FootprintMap) + sizeof(FootprintNode) * nodes + sizeof(Footprint) * count;
	FootprintMap *f = memory_alloc(size);
	*f = (FootprintMap){.tree = tree, .count = count};
	f->tree.nodes = (FootprintNode *)(f + 1);
	f->footprints = (Footprint *)(f->tree.nodes + nodes);
	memcpy(f->tree.nodes, tree.nodes, sizeof(FootprintNode) * nodes);
	for (uint32_t i = 0; i < count; i++)
		f->footprints[i] = footprints[order[i]];
	free(tree.nodes);
	free(ordered);
	free(order);
	return f;
}

/* By trial (tests/bench/footprint_trial.c). Where colours spread, more are wanted: each hue has
 * its own few. */
static const double default_share = 12, share_of_hue = 24;

/* Whether the way of a group's photons spreads colours: tinted light has one hue or two. */
static bool is_dispersed(const Key *keys, uint32_t count, uint32_t first)
{
	enum { LEAST_HUES = 5 };
	uint32_t begin = first, end = first;
	int hues = 1;
	while (begin > 0 && keys[begin - 1].kind >> 8 == keys[first].kind >> 8)
		begin--;
	for (end = begin + 1; end < count && keys[end].kind >> 8 == keys[first].kind >> 8; end++)
		hues += keys[end].kind != keys[end - 1].kind;
	return hues >= LEAST_HUES;
}

static Shape *make_shapes(const EstimatorSetup *setup)
{
	const PhotonMap *map = setup->map;
	Key *keys = make_keys(map);
	Group g = {.map = map, .reach = gather_reach(map, FALLBACK_COUNT), .pass = 1};
	double scale = setup->method->scale > 0 ? setup->method->scale : 1;
	g.shapes = memory_alloc(sizeof *g.shapes * (map->count + 1));
	/* The radius that a render without a word about it starts with holds fifty photons. */
	if (setup->radius > 0 && map->spacing > 0)
		g.pass = fmin(1, setup->radius / (map->spacing * sqrt(50 / M_PI)));
	for (uint32_t first = 0; first < map->count; first += g.count) {
		g.keys = keys + first;
		bool dispersed = is_dispersed(keys, map->count, first);
		g.share = scale * scale * (dispersed ? share_of_hue : default_share);
		for (g.count = 1; first + g.count < map->count && g.keys[g.count].kind == g.keys->kind;)
			g.count++;
		set_group(&g);
	}
	free(keys);
	return g.shapes;
}

static void *footprint_create(const EstimatorSetup *setup, Diag *diag)
{
	(void)diag;
	const PhotonMap *map = setup->map;
	Shape *shapes = make_shapes(setup);
	Footprint *footprints = memory_alloc(sizeof *footprints * (map->count + 1));
	Box3 *boxes = memory_alloc(sizeof *boxes * (map->count + 1));
	double least = 1e-6 * map->spacing * map->spacing;
	for (uint32_t i = 0; i < map->count; i++) {
		footprints[i] = make_footprint(&map->photons[i], &shapes[i], least);
		footprints[i].photon = i;
		boxes[i] = footprint_box(&footprints[i], photon_normal(&map->photons[i]));
	}
	FootprintMap *f = arrange(footprints, boxes, map->count);
	free(boxes);
	free(footprints);
	free(shapes);
	return f;
}

/* ---- gathering ---- */

typedef struct Gathering {
	GatherSum sum;
	const FootprintMap *map;
	float at[3];
	float pixel2; /* what a pixel adds to an axis' square */
	double radius;
} Gathering;

static void add_footprint(void *data, uint32_t number)
{
	Gathering *g = data;
	const Footprint *f = &g->map->footprints[number];
	float x = g->at[0] - f->at[0], y = g->at[1] - f->at[1], z = g->at[2] - f->at[2];
	float a = f->a[0] * x + f->a[1] * y + f->a[2] * z, b = f->b[0] * x + f->b[1] * y + f->b[2] * z;
	float least2 = f->least * f->least, most2 = f->most * f->most;
	float wide_least2 = least2 + g->pixel2, wide_most2 = most2 + g->pixel2;
	float t2 = a * a * least2 / wide_least2 + b * b * most2 / wide_most2;
	if (!(t2 < 1))
		return;
	const GatherTask *task = g->sum.task;
	const Photon *photon = &task->map->photons[f->photon];
	double radius = sqrt(wide_most2);
	if (!gather_accepts(task->point, photon, radius))
		return;
	double area = sqrt(wide_least2) * radius;
	gather_add(&g->sum, photon, kernel_value(KERNEL_EPANECHNIKOV, t2) / area);
	g->radius += radius;
}

static void footprint_gather(const void *method, const GatherTask *task, GatherResult *result)
{
	Vec3 p = task->point->position;
	double width = task->point->footprint, pixel2 = width * width / 12 / variance_of_kernel;
	Gathering g = {.sum = {.task = task}, .map = method, .pixel2 = (float)pixel2,
	               .at = {(float)p.x, (float)p.y, (float)p.z}};
	Vec3 reach = vec3_all(sqrt(pixel2));
	Box3 box = {vec3_sub(p, reach), vec3_add(p, reach)};
	footprint_tree_visit(&g.map->tree, box, add_footprint, &g);
	gather_finish(&g.sum, g.sum.photons > 0 ? g.radius / g.sum.photons : 0, result);
}

const EstimatorMethod footprint_method = {"footprint", footprint_create, footprint_gather};
