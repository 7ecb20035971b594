/*
 * Four ways to find the footprints that cover gather points, with the same ellipses and the same
 * sums: the product's tree of boxes; Embree's point queries over the same boxes as user geometry;
 * and splatting, where each footprint looks for the gather points in it, with a search tree over
 * the points and a ball, or with a tree of boxes over the points and the footprint's box. Gather
 * points are 320 x 320 over the wave's caustic (wave.h), row by row as pixels are. Takes turns, one
 * thread; prints medians of five turns of processor time, microseconds a gather point, and the
 * ratio to 50 nearest photons, at most 2 being asked.
 *
 *   footprint_lookup [photons ...]
 *
 * Splatting is given for nothing that a renderer must first trace and keep all gather points.
 */
#include "density/footprint.c" /* for the ellipses themselves */

#include <embree3/rtcore.h>
#include <stdio.h>

#include "base/clock.h"
#include "tests/bench/wave.h"

enum { SIDE = 320, POINTS = SIDE * SIDE, RUNS = 5 };

static PhotonMap *make_map(uint32_t count)
{
	double side = 1 + 2 * WAVE_MARGIN;
	PhotonMap *map = photon_map_create();
	map->count = count;
	map->photons = calloc(count, sizeof(Photon));
	map->lights = calloc(1, sizeof(PhotonLight));
	map->light_count = 1;
	map->lights[0] = (PhotonLight){count, side * side, 2};
	for (uint32_t i = 0; i < count; i++) {
		double from[2], to[2];
		wave_start(i + 1, from);
		wave_map(from[0], from[1], to);
		Photon *p = &map->photons[i];
		*p = (Photon){.position = {(float)to[0], 0, (float)to[1]},
			      .emitter = {(float)from[0], (float)from[1]},
			      .edges = 2};
		photon_set_flux(p, rgb_scale(rgb(1, 1, 1), (float)(side * side / count)));
		photon_set_direction(p, vec3(0, 1, 0));
		photon_set_normal(p, vec3(0, 1, 0));
	}
	photon_map_index(map, 0);
	return map;
}

static Rgb white(void *data, Vec3 direction)
{
	(void)data;
	(void)direction;
	return rgb(1, 1, 1);
}

/* ---- what is compared ---- */

typedef struct Bench {
	const PhotonMap *map;
	FootprintMap *footprints;
	DensityEstimator *nearest;
	GatherPoint *points;
	GatherTask *tasks;
	float (*places)[3]; /* of the points */
	RTCDevice device;
	RTCScene scene;
	Box3 *boxes; /* of the footprints */
	GatherResult *results;
} Bench;

/* What footprint_gather begins with. */
static Gathering begin(const Bench *b, uint32_t point)
{
	double width = b->points[point].footprint, pixel2 = width * width / 12 / footprint_variance;
	return (Gathering){.sum = {.task = &b->tasks[point]}, .map = b->footprints,
			   .pixel2 = pixel2,
			   .at = {b->places[point][0], b->places[point][1], b->places[point][2]}};
}

static void gather_nearest_photons(Bench *b)
{
	for (uint32_t i = 0; i < POINTS; i++)
		estimator_gather(b->nearest, &b->points[i], white, NULL, &b->results[i]);
}

static void gather_by_tree(Bench *b)
{
	for (uint32_t i = 0; i < POINTS; i++)
		footprint_gather(b->footprints, &b->tasks[i], &b->results[i]);
}

static bool embree_visit(struct RTCPointQueryFunctionArguments *a)
{
	add_footprint(a->userPtr, a->primID);
	return false; /* the radius stays */
}

static void gather_by_embree(Bench *b)
{
	struct RTCPointQueryContext context;
	rtcInitPointQueryContext(&context);
	for (uint32_t i = 0; i < POINTS; i++) {
		Gathering g = begin(b, i);
		struct RTCPointQuery query = {g.at[0], g.at[1], g.at[2], 0, (float)sqrt(g.pixel2)};
		rtcPointQuery(b->scene, &query, &context, embree_visit, &g);
		gather_finish(&g.sum, 0, &b->results[i]);
	}
}

/* ---- splatting ---- */

typedef struct Splat {
	Gathering *sums;
	const uint32_t *order; /* of the points in the tree of boxes */
	uint32_t footprint;
} Splat;

static void splat_found(void *data, const Neighbor *found, int count)
{
	const Splat *s = data;
	for (int i = 0; i < count; i++)
		add_footprint(&s->sums[found[i].index], s->footprint);
}

