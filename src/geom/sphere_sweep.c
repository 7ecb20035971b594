/*
 * On one segment the sphere's centre c(s) and radius r(s) are polynomials of degree 1 or 3, 0 <= s
 * <= 1. The ray is in the sphere of s from b(s) - sqrt(D(s)) to b(s) + sqrt(D(s)), where b is the
 * point of the ray nearest to c(s) and D > 0. Over an interval of s where D stays positive these
 * spans run into each other, so the ray is in the swept body from the least of the entries to the
 * greatest of the exits: at the interval's ends, or where the derivative vanishes, 4 D b'^2 = D'^2.
 */
#include "geom/sphere_sweep.h"

#include <stdlib.h>

#include "geom/box_tree.h"
#include "geom/polynomial.h"

enum { MAX_DEGREE = 3, INLINE_SPANS = 64 };

typedef struct SweepSegment {
	int degree;
	Vec3 center[MAX_DEGREE + 1]; /* coefficients of s^0 .. s^degree */
	double radius[MAX_DEGREE + 1];
} SweepSegment;

typedef struct SphereSweep {
	const SweepSegment *segments;
	int count;
	Box3 box;
	const BoxTree *tree;
} SphereSweep;

/* ---- making ---- */

/* Rows: what each of four neighbouring spheres gives to the coefficients of s^0 .. s^3. */
static const double CATMULL_ROM[4][4] = {
	{0, -0.5, 1, -0.5}, {1, 0, -2.5, 1.5}, {0, 0.5, 2, -1.5}, {0, 0, -0.5, 0.5}};
static const double B_SPLINE[4][4] = {{1 / 6.0, -0.5, 0.5, -1 / 6.0},
				      {4 / 6.0, 0, -1, 0.5},
				      {1 / 6.0, 0.5, 0.5, -0.5},
				      {0, 0, 0, 1 / 6.0}};

static SweepSegment linear_segment(const SphereSweepDesc *desc, int i)
{
	return (SweepSegment){
		.degree = 1,
		.center = {desc->centers[i], vec3_sub(desc->centers[i + 1], desc->centers[i])},
		.radius = {desc->radii[i], desc->radii[i + 1] - desc->radii[i]}};
}

static SweepSegment cubic_segment(const SphereSweepDesc *desc, int i, const double basis[4][4])
{
	SweepSegment segment = {.degree = 3};
	for (int k = 0; k < 4; k++) {
		for (int power = 0; power < 4; power++) {
			segment.center[power] = vec3_mad(segment.center[power], basis[k][power],
							 desc->centers[i + k]);
			segment.radius[power] += basis[k][power] * desc->radii[i + k];
		}
	}
	return segment;
}

/* Bezier control values of a coefficient list bound the polynomial on [0, 1]. */
static Box3 segment_box(const SweepSegment *segment)
{
	static const double powers[4][4] = {
		{1, 0, 0, 0}, {1, 1 / 3.0, 0, 0}, {1, 2 / 3.0, 1 / 3.0, 0}, {1, 1, 1, 1}};
	Box3 box = box3_empty();
	double radius = 0;
	for (int k = 0; k < 4; k++) {
		Vec3 control = vec3_all(0);
		double control_radius = 0;
		for (int power = 0; power < 4; power++) {
			control = vec3_mad(control, powers[k][power], segment->center[power]);
			control_radius += powers[k][power] * segment->radius[power];
		}
		box = box3_add(box, control);
		radius = fmax(radius, fabs(control_radius));
	}
	return (Box3){vec3_sub(box.lo, vec3_all(radius)), vec3_add(box.hi, vec3_all(radius))};
}

static SweepSegment make_segment(const SphereSweepDesc *desc, int i)
{
	if (desc->kind == SPHERE_SWEEP_LINEAR)
		return linear_segment(desc, i);
	return cubic_segment(desc, i, desc->kind == SPHERE_SWEEP_CUBIC ? CATMULL_ROM : B_SPLINE);
}

const void *sphere_sweep_create(Arena *arena, const SphereSweepDesc *desc, const char **error)
{
	bool linear = desc->kind == SPHERE_SWEEP_LINEAR;
	int count = desc->count - (linear ? 1 : 3);
	if (count < 1) {
		*error = linear ? "a linear sphere_sweep needs 2 spheres"
				: "this sphere_sweep needs 4 spheres";
		return NULL;
	}
	SphereSweep *sweep = ARENA_NEW(arena, SphereSweep);
	SweepSegment *segments = ARENA_ARRAY(arena, SweepSegment, count);
	Box3 *boxes = ARENA_ARRAY(arena, Box3, count);
	sweep->box = box3_empty();
	for (int i = 0; i < count; i++) {
		segments[i] = make_segment(desc, i);
		boxes[i] = segment_box(&segments[i]);
		sweep->box = box3_union(sweep->box, boxes[i]);
	}
	sweep->segments = segments;
	sweep->count = count;
	sweep->tree = box_tree_create(arena, boxes, count);
	return sweep;
}

