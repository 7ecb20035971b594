/*
 * Photon paths beside their bare rays: every ray that the paths of a scene ask the accelerator for
 * is recorded, then asked again of rtcIntersect1, one by one, on an Embree scene of the same
 * triangles and nothing else. Prints both times a ray and their ratio: medians, processor time, one
 * thread.
 *
 *	photon_rays SCENE RUNS
 *
 * Linked with --wrap=accel_nearest: the tracer's calls come here first.
 */
#include <embree3/rtcore.h>
#include <stdio.h>
#include <stdlib.h>

#include "base/clock.h"
#include "base/parallel.h"
#include "geom/mesh.h"
#include "parser/reader.h"
#include "photon/trace.h"
#include "scene/accel.h"

enum { MOST_RUNS = 99 };

/* The wrapped call has no room for a pointer to this. */
static struct Recorder {
	Ray *rays;
	size_t count, capacity;
	bool on;
} recorder;

bool __real_accel_nearest(const Accel *accel, const Ray *ray, AccelFilter *accept, void *data,
			  Hit *out);
bool __wrap_accel_nearest(const Accel *accel, const Ray *ray, AccelFilter *accept, void *data,
			  Hit *out);

bool __wrap_accel_nearest(const Accel *accel, const Ray *ray, AccelFilter *accept, void *data,
			  Hit *out)
{
	if (recorder.on) {
		if (recorder.count == recorder.capacity) {
			recorder.capacity = recorder.capacity ? 2 * recorder.capacity : 1 << 16;
			recorder.rays = memory_resize(recorder.rays,
						      sizeof(Ray) * recorder.capacity);
		}
		recorder.rays[recorder.count++] = *ray;
	}
	return __real_accel_nearest(accel, ray, accept, data, out);
}

static Scene *read_scene(const char *path)
{
	Diag *diag = diag_create(stderr);
	SceneBuilder builder = {
		.arena = arena_create(), .diag = diag, .settings = settings_default()};
	builder.camera = camera_default(1);
	ReaderOptions options = {.path = path, .image_width = 4, .image_height = 4};
	return reader_read(&options, &builder, diag) ? scene_freeze(&builder) : NULL;
}

static void attach_triangles(RTCDevice device, RTCScene bare, const Shape *shape)
{
	const MeshDesc *mesh = &((const Mesh *)shape->data)->desc;
	RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
	float *vertices = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0,
						  RTC_FORMAT_FLOAT3, 3 * sizeof(float),
						  (size_t)mesh->vertex_count);
	for (int i = 0; i < mesh->vertex_count; i++) {
		const float *v = mesh->vertices[i];
		Vec3 p = vec3(v[0], v[1], v[2]);
		if (shape->transform)
			p = transform_point(shape->transform, p);
		vertices[3 * i] = (float)p.x;
		vertices[3 * i + 1] = (float)p.y;
		vertices[3 * i + 2] = (float)p.z;
	}
	unsigned *indices = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0,
						    RTC_FORMAT_UINT3, 3 * sizeof(unsigned),
						    (size_t)mesh->triangle_count);
	for (int i = 0; i < 3 * mesh->triangle_count; i++)
		indices[i] = (unsigned)mesh->triangles[i / 3][i % 3];
	rtcCommitGeometry(geometry);
	rtcAttachGeometry(bare, geometry);
	rtcReleaseGeometry(geometry);
}

static RTCScene make_bare(RTCDevice device, const Scene *scene)
{
	RTCScene bare = rtcNewScene(device);
	rtcSetSceneFlags(bare, RTC_SCENE_FLAG_ROBUST); /* as the accelerator's own */
	for (int i = 0; i < scene->shape_count; i++)
		if (scene->shapes[i]->class == &mesh_class)
			attach_triangles(device, bare, scene->shapes[i]);
	rtcCommitScene(bare);
	return bare;
}

/* Returns how many rays hit. */
static size_t replay(RTCScene bare)
{
	size_t hits = 0;
	for (size_t i = 0; i < recorder.count; i++) {
		const Ray *ray = &recorder.rays[i];
		struct RTCIntersectContext context;
		struct RTCRayHit rayhit = {.ray = {
			.org_x = (float)ray->origin.x,
			.org_y = (float)ray->origin.y,
			.org_z = (float)ray->origin.z,
			.dir_x = (float)ray->direction.x,
			.dir_y = (float)ray->direction.y,
			.dir_z = (float)ray->direction.z,
			.tnear = (float)ray->tmin,
			.tfar = INFINITY,
			.mask = UINT32_MAX,
		}};
		rtcInitIntersectContext(&context);
		rayhit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
		rtcIntersect1(bare, &context, &rayhit);
		hits += rayhit.hit.geomID != RTC_INVALID_GEOMETRY_ID;
	}
	return hits;
}

static int compare_numbers(const void *a, const void *b)
{
	double x = *(const double *)a, y = *(const double *)b;
	return (x > y) - (x < y);
}

static double median(double *numbers, int count)
{
	qsort(numbers, (size_t)count, sizeof *numbers, compare_numbers);
	return numbers[count / 2];
}

static void trace(const Scene *scene)
{
	PhotonTraceOptions options = {.seed = 1, .scale = 1};
	photon_map_destroy(photon_trace(scene, &options, NULL));
}

static void measure(const Scene *scene, RTCScene bare, int runs)
{
	double paths[MOST_RUNS], alone[MOST_RUNS];
	size_t hits = 0;
	recorder.on = true;
	trace(scene);
	recorder.on = false;
	for (int i = 0; i < runs; i++) {
		double start = clock_cpu();
		trace(scene);
		double between = clock_cpu();
		hits = replay(bare);
		paths[i] = between - start;
		alone[i] = clock_cpu() - between;
	}
	double all = median(paths, runs), one = median(alone, runs), rays = (double)recorder.count;
	printf("%zu rays of photon paths, %.0f%% meet triangles: %.0f ns a ray, "
	       "bare rtcIntersect1 %.0f ns, ratio %.2f (asked: <= 2)\n",
	       recorder.count, 100.0 * (double)hits / rays, 1e9 * all / rays, 1e9 * one / rays,
	       all / one);
}

int main(int count, char **arguments)
{
	int runs = count == 3 ? atoi(arguments[2]) : 0;
	if (runs < 1 || runs > MOST_RUNS) {
		fprintf(stderr, "usage: photon_rays SCENE RUNS (1..%d)\n", MOST_RUNS);
		return 1;
	}
	parallel_set_threads(1);
	Scene *scene = read_scene(arguments[1]);
	if (!scene)
		return 1;
	RTCDevice device = rtcNewDevice("threads=1");
	RTCScene bare = make_bare(device, scene);
	measure(scene, bare, runs);
	rtcReleaseScene(bare);
	rtcReleaseDevice(device);
	return 0;
}
