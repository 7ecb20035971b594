/*
 * Three ways to ask shapes for a ray, chosen by what a scene holds: a plain loop with a box test
 * when there are few bounded shapes (starting Embree would cost more than it saves), an Embree
 * scene for many, and a list for the unbounded.
 *
 * Embree works in single precision, but only to find candidates: boxes are padded by the rounding
 * that can happen, a ray is started where it enters the scene's box so that a far eye costs no
 * bits, and every crossing is computed in double precision from the ray carried in the context.
 */
#include "scene/accel.h"

#include <embree3/rtcore.h>
#include <float.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/arena.h"
#include "base/parallel.h"
#include "geom/csg.h"
#include "geom/mesh.h"
#include "geom/plain.h"
#include "geom/ray_box.h"

enum {
	LOOP_SHAPES = 6, /* so many bounded shapes are asked one by one; measured: Embree wins from
			    7 on */
	PARALLEL_BUILD =
		20000, /* primitives from which a build in parallel pays for starting threads */
};

struct Accel {
	const Shape **direct; /* asked without a look at their boxes: the unbounded ones, and
				 without Embree those that are as quick as their boxes */
	int direct_count;
	PlainShapes plain; /* the first of these, of which the class alone says all */
	bool all_plain;  /* there are no others at all */
	const Shape **bounded; /* the others but for the meshes that Embree has as triangles */
	int bounded_count;
	const Shape *
		*meshes; /* geometry number i + 1 of the Embree scene, 0 are the bounded ones */
	int mesh_count;
	Box3 box;              /* of bounded and meshes */
	double pad;            /* what single precision can be off by */
	RTCDevice device;
	RTCScene scene;        /* NULL: the loop */
};

/* What travels with a ray through Embree. */
typedef struct Query {
	struct RTCIntersectContext embree; /* first: Embree's callbacks get a pointer to it */
	const Accel *accel;
	Ray ray;        /* tmax shrinks to the nearest crossing found */
	Vec3 inverse;   /* of its direction; set before boxes are asked */
	double start;   /* parameter of the double ray where Embree's begins */
	AccelFilter *filter;
	void *data;
	Hit *best;      /* filled in when found */
	bool found;
	bool any;       /* any crossing the filter says yes to ends the search */
} Query;

/* ---- one shape ---- */

static void query_set_inverse(Query *query)
{
	Vec3 d = query->ray.direction;
	query->inverse = vec3(1 / d.x, 1 / d.y, 1 / d.z);
}

/* The parameter range in which the ray is inside the box, cut with its own; false when empty. */
static bool box_range(const Query *query, const Box3 *box, double range[2])
{
	Vec3 o = query->ray.origin;
	range[0] = query->ray.tmin;
	range[1] = query->ray.tmax;
	ray_slabs_clip(box->lo.x, box->hi.x, o.x, query->inverse.x, range);
	ray_slabs_clip(box->lo.y, box->hi.y, o.y, query->inverse.y, range);
	ray_slabs_clip(box->lo.z, box->hi.z, o.z, query->inverse.z, range);
	return range[0] <= range[1];
}

static void query_take(Query *query, const Hit *hit)
{
	*query->best = *hit;
	query->ray.tmax = hit->t;
	query->found = true;
}

/* Asks the filter for the crossings behind the one it refused. */
static bool query_rest(Query *query, const Shape *shape, double after)
{
	Ray ray = query->ray;
	ray.tmin = after +
		   1e-10 * fmax(1,
				fabs(after)); /* beyond the refused one, however it was rounded */
	HitList list;
	hit_list_init(&list);
	shape_intersect(shape, &ray, &list);
	hit_list_sort(&list);
	bool accepted = false;
	for (int i = 0; i < list.count && !accepted; i++) {
		accepted = query->filter(query->data, &query->ray, &list.hits[i]);
		if (accepted)
			query_take(query, &list.hits[i]);
	}
	hit_list_free(&list);
	return accepted;
}

/* True when the shape gave a crossing that counts. */
static bool query_shape(Query *query, const Shape *shape)
{
	Hit hit;
	if (!shape_nearest(shape, &query->ray, &hit))
		return false;
	if (query->filter && !query->filter(query->data, &query->ray, &hit))
		return query_rest(query, shape, hit.t);
	query_take(query, &hit);
	return true;
}