static bool sphere_sweep_bounds(const void *data, Box3 *box)
{
	*box = ((const SphereSweep *)data)->box;
	return true;
}

static Vec3 segment_center(const SweepSegment *segment, double s)
{
	Vec3 center = segment->center[segment->degree];
	for (int i = segment->degree - 1; i >= 0; i--)
		center = vec3_mad(segment->center[i], s, center);
	return center;
}

/* ---- spans of a ray ---- */

typedef struct SweepSpan {
	Hit in, out; /* t, segment as part, s as u */
} SweepSpan;

typedef struct SpanList {
	const SphereSweep *sweep;
	const Ray *ray;
	SweepSpan *spans;
	int count, capacity;
	SweepSpan first[INLINE_SPANS];
} SpanList;

static void span_list_push(SpanList *list, const SweepSpan *span)
{
	if (list->count == list->capacity) {
		SweepSpan *larger = memory_alloc(2 * sizeof(SweepSpan) * (size_t)list->capacity);
		for (int i = 0; i < list->count; i++)
			larger[i] = list->spans[i];
		if (list->spans != list->first)
			free(list->spans);
		list->spans = larger;
		list->capacity *= 2;
	}
	list->spans[list->count++] = *span;
}

/* product += factor a b; degrees of a and b. */
static void add_product(double *product, double factor, const double *a, int a_degree,
			const double *b, int b_degree)
{
	for (int i = 0; i <= a_degree; i++)
		for (int k = 0; k <= b_degree; k++)
			product[i + k] += factor * a[i] * b[k];
}

static void differentiate(const double *c, int degree, double *out)
{
	for (int i = 0; i < degree; i++)
		out[i] = (i + 1) * c[i + 1];
}

/* b(s) and D(s) of one segment and ray; t counts from shift. */
typedef struct SegmentRay {
	int degree;
	double shift;
	double nearest[MAX_DEGREE + 1], left[2 * MAX_DEGREE + 1]; /* b, D */
	double left_slope[2 * MAX_DEGREE];                        /* D' */
	double critical[4 * MAX_DEGREE + 1]; /* 4 D b'^2 - D'^2, degree 4 degree - 2 */
} SegmentRay;

static void segment_ray_prepare(SegmentRay *out, const SweepSegment *segment, const Ray *ray)
{
	int n = segment->degree;
	double speed2 = vec3_length2(ray->direction);
	Vec3 middle = segment_center(segment, 0.5);
	*out = (SegmentRay){.degree = n};
	out->shift = vec3_dot(vec3_sub(middle, ray->origin), ray->direction) / speed2;
	Vec3 origin = ray_at(ray, out->shift);
	double x[4], y[4], z[4];
	for (int i = 0; i <= n; i++) {
		Vec3 c = i == 0 ? vec3_sub(segment->center[0], origin) : segment->center[i];
		x[i] = c.x, y[i] = c.y, z[i] = c.z;
		out->nearest[i] = vec3_dot(c, ray->direction) / speed2;
	}
	add_product(out->left, 1, out->nearest, n, out->nearest, n);
	add_product(out->left, -1 / speed2, x, n, x, n);
	add_product(out->left, -1 / speed2, y, n, y, n);
	add_product(out->left, -1 / speed2, z, n, z, n);
	add_product(out->left, 1 / speed2, segment->radius, n, segment->radius, n);
}

static void segment_ray_critical(SegmentRay *ray)
{
	int n = ray->degree;
	double slope[MAX_DEGREE], square[2 * MAX_DEGREE] = {0};
	differentiate(ray->nearest, n, slope);
	differentiate(ray->left, 2 * n, ray->left_slope);
	add_product(square, 1, slope, n - 1, slope, n - 1);
	add_product(ray->critical, 4, ray->left, 2 * n, square, 2 * n - 2);
	add_product(ray->critical, -1, ray->left_slope, 2 * n - 1, ray->left_slope, 2 * n - 1);
}

/* Widens the span by the sphere at s. */
static void span_take(SweepSpan *span, const SegmentRay *ray, double s)
{
	double b = polynomial_eval(ray->nearest, ray->degree, s);
	double half = sqrt(fmax(0, polynomial_eval(ray->left, 2 * ray->degree, s)));
	if (b - half < span->in.t) {
		span->in.t = b - half;
		span->in.u = s;
	}
	if (b + half > span->out.t) {
		span->out.t = b + half;
		span->out.u = s;
	}
}

static void span_take_roots(SweepSpan *span, const SegmentRay *ray, const double *c, int degree,
			    const double limits[2])
{
	double roots[4 * MAX_DEGREE];
	int count = polynomial_roots(c, degree, limits[0], limits[1], roots);
	for (int i = 0; i < count; i++)
		span_take(span, ray, roots[i]);
}

/* The ray's stay in the spheres of s from lo to hi, where D is positive. Where the sweep lies
 * square to the ray, b' is 0 and the critical polynomial has double roots only, which may not be
 * found: those of D' stand for them. */