static void splat_points(void *data, const uint32_t *points, int count)
{
	const Splat *s = data;
	for (int i = 0; i < count; i++)
		add_footprint(&s->sums[s->order[points[i]]], s->footprint);
}

static Gathering *begin_all(const Bench *b)
{
	Gathering *sums = malloc(sizeof *sums * POINTS);
	for (uint32_t i = 0; i < POINTS; i++)
		sums[i] = begin(b, i);
	return sums;
}

static void finish_all(Bench *b, Gathering *sums)
{
	for (uint32_t i = 0; i < POINTS; i++)
		gather_finish(&sums[i].sum, 0, &b->results[i]);
	free(sums);
}

static void splat_balls(Bench *b)
{
	TreePoints points = {
		.position = b->places[0], .count = POINTS, .stride = sizeof *b->places};
	PhotonTree *tree = photon_tree_create(&points);
	Splat splat = {.sums = begin_all(b)};
	for (uint32_t i = 0; i < b->footprints->count; i++) {
		const Footprint *f = &b->footprints->footprints[i];
		float radius = (float)sqrt(f->most * f->most + splat.sums->pixel2) * 1.0001f;
		splat.footprint = i;
		photon_tree_within(tree, f->at, radius, splat_found, &splat);
	}
	finish_all(b, splat.sums);
	photon_tree_destroy(tree);
}

static void splat_boxes(Bench *b)
{
	Box3 *boxes = malloc(sizeof *boxes * POINTS);
	uint32_t *order = malloc(sizeof *order * POINTS);
	photon_tree_morton(b->places[0], POINTS, sizeof *b->places, order);
	for (uint32_t i = 0; i < POINTS; i++)
		boxes[i].lo = boxes[i].hi = b->points[order[i]].position;
	FootprintTree tree = footprint_tree_build(boxes, POINTS);
	Splat splat = {.sums = begin_all(b), .order = order};
	Vec3 reach = vec3_all(sqrt(splat.sums->pixel2));
	for (uint32_t i = 0; i < b->footprints->count; i++) {
		Box3 box = {vec3_sub(b->boxes[i].lo, reach), vec3_add(b->boxes[i].hi, reach)};
		splat.footprint = i;
		footprint_tree_visit(&tree, box, splat_points, &splat);
	}
	finish_all(b, splat.sums);
	free(tree.nodes);
	free(order);
	free(boxes);
}

/* ---- preparation ---- */

static void embree_bounds(const struct RTCBoundsFunctionArguments *a)
{
	Box3 box = ((const Box3 *)a->geometryUserPtr)[a->primID];
	*a->bounds_o = (struct RTCBounds){
		nextafterf((float)box.lo.x, -INFINITY), nextafterf((float)box.lo.y, -INFINITY),
		nextafterf((float)box.lo.z, -INFINITY), 0,
		nextafterf((float)box.hi.x, INFINITY), nextafterf((float)box.hi.y, INFINITY),
		nextafterf((float)box.hi.z, INFINITY), 0};
}

static void build_embree(Bench *b)
{
	RTCGeometry geometry = rtcNewGeometry(b->device, RTC_GEOMETRY_TYPE_USER);
	b->scene = rtcNewScene(b->device);
	rtcSetGeometryUserPrimitiveCount(geometry, b->footprints->count);
	rtcSetGeometryUserData(geometry, b->boxes);
	rtcSetGeometryBoundsFunction(geometry, embree_bounds, NULL);
	rtcSetGeometryBuildQuality(geometry, RTC_BUILD_QUALITY_HIGH);
	rtcSetSceneBuildQuality(b->scene, RTC_BUILD_QUALITY_HIGH);
	rtcCommitGeometry(geometry);
	rtcAttachGeometry(b->scene, geometry);
	rtcReleaseGeometry(geometry);
	rtcCommitScene(b->scene);
}

static void make_points(Bench *b)
{
	b->points = malloc(sizeof *b->points * POINTS);
	b->tasks = malloc(sizeof *b->tasks * POINTS);
	b->places = malloc(sizeof *b->places * POINTS);
	b->results = calloc(POINTS, sizeof *b->results);
	for (uint32_t i = 0; i < POINTS; i++) {
		Vec3 at = vec3((i % SIDE + 0.5) / SIDE, 0, ((double)(i / SIDE) + 0.5) / SIDE);
		b->points[i] = (GatherPoint){
			.position = at, .normal = vec3(0, 1, 0), .footprint = 1.0 / SIDE};
		b->tasks[i] = (GatherTask){b->map, &b->points[i], white, NULL};
		b->places[i][0] = (float)at.x;
		b->places[i][1] = (float)at.y;
		b->places[i][2] = (float)at.z;
	}
}