/* Asks shapes one by one; true when any crossing is enough and one was found. */
static bool query_direct(Query *query)
{
	const Accel *accel = query->accel;
	if (!query->filter && plain_nearest(&accel->plain, &query->ray, query->best)) {
		query->ray.tmax = query->best->t;
		query->found = true;
	}
	for (int i = query->filter ? 0 : accel->plain.count; i < accel->direct_count; i++)
		if (query_shape(query, accel->direct[i]) && query->any)
			return true;
	return query->any && query->found;
}

static void query_bounded(Query *query)
{
	const Accel *accel = query->accel;
	double range[2];
	query_set_inverse(query);
	for (int i = 0; i < accel->bounded_count; i++)
		if (box_range(query, &accel->bounded[i]->box, range) &&
		    query_shape(query, accel->bounded[i]) && query->any)
			return;
}

/* ---- Embree's side ---- */

static void bound_shape(const struct RTCBoundsFunctionArguments *args)
{
	const Accel *accel = args->geometryUserPtr;
	const Box3 *box = &accel->bounded[args->primID]->box;
	args->bounds_o->lower_x = (float)(box->lo.x - accel->pad);
	args->bounds_o->lower_y = (float)(box->lo.y - accel->pad);
	args->bounds_o->lower_z = (float)(box->lo.z - accel->pad);
	args->bounds_o->upper_x = (float)(box->hi.x + accel->pad);
	args->bounds_o->upper_y = (float)(box->hi.y + accel->pad);
	args->bounds_o->upper_z = (float)(box->hi.z + accel->pad);
}

/* The end of Embree's ray for a crossing at t: a little beyond, so that nothing nearer is lost to
 * rounding. */
static float embree_end(const Query *query, double t)
{
	double length = t - query->start;
	return length < FLT_MAX ? (float)(length * (1 + 1e-6) + query->accel->pad) : FLT_MAX;
}

/* Embree's ray may end before the query's, at a triangle of which the query does not know yet. */
static void intersect_shape(const struct RTCIntersectFunctionNArguments *args)
{
	Query *query = (Query *)args->context;
	const Shape *shape = query->accel->bounded[args->primID];
	struct RTCRayHit *rayhit = (struct RTCRayHit *)args->rayhit;
	double range[2], end = query->ray.tmax;
	query->ray.tmax = real_min(end, query->start + rayhit->ray.tfar);
	bool found = args->valid[0] && box_range(query, &shape->box, range) &&
		     query_shape(query, shape);
	if (!found) {
		query->ray.tmax = end;
		return;
	}
	rayhit->ray.tfar = query->any ? -INFINITY : embree_end(query, query->best->t);
	rayhit->hit.geomID = 0;
	rayhit->hit.primID = args->primID;
}

static void occluded_shape(const struct RTCOccludedFunctionNArguments *args)
{
	Query *query = (Query *)args->context;
	const Shape *shape = query->accel->bounded[args->primID];
	double range[2];
	if (!args->valid[0] || !box_range(query, &shape->box, range) ||
	    !query_shape(query, shape))
		return;
	((struct RTCRay *)args->ray)->tfar = -INFINITY;
}

/* The crossing of the query's ray with a triangle, in double precision and world terms. */
static bool triangle_hit(const Query *query, const Shape *shape, unsigned triangle, Hit *hit)
{
	Ray ray = query->ray;
	if (shape->transform) {
		ray.origin = transform_point_inverse(shape->transform, ray.origin);
		ray.direction = transform_vector_inverse(shape->transform, ray.direction);
	}
	if (!mesh_hit_triangle(shape->data, (int)triangle, &ray, hit))
		return false;
	hit->shape = shape;
	return hit->t > query->ray.tmin && hit->t < query->ray.tmax;
}

/* Embree's filter, called for every triangle that it thinks is hit. */
static void filter_triangle(const struct RTCFilterFunctionNArguments *args)
{
	Query *query = (Query *)args->context;
	const struct RTCHit *candidate = (const struct RTCHit *)args->hit;
	Hit hit;
	bool counts = triangle_hit(query, query->accel->meshes[candidate->geomID - 1],
				   candidate->primID, &hit) &&
		      (!query->filter || query->filter(query->data, &query->ray, &hit));
	if (counts)
		query_take(query, &hit);
	else
		args->valid[0] = 0;
}

