/*
 * The function's values along the ray, inside the container. From a place where the value is a the
 * surface is at least |a| / max_gradient away. So of an interval between two samples a piece at
 * either end is ruled out, all of it when both have the same sign and the pieces meet; what is left
 * is looked at in its middle, until it is shorter than the accuracy, and then a change of sign is a
 * crossing. With a max_gradient that is too small some crossings get lost, as the language defines.
 * The crossing itself is refined within its last interval.
 */
#include "geom/isosurface.h"

#include "geom/secant.h"

typedef struct Isosurface {
	IsosurfaceDesc desc;
	double gradient;
} Isosurface;

enum { PART_FUNCTION = -1, STACK_DEPTH = 64 };

IsosurfaceDesc isosurface_default(void)
{
	return (IsosurfaceDesc){
		.container = container_default(),
		.accuracy = 0.001,
		.max_gradient = 1.1,
		.max_trace = 1,
	};
}

/* POV-Ray lets the gradient of `evaluate` grow from its first parameter, by the second, as it
 * meets steeper places; the manual's recipe makes first * second^2 the steepest one. */
static double effective_gradient(const IsosurfaceDesc *desc)
{
	const double *p = desc->evaluate_parameters;
	return desc->evaluate ? p[0] * p[1] * p[1] : desc->max_gradient;
}

const void *isosurface_create(Arena *arena, const IsosurfaceDesc *desc)
{
	Isosurface *isosurface = ARENA_NEW(arena, Isosurface);
	isosurface->desc = *desc;
	isosurface->gradient = effective_gradient(desc);
	IsosurfaceDesc usual = isosurface_default();
	if (!(desc->accuracy > 0))
		isosurface->desc.accuracy = usual.accuracy;
	if (!(isosurface->gradient > 0))
		isosurface->gradient = usual.max_gradient;
	return isosurface;
}

static bool isosurface_bounds(const void *data, Box3 *box)
{
	*box = container_bounds(&((const Isosurface *)data)->desc.container);
	return true;
}

static double value_at(const Isosurface *isosurface, Vec3 p)
{
	return isosurface->desc.value(isosurface->desc.function, p) - isosurface->desc.threshold;
}

typedef struct Line {
	const Isosurface *isosurface;
	const Ray *ray;
} Line;

/* A function that is not a number nowhere encloses anything. */
static double value_along(const void *data, double t)
{
	const Line *line = data;
	double value = value_at(line->isosurface, ray_at(line->ray, t));
	return isnan(value) ? INFINITY : value;
}

static SecantSample sample(const Line *line, double t)
{
	return (SecantSample){t, value_along(line, t)};
}

/* The crossing between two samples of different sign. */
static double refine(const Line *line, SecantSample a, SecantSample b)
{
	return secant_root(value_along, line, a, b, 1e-9 * fabs(b.t - a.t) + 1e-15 * fabs(a.t));
}

/* What two samples leave open: the surface is farther from each than its value over the steepest
 * gradient. Not `from` < `to` when that leaves nothing. */
typedef struct Gap {
	double from, to;
} Gap;

static Gap gap_between(SecantSample from, SecantSample to, double gradient)
{
	return (Gap){from.t + fabs(from.value) / gradient, to.t - fabs(to.value) / gradient};
}

/* Where to look next. A gap that is closed though the signs differ shows that the gradient was too
 * small. */
static double next_place(const Gap *gap, SecantSample from, SecantSample to)
{
	return gap->from < gap->to ? 0.5 * (gap->from + gap->to) : 0.5 * (from.t + to.t);
}

