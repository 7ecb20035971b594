/*
 * Two ways to find the patches that a pixel meets, with the same patches and the same sums: the
 * product's tree of boxes, and Embree's point queries over the same boxes as user geometry. Gather
 * points are 320 x 320 over the wave's caustic (wave.h), row by row as pixels are. Takes turns, one
 * thread; prints medians of five turns of processor time, microseconds a gather point, and the
 * ratio to 50 nearest photons, at most 2 being asked.
 *
 *   footprint_lookup [photons ...]
 */
#include "density/footprint.c" /* for the patches themselves */

#include <embree3/rtcore.h>
#include <stdio.h>

#include "base/clock.h"
#include "tests/bench/known_map.h"
#include "tests/bench/wave.h"

enum { SIDE = 320, POINTS = SIDE * SIDE, RUNS = 5 };

static void wave_way(double u, double v, double to[2]) { wave_map(&wave_detailed, u, v, to); }

static PhotonMap *make_map(uint32_t count)
{
	double side = wave_side(&wave_detailed);
	return known_map_make(&(KnownMap){wave_way, -wave_detailed.margin, side}, count, 0);
}

/* ---- what is compared ---- */

typedef struct Bench {
	const PhotonMap *map;
	FootprintMap *footprints;
	DensityEstimator *nearest;
	GatherPoint *points;
	GatherTask *tasks;
	RTCDevice device;
	RTCScene scene;
	Box3 *boxes; /* of the patches */
	GatherResult *results;
} Bench;

static void gather_nearest_photons(Bench *b)
{
	for (uint32_t i = 0; i < POINTS; i++)
		estimator_gather(b->nearest, &b->points[i], known_map_white, NULL, &b->results[i]);
}

static void gather_by_tree(Bench *b)
{
	for (uint32_t i = 0; i < POINTS; i++)
		footprint_gather(b->footprints, &b->tasks[i], &b->results[i]);
}

static bool embree_visit(struct RTCPointQueryFunctionArguments *a)
{
	add_patch(a->userPtr, a->primID);
	return false; /* the radius stays */
}

/* No photon of this map is left to a disc but a few at the border. */
static void gather_by_embree(Bench *b)
{
	struct RTCPointQueryContext context;
	rtcInitPointQueryContext(&context);
	for (uint32_t i = 0; i < POINTS; i++) {
		Vec3 p = b->points[i].position;
		Gathering g = begin(b->footprints, &b->tasks[i]);
		struct RTCPointQuery query = {(float)p.x, (float)p.y, (float)p.z, 0,
					      (float)vec3_length(g.window.reach)};
		Vec3 reach = vec3_all(sqrt(g.window.area / 2));
		rtcPointQuery(b->scene, &query, &context, embree_visit, &g);
		footprint_tree_visit(&b->footprints->disc_tree, box_around(p, reach), add_discs,
				     &g);
		gather_finish(&g.sum, 0, &b->results[i]);
	}
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
	rtcSetGeometryUserPrimitiveCount(geometry, b->footprints->patch_count);
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
	b->results = calloc(POINTS, sizeof *b->results);
	for (uint32_t i = 0; i < POINTS; i++) {
		Vec3 at = vec3((i % SIDE + 0.5) / SIDE, 0, ((double)(i / SIDE) + 0.5) / SIDE);
		b->points[i] = (GatherPoint){
			.position = at, .normal = vec3(0, 1, 0), .footprint = 1.0 / SIDE};
		b->tasks[i] = (GatherTask){b->map, &b->points[i], known_map_white, NULL};
	}
}

static void prepare(Bench *b, const PhotonMap *map, Diag *diag)
{
	PhotonSettings settings = photon_settings_default();
	Estimator nearest = {
		.kind = ESTIMATOR_NEAREST, .kernel = KERNEL_EPANECHNIKOV, .count = 50};
	Estimator footprint = {.kind = ESTIMATOR_FOOTPRINT};
	EstimatorSetup setup = {&nearest, &settings, map, 0, NULL};
	*b = (Bench){.map = map, .nearest = estimator_create(&setup, diag)};
	setup.method = &footprint;
	b->footprints = footprint_create(&setup, diag);
	b->boxes = malloc(sizeof *b->boxes * b->footprints->patch_count);
	for (uint32_t i = 0; i < b->footprints->patch_count; i++) {
		const Patch *patch = &b->footprints->patches[i];
		b->boxes[i] = footprint_patch_box(patch, normal_of(map, patch->photon));
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
		      {.name = "Embree's point queries", .gather = gather_by_embree}};
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