/* In place: a ray that is made field by field and then copied waits for its own stores. */
static void set_embree_ray(Query *query, const double range[2], struct RTCRay *out)
{
	const Ray *ray = &query->ray;
	query->start = range[0];
	Vec3 origin = ray_at(ray, range[0]);
	out->org_x = (float)origin.x;
	out->org_y = (float)origin.y;
	out->org_z = (float)origin.z;
	out->dir_x = (float)ray->direction.x;
	out->dir_y = (float)ray->direction.y;
	out->dir_z = (float)ray->direction.z;
	out->tnear = 0;
	out->tfar = embree_end(query, range[1]);
	out->time = 0;
	out->mask = UINT32_MAX;
	out->id = out->flags = 0;
}

/* Embree leaves out what is larger, and aborts on NaN. */
static const double EMBREE_LARGEST = 1e18;

/* False for a ray from or to nowhere, such as a camera that looks at infinity has: it hits nothing.
 */
static bool embree_takes(const struct RTCRay *ray)
{
	return fabsf(ray->org_x) + fabsf(ray->org_y) + fabsf(ray->org_z) < EMBREE_LARGEST &&
	       fabsf(ray->dir_x) + fabsf(ray->dir_y) + fabsf(ray->dir_z) < EMBREE_LARGEST;
}

/* Embree's nearest crossing. Without a filter of its own the query asks no triangle on the way but
 * the one that Embree ends with; false when double precision then disagrees. */
static bool query_nearest(Query *query, const double range[2], bool ask_each)
{
	struct RTCRayHit rayhit;
	Hit hit;
	set_embree_ray(query, range, &rayhit.ray);
	if (!embree_takes(&rayhit.ray))
		return true;
	rayhit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
	rayhit.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
	query->embree.filter = ask_each ? filter_triangle : NULL;
	rtcIntersect1(query->accel->scene, &query->embree, &rayhit);
	unsigned geometry = rayhit.hit.geomID;
	if (ask_each || geometry == RTC_INVALID_GEOMETRY_ID || geometry == 0)
		return true;
	if (!triangle_hit(query, query->accel->meshes[geometry - 1], rayhit.hit.primID, &hit))
		return false;
	query_take(query, &hit);
	return true;
}

static void query_any(Query *query, const double range[2])
{
	struct RTCRay ray;
	set_embree_ray(query, range, &ray);
	if (!embree_takes(&ray))
		return;
	query->embree.filter = filter_triangle;
	rtcOccluded1(query->accel->scene, &query->embree, &ray);
}

static void query_embree(Query *query)
{
	double range[2];
	query_set_inverse(query);
	if (!box_range(query, &query->accel->box, range))
		return;
	rtcInitIntersectContext(&query->embree);
	if (query->any)
		query_any(query, range);
	else if (query->filter || !query_nearest(query, range, false))
		query_nearest(query, range, true);
}

static bool query_run(Query *query)
{
	if (query_direct(query))
		return true;
	if (query->accel->scene)
		query_embree(query);
	else if (query->accel->bounded_count)
		query_bounded(query);
	return query->found;
}

/* ---- building ---- */

static void attach_shapes(Accel *accel)
{
	RTCGeometry geometry = rtcNewGeometry(accel->device, RTC_GEOMETRY_TYPE_USER);
	rtcSetGeometryUserPrimitiveCount(geometry, (unsigned)accel->bounded_count);
	rtcSetGeometryUserData(geometry, accel);
	rtcSetGeometryBoundsFunction(geometry, bound_shape, NULL);
	rtcSetGeometryIntersectFunction(geometry, intersect_shape);
	rtcSetGeometryOccludedFunction(geometry, occluded_shape);
	rtcCommitGeometry(geometry);
	rtcAttachGeometryByID(accel->scene, geometry, 0);
	rtcReleaseGeometry(geometry);
}

static void copy_vertices(const Shape *shape, const Mesh *mesh, float *out)
{
	for (int i = 0; i < mesh->desc.vertex_count; i++) {
		Vec3 p = vec3_of_floats(mesh->desc.vertices[i]);
		if (shape->transform)
			p = transform_point(shape->transform, p);
		vec3_to_floats(p, out + 3 * i);
	}
}