static void prepare(Bench *b, const PhotonMap *map, Diag *diag)
{
	PhotonSettings settings = photon_settings_default();
	Estimator nearest = {
		.kind = ESTIMATOR_NEAREST, .kernel = KERNEL_EPANECHNIKOV, .count = 50};
	Estimator footprint = {.kind = ESTIMATOR_FOOTPRINT};
	EstimatorSetup setup = {&nearest, &settings, map, 0};
	*b = (Bench){.map = map, .nearest = estimator_create(&setup, diag)};
	setup.method = &footprint;
	b->footprints = footprint_create(&setup, diag);
	b->boxes = malloc(sizeof *b->boxes * b->footprints->count);
	for (uint32_t i = 0; i < b->footprints->count; i++) {
		const Footprint *f = &b->footprints->footprints[i];
		b->boxes[i] = footprint_box(f, photon_normal(&map->photons[f->photon]));
	}
	make_points(b);
	b->device = rtcNewDevice("threads=1");
	double start = clock_cpu();
	build_embree(b);
	printf("%u photons; Embree's tree is built in %.2f s\n", map->count, clock_cpu() - start);
}

static void dismiss(Bench *b)
{
	rtcReleaseScene(b->scene);
	rtcReleaseDevice(b->device);
	estimator_destroy(b->nearest);
	free(b->footprints);
	free(b->boxes);
	free(b->points);
	free(b->tasks);
	free(b->places);
	free(b->results);
}

/* ---- measurement ---- */

typedef struct Way {
	const char *name;
	void (*gather)(Bench *);
	double seconds[RUNS], sum;
} Way;

static int compare_seconds(const void *a, const void *b)
{
	double x = *(const double *)a, y = *(const double *)b;
	return (x > y) - (x < y);
}

/* Mean over the points, and how many photons are counted, as one number. */
static double check_sum(const Bench *b)
{
	double sum = 0;
	for (uint32_t i = 0; i < POINTS; i++)
		sum += b->results[i].radiance.r + b->results[i].photons;
	return sum / POINTS;
}

static int compare(uint32_t photons, Diag *diag)
{
	Way ways[] = {{.name = "50 nearest photons", .gather = gather_nearest_photons},
		      {.name = "tree of boxes", .gather = gather_by_tree},
		      {.name = "Embree's point queries", .gather = gather_by_embree},
		      {.name = "splatting, balls", .gather = splat_balls},
		      {.name = "splatting, boxes", .gather = splat_boxes}};
	enum { WAYS = sizeof ways / sizeof *ways };
	int wrong = 0;
	Bench b;
	PhotonMap *map = make_map(photons);
	prepare(&b, map, diag);
	for (int run = 0; run < RUNS; run++) {
		for (Way *way = ways; way < ways + WAYS; way++) {
			double start = clock_cpu();
			memset(b.results, 0, sizeof *b.results * POINTS);
			way->gather(&b);
			way->seconds[run] = clock_cpu() - start;
			way->sum = check_sum(&b);
		}
	}
	printf("%-24s %12s %10s\n", "", "us a point", "/ nearest");
	for (Way *way = ways; way < ways + WAYS; way++) {
		qsort(way->seconds, RUNS, sizeof(double), compare_seconds);
		printf("%-24s %12.2f %10.2f\n", way->name, 1e6 / POINTS * way->seconds[RUNS / 2],
		       way->seconds[RUNS / 2] / ways->seconds[RUNS / 2]);
		if (way > ways && !(fabs(way->sum - ways[1].sum) <= 1e-6 * ways[1].sum)) {
			printf("  differs: %.9g, not %.9g\n", way->sum, ways[1].sum);
			wrong++;
		}
	}
	dismiss(&b);
	photon_map_destroy(map);
	return wrong;
}

int main(int argc, char **argv)
{
	Diag *diag = diag_create(NULL);
	int wrong = 0;
	for (int i = 1; i < argc; i++)
		wrong += compare((uint32_t)atol(argv[i]), diag);
	if (argc < 2)
		wrong = compare(60000, diag) + compare(600000, diag);
	diag_destroy(diag);
	return wrong != 0;
}