/* The first change of sign between two samples, as far as the gradient promises to find it. */
static bool first_root(const Line *line, SecantSample from, SecantSample to, double *t)
{
	const Isosurface *isosurface = line->isosurface;
	double speed = vec3_length(line->ray->direction);
	double shortest = isosurface->desc.accuracy / speed;
	double gradient = isosurface->gradient * speed;
	SecantSample stack[STACK_DEPTH];
	int depth = 0;
	stack[depth++] = to;
	while (depth) {
		SecantSample end = stack[depth - 1];
		Gap gap = gap_between(from, end, gradient);
		bool differ = (from.value > 0) != (end.value > 0);
		double open = gap.to - gap.from, length = differ ? end.t - from.t : open;
		if (length >= shortest && depth < STACK_DEPTH) {
			stack[depth++] = sample(line, next_place(&gap, from, end));
		} else if (differ) {
			*t = refine(line, from, end);
			return true;
		} else {
			from = end;
			depth--;
		}
	}
	return false;
}

/* The part of the ray inside the container, as samples. False when it misses. */
typedef struct Span {
	SecantSample from, to;
	bool enters, leaves; /* from, to lie on the container's surface */
	int faces[2];
} Span;

static bool find_span(const Line *line, Span *span)
{
	const Ray *ray = line->ray;
	double t[2];
	if (!container_cross(&line->isosurface->desc.container, ray, t, span->faces))
		return false;
	span->enters = t[0] > ray->tmin;
	span->leaves = t[1] < ray->tmax;
	double from = fmax(t[0], ray->tmin), to = fmin(t[1], ray->tmax);
	if (!(from < to))
		return false;
	span->from = sample(line, from);
	span->to = sample(line, to);
	return true;
}

/* Crossings in rising order, at most `most`. */
static void isosurface_cross(const Shape *self, const Ray *ray, int most, HitList *out)
{
	const Isosurface *isosurface = self->data;
	bool closed = !isosurface->desc.open;
	Span span;
	const Line line = {isosurface, ray};
	if (!find_span(&line, &span))
		return;
	double skip = 5 * isosurface->desc.accuracy / vec3_length(ray->direction), t;
	int count = 0;
	if (closed && span.enters && span.from.value < 0) {
		hit_list_push(out, (Hit){.t = span.from.t, .shape = self, .part = span.faces[0]});
		count++;
	}
	while (count < most && first_root(&line, span.from, span.to, &t)) {
		hit_list_add(out, ray, self, t, PART_FUNCTION);
		count++;
		if (t + skip >= span.to.t)
			break;
		span.from = sample(&line, t + skip);
	}
	if (closed && count < most && span.leaves && span.to.value < 0)
		hit_list_push(out, (Hit){.t = span.to.t, .shape = self, .part = span.faces[1]});
}

static void isosurface_intersect(const Shape *self, const Ray *ray, HitList *out)
{
	const Isosurface *isosurface = self->data;
	isosurface_cross(self, ray,
			 isosurface->desc.max_trace > 0 ? isosurface->desc.max_trace : 1 << 20,
			 out);
}

static bool isosurface_nearest(const Shape *self, const Ray *ray, Hit *out)
{
	return hit_nearest_by(isosurface_cross, self, ray, out);
}

static bool isosurface_inside(const void *data, Vec3 p)
{
	const Isosurface *isosurface = data;
	return container_inside(&isosurface->desc.container, p) && value_at(isosurface, p) < 0;
}

/* The gradient by differences over the accuracy. */
static Vec3 isosurface_normal(const void *data, const Hit *hit, Vec3 p)
{
	const Isosurface *isosurface = data;
	if (hit->part != PART_FUNCTION)
		return container_normal(&isosurface->desc.container, hit->part, p);
	double step = isosurface->desc.accuracy, value = value_at(isosurface, p);
	Vec3 n = vec3(value_at(isosurface, vec3(p.x + step, p.y, p.z)) - value,
	              value_at(isosurface, vec3(p.x, p.y + step, p.z)) - value,
	              value_at(isosurface, vec3(p.x, p.y, p.z + step)) - value);
	return vec3_length2(n) > 0 && vec3_is_finite(n) ? n : vec3(1, 0, 0);
}

const ShapeClass isosurface_class = {
	.name = "isosurface",
	.bounds = isosurface_bounds,
	.intersect = isosurface_intersect,
	.inside = isosurface_inside,
	.normal = isosurface_normal,
	.nearest = isosurface_nearest,
};