static void attach_mesh(Accel *accel, const Shape *shape, unsigned id)
{
	const Mesh *mesh = shape->data;
	RTCGeometry geometry = rtcNewGeometry(accel->device, RTC_GEOMETRY_TYPE_TRIANGLE);
	float *vertices = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0,
						  RTC_FORMAT_FLOAT3, 3 * sizeof(float),
						  (size_t)mesh->desc.vertex_count);
	copy_vertices(shape, mesh, vertices);
	unsigned *indices = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0,
						    RTC_FORMAT_UINT3, 3 * sizeof(unsigned),
						    (size_t)mesh->desc.triangle_count);
	for (int i = 0; i < mesh->desc.triangle_count; i++)
		for (int k = 0; k < 3; k++)
			indices[3 * i + k] = (unsigned)mesh->desc.triangles[i][k];
	rtcCommitGeometry(geometry);
	rtcAttachGeometryByID(accel->scene, geometry, id);
	rtcReleaseGeometry(geometry);
}

static void build_embree(Accel *accel, long primitives)
{
	char config[64];
	int threads = primitives < PARALLEL_BUILD ? 1 : parallel_threads();
	snprintf(config, sizeof config, "threads=%d", threads);
	accel->device = rtcNewDevice(config);
	accel->scene = rtcNewScene(accel->device);
	rtcSetSceneFlags(accel->scene,
			 RTC_SCENE_FLAG_ROBUST | RTC_SCENE_FLAG_CONTEXT_FILTER_FUNCTION);
	if (accel->bounded_count)
		attach_shapes(accel);
	for (int i = 0; i < accel->mesh_count; i++)
		attach_mesh(accel, accel->meshes[i], (unsigned)i + 1);
	rtcCommitScene(accel->scene);
}

/* Meshes go to Embree as triangles when nothing is cut away from them. */
static bool is_plain_mesh(const Shape *shape)
{
	return shape->class == &mesh_class && !shape->clip_count && !shape->bound_count;
}

static bool is_within_embree(const Shape *shape)
{
	Vec3 far = vec3_max(shape->box.hi, vec3_neg(shape->box.lo));
	return fmax(far.x, fmax(far.y, far.z)) < 0.1 * EMBREE_LARGEST;
}

static long sort_shapes(Accel *accel, const Shape *const *shapes, int count)
{
	long primitives = 0;
	for (int i = 0; i < count; i++) {
		const Shape *shape = shapes[i];
		if (box3_is_empty(shape->box))
			continue;
		if (!shape_is_bounded(shape) || !is_within_embree(shape)) {
			accel->direct[accel->direct_count++] = shape;
			continue;
		}
		accel->box = box3_union(accel->box, shape->box);
		if (is_plain_mesh(shape)) {
			accel->meshes[accel->mesh_count++] = shape;
			primitives += ((const Mesh *)shape->data)->desc.triangle_count;
		} else {
			accel->bounded[accel->bounded_count++] = shape;
			primitives++;
		}
	}
	return primitives;
}

static void pad_box(Accel *accel)
{
	Vec3 size = vec3_max(vec3_max(accel->box.hi, vec3_neg(accel->box.lo)),
			     vec3_sub(accel->box.hi, accel->box.lo));
	accel->pad = 4 * (double)FLT_EPSILON * fmax(size.x, fmax(size.y, size.z));
	accel->box.lo = vec3_sub(accel->box.lo, vec3_all(accel->pad));
	accel->box.hi = vec3_add(accel->box.hi, vec3_all(accel->pad));
}

/* Without Embree. */
static void take_quick_ones(Accel *accel)
{
	int kept = 0;
	for (int i = 0; i < accel->bounded_count; i++) {
		const Shape *shape = accel->bounded[i];
		if (shape->class->quick && !shape->clip_count)
			accel->direct[accel->direct_count++] = shape;
		else
			accel->bounded[kept++] = shape;
	}
	accel->bounded_count = kept;
}

enum { SPHERES, PLANES, OTHERS, PLAIN_KINDS };