static void add_span(SpanList *list, const SegmentRay *ray, int segment, const double limits[2])
{
	SweepSpan span = {.in = {.t = INFINITY, .part = segment},
			  .out = {.t = -INFINITY, .part = segment}};
	span_take(&span, ray, limits[0]);
	span_take(&span, ray, limits[1]);
	span_take_roots(&span, ray, ray->critical, 4 * ray->degree - 2, limits);
	span_take_roots(&span, ray, ray->left_slope, 2 * ray->degree - 1, limits);
	span.in.t += ray->shift;
	span.out.t += ray->shift;
	if (span.in.t < span.out.t)
		span_list_push(list, &span);
}

static bool visit_segment(void *data, int item)
{
	SpanList *list = data;
	SegmentRay ray;
	double ends[2 * MAX_DEGREE + 1], lo = 0;
	bool prepared = false;
	segment_ray_prepare(&ray, &list->sweep->segments[item], list->ray);
	int count = polynomial_roots(ray.left, 2 * ray.degree, 0, 1, ends);
	ends[count++] = 1;
	for (int i = 0; i < count; i++) {
		double limits[2] = {lo, ends[i]};
		lo = ends[i];
		if (!(polynomial_eval(ray.left, 2 * ray.degree, 0.5 * (limits[0] + limits[1])) > 0))
			continue;
		if (!prepared)
			segment_ray_critical(&ray);
		prepared = true;
		add_span(list, &ray, item, limits);
	}
	return false;
}

static int compare_spans(const void *a, const void *b)
{
	double left = ((const SweepSpan *)a)->in.t, right = ((const SweepSpan *)b)->in.t;
	return (left > right) - (left < right);
}

/* Joins spans that overlap; what is left begins and ends on the surface. */
static void add_joined(const SpanList *list, const Shape *self, HitList *out)
{
	for (int i = 0; i < list->count;) {
		SweepSpan span = list->spans[i++];
		for (; i < list->count && list->spans[i].in.t <= span.out.t; i++)
			if (list->spans[i].out.t > span.out.t)
				span.out = list->spans[i].out;
		span.in.shape = span.out.shape = self;
		if (span.in.t > list->ray->tmin && span.in.t < list->ray->tmax)
			hit_list_push(out, span.in);
		if (span.out.t > list->ray->tmin && span.out.t < list->ray->tmax)
			hit_list_push(out, span.out);
	}
}

static void sphere_sweep_intersect(const Shape *self, const Ray *ray, HitList *out)
{
	SpanList list;
	list.sweep = self->data;
	list.ray = ray;
	list.spans = list.first;
	list.count = 0;
	list.capacity = INLINE_SPANS;
	/* A span that begins before the ray's start may hide another's end: look at the whole
	 * line. */
	Ray line = {ray->origin, ray->direction, -INFINITY, INFINITY};
	RaySlabs slabs = ray_slabs(&line);
	box_tree_walk_ray(list.sweep->tree, &slabs, visit_segment, &list);
	qsort(list.spans, (size_t)list.count, sizeof(SweepSpan), compare_spans);
	add_joined(&list, self, out);
	if (list.spans != list.first)
		free(list.spans);
}

/* ---- points ---- */

typedef struct SweepPoint {
	const SphereSweep *sweep;
	Vec3 p;
} SweepPoint;

/* Whether |p - c(s)|^2 - r(s)^2 is negative for some s. */
static bool visit_inside(void *data, int item)
{
	const SweepPoint *query = data;
	const SweepSegment *segment = &query->sweep->segments[item];
	int n = segment->degree;
	double c[2 * MAX_DEGREE + 1] = {0}, roots[2 * MAX_DEGREE];
	double x[4], y[4], z[4];
	for (int i = 0; i <= n; i++) {
		Vec3 at = i == 0 ? vec3_sub(segment->center[0], query->p) : segment->center[i];
		x[i] = at.x, y[i] = at.y, z[i] = at.z;
	}
	add_product(c, 1, x, n, x, n);
	add_product(c, 1, y, n, y, n);
	add_product(c, 1, z, n, z, n);
	add_product(c, -1, segment->radius, n, segment->radius, n);
	return c[0] < 0 || polynomial_eval(c, 2 * n, 1) < 0 ||
	       polynomial_roots(c, 2 * n, 0, 1, roots) > 0;
}

static bool sphere_sweep_inside(const void *data, Vec3 p)
{
	SweepPoint query = {data, p};
	return box_tree_walk_point(query.sweep->tree, p, visit_inside, &query);
}

static Vec3 sphere_sweep_normal(const void *data, const Hit *hit, Vec3 p)
{
	const SphereSweep *sweep = data;
	return vec3_sub(p, segment_center(&sweep->segments[hit->part], hit->u));
}

const ShapeClass sphere_sweep_class = {
	.name = "sphere_sweep",
	.bounds = sphere_sweep_bounds,
	.intersect = sphere_sweep_intersect,
	.inside = sphere_sweep_inside,
	.normal = sphere_sweep_normal,
};