/* PLAIN_KINDS for what is not plain. */
static int plain_kind(const Shape *shape)
{
	if (!shape->class->quick || shape->transform || shape->clip_count || shape->bound_count)
		return PLAIN_KINDS;
	return shape->class == &sphere_class  ? SPHERES
	       : shape->class == &plane_class ? PLANES
					      : OTHERS;
}

/* To the front, kind by kind; each kind, and the others, stay in their order. */
static void put_plain_ones_first(Accel *accel)
{
	const Shape **sorted =
		memory_alloc(sizeof *sorted * ((size_t)accel->direct_count + 1));
	int ends[PLAIN_KINDS + 1], end = 0;
	for (int kind = 0; kind <= PLAIN_KINDS; kind++) {
		for (int i = 0; i < accel->direct_count; i++)
			if (plain_kind(accel->direct[i]) == kind)
				sorted[end++] = accel->direct[i];
		ends[kind] = end;
	}
	free(accel->direct);
	accel->direct = sorted;
	accel->plain = (PlainShapes){sorted, ends[SPHERES], ends[PLANES], ends[OTHERS]};
}

Accel *accel_create(const Shape *const *shapes, int count)
{
	Accel *accel = memory_alloc(sizeof *accel);
	size_t bytes = sizeof(Shape *) * (size_t)(count > 0 ? count : 1);
	*accel = (Accel){
		.direct = memory_alloc(bytes),
		.bounded = memory_alloc(bytes),
		.meshes = memory_alloc(bytes),
		.box = box3_empty(),
	};
	long primitives = sort_shapes(accel, shapes, count);
	if (primitives)
		pad_box(accel);
	if (accel->mesh_count || accel->bounded_count > LOOP_SHAPES)
		build_embree(accel, primitives);
	else
		take_quick_ones(accel);
	put_plain_ones_first(accel);
	accel->all_plain = !accel->scene && !accel->bounded_count &&
			   accel->plain.count == accel->direct_count;
	return accel;
}

void accel_destroy(Accel *accel)
{
	if (!accel)
		return;
	if (accel->scene)
		rtcReleaseScene(accel->scene);
	if (accel->device)
		rtcReleaseDevice(accel->device);
	free(accel->direct);
	free(accel->bounded);
	free(accel->meshes);
	free(accel);
}

/* ---- questions ---- */

bool accel_nearest(const Accel *accel, const Ray *ray, AccelFilter *accept, void *data, Hit *out)
{
	if (accel->all_plain && !accept)
		return plain_nearest(&accel->plain, ray, out);
	Query query = {.accel = accel, .ray = *ray, .filter = accept, .data = data, .best = out};
	return query_run(&query);
}

bool accel_any(const Accel *accel, const Ray *ray, AccelFilter *visit, void *data)
{
	Hit hit;
	Query query = {.accel = accel,
		       .ray = *ray,
		       .filter = visit,
		       .data = data,
		       .best = &hit,
		       .any = true};
	return query_run(&query);
}

/* The primitive that speaks for a shape at a point inside: of a union the part that holds the
 * point. */
static const Shape *speaking_primitive(const Shape *shape, Vec3 p)
{
	while (shape->class == &csg_union_class || shape->class == &csg_merge_class ||
	       shape->class == &csg_intersection_class) {
		const Csg *csg = shape->data;
		int i = 0;
		if (shape->class != &csg_intersection_class)
			while (i + 1 < csg->count && !shape_inside(csg->children[i], p))
				i++;
		shape = csg->children[i];
	}
	return shape;
}

static int collect_containing(const Shape *const *shapes, int count, Vec3 p, const Shape **out,
			      int max)
{
	int found = 0;
	for (int i = 0; i < count && found < max; i++)
		if (box3_contains(shapes[i]->box, p) && shape_inside(shapes[i], p))
			out[found++] = speaking_primitive(shapes[i], p);
	return found;
}

int accel_containing(const Accel *accel, Vec3 p, const Shape **out, int max)
{
	int found = collect_containing(accel->direct, accel->direct_count, p, out, max);
	if (!box3_contains(accel->box, p))
		return found;
	found += collect_containing(accel->bounded, accel->bounded_count, p, out + found,
				    max - found);
	return found +
	       collect_containing(accel->meshes, accel->mesh_count, p, out + found, max - found);
}
