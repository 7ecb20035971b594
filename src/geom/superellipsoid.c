/*
 * The gauge g(p) = (rho^(2/n) + |z|^(2/n))^(n/2), rho = (|x|^(2/e) + |y|^(2/e))^(e/2), is 1 on the
 * surface and grows in proportion along lines from the origin. For exponents up to 2 it is a norm,
 * hence convex along any line, and Newton's iteration from either side of the box around walks up
 * to the surface without ever passing it. Pinched shapes (an exponent above 2) are searched by
 * sampling between the planes where the gauge has kinks.
 */
#include "geom/superellipsoid.h"

#include <limits.h>

#include "geom/box.h"
#include "geom/secant.h"

enum { NEWTON_STEPS = 60, PINCHED_SAMPLES = 10, KINK_PLANES = 5 };

/* Of a pair's norm: the exponents around its own for which it needs no power; it is at most `up`
 * times the norm with the lower, and at least `down` times that with the higher one. */
typedef struct PairBounds {
	int below, above;
	double up, down;
} PairBounds;

typedef struct Superellipsoid {
	double e, n;
	PairBounds across, both;
	bool convex;
} Superellipsoid;

/* Smaller exponents differ from a box by less than can be seen. */
static const double LEAST_EXPONENT = 1e-4;

/* What the rounding of a norm may be. */
static const double RANGE_ROUNDING = 1e-12;

static PairBounds bounds_of(double exponent)
{
	static const int easy[] = {4, 2, 1, 0};
	int i = 0;
	while (easy[i] > exponent)
		i++;
	PairBounds bounds = {.below = easy[i], .up = exp2(0.5 * (exponent - easy[i]))};
	bounds.above = i > 0 ? easy[i - 1] : INT_MAX;
	bounds.down = i > 0 ? exp2(0.5 * (exponent - bounds.above)) : 0;
	return bounds;
}

const void *superellipsoid_create(Arena *arena, double e, double n)
{
	e = fmax(LEAST_EXPONENT, e);
	n = fmax(LEAST_EXPONENT, n);
	Superellipsoid *shape = ARENA_NEW(arena, Superellipsoid);
	*shape = (Superellipsoid){e, n, bounds_of(e), bounds_of(n), e <= 2 && n <= 2};
	return shape;
}

static bool superellipsoid_bounds(const void *data, Box3 *box)
{
	(void)data;
	*box = (Box3){vec3_all(-1), vec3_all(1)};
	return true;
}

/* (a^p + b^p)^(1/p) for a, b >= 0 and p = 2 / exponent, with its derivatives; free of overflow
 * by scaling. */
static double pair_norm(double a, double b, double exponent, double slopes[2])
{
	double larger = real_max(a, b), smaller = real_min(a, b);
	if (larger == 0) {
		slopes[0] = slopes[1] = 0;
		return 0;
	}
	double power = pow(smaller / larger, 2 / exponent), sum = 1 + power;
	double norm = larger * pow(sum, 0.5 * exponent);
	double larger_slope = norm / (larger * sum);
	double smaller_slope = smaller > 0 ? norm * power / (smaller * sum) : 0;
	slopes[0] = a >= b ? larger_slope : smaller_slope;
	slopes[1] = a >= b ? smaller_slope : larger_slope;
	return norm;
}

static double gauge(const Superellipsoid *shape, Vec3 p, Vec3 *gradient)
{
	double across[2], both[2];
	double rho = pair_norm(fabs(p.x), fabs(p.y), shape->e, across);
	double value = pair_norm(rho, fabs(p.z), shape->n, both);
	*gradient = vec3(copysign(both[0] * across[0], p.x), copysign(both[0] * across[1], p.y),
			 copysign(both[1], p.z));
	return value;
}

typedef struct Range {
	double least, most;
} Range;

/* A pair's norm for an exponent whose powers are roots at most; for any other more than any norm.
 */
static double easy_norm(int exponent, double a, double b)
{
	double roots = exponent == 4 ? sqrt(a) + sqrt(b) : 0;
	switch (exponent) {
	case 0: return real_max(a, b);
	case 1: return sqrt(a * a + b * b);
	case 2: return a + b;
	case 4: return roots * roots;
	default: return 1e300;
	}
}

/* The norm rises with the exponent, and the mean by powers (the norm with half of each) falls. */
static Range pair_range(const PairBounds *bounds, Range a, double b)
{
	Range range = {easy_norm(bounds->below, a.least, b), easy_norm(bounds->above, a.most, b)};
	double up = bounds->up * easy_norm(bounds->below, a.most, b),
	       down = bounds->down * easy_norm(bounds->above, a.least, b);
	return (Range){real_max(range.least, down), real_min(range.most, up)};
}

/* Most points need no power to be told from each other. */
static bool is_inside(const Superellipsoid *shape, Vec3 p)
{
	double x = fabs(p.x);
	Range rho = pair_range(&shape->across, (Range){x, x}, fabs(p.y)),
	      range = pair_range(&shape->both, rho, fabs(p.z));
	if (range.least > 1 + RANGE_ROUNDING)
		return false;
	if (range.most < 1 - RANGE_ROUNDING)
		return true;
	Vec3 gradient;
	return gauge(shape, p, &gradient) < 1;
}

/* Newton from the side of t; direction +1 walks up, -1 down. False when the line passes by. */
static bool newton_from(const Superellipsoid *shape, const Ray *ray, double *t, double direction)
{
	for (int i = 0; i < NEWTON_STEPS; i++) {
		Vec3 gradient;
		double value = gauge(shape, ray_at(ray, *t), &gradient) - 1;
		double slope = vec3_dot(gradient, ray->direction);
		if (value <= 1e-15)
			return true;
		if (slope * direction >= 0)
			return false;
		double step = -value / slope;
		*t += step;
		if (fabs(step) <= 1e-14 * fabs(*t))
			return true;
	}
	return true;
}

/* Where the ray enters and leaves between t[0] and t[1]; the latter only if more than one crossing
 * is wanted or it starts inside. What is there already when it starts or ends is left as it is. */
static int cross_convex(const Superellipsoid *shape, const Ray *ray, int most, double t[2])
{
	if (!newton_from(shape, ray, &t[0], 1))
		return 0;
	if (most == 1 && t[0] > ray->tmin)
		return 1;
	newton_from(shape, ray, &t[1], -1);
	return t[0] < t[1] ? 2 : 0;
}

typedef struct Line {
	const Superellipsoid *shape;
	const Ray *ray;
} Line;

static double gauge_along(const void *data, double t)
{
	const Line *line = data;
	Vec3 gradient;
	return gauge(line->shape, ray_at(line->ray, t), &gradient) - 1;
}

/* Where the ray passes the planes x = 0, y = 0, z = 0, x = y, x = -y between t[0] and t[1], then
 * t[1]; rising. */
static int kinks_between(const Ray *ray, const double t[2], double ends[KINK_PLANES + 1])
{
	static const Vec3 planes[KINK_PLANES] = {
		{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 0}, {1, -1, 0}};
	int count = 0;
	for (int i = 0; i < KINK_PLANES; i++) {
		double at = -vec3_dot(planes[i], ray->origin) / vec3_dot(planes[i], ray->direction);
		if (!(at > t[0] && at < t[1]))
			continue;
		int place = count++;
		for (; place > 0 && ends[place - 1] > at; place--)
			ends[place] = ends[place - 1];
		ends[place] = at;
	}
	ends[count++] = t[1];
	return count;
}

/* The crossing in an interval whose ends lie on two sides; enters: it starts outside, whatever the
 * gauge is there. */
static double refine(const Line *line, const double t[2], bool enters)
{
	SecantSample from = {t[0], enters ? 1 : gauge_along(line, t[0])},
		     to = {t[1], gauge_along(line, t[1])};
	return secant_root(gauge_along, line, from, to, 1e-13 * fabs(to.t));
}

/* Crossings between t[0] and t[1] in rising order until the list has `most`. Where the ray comes
 * from beyond the box it is outside at first. */
static void cross_pinched(const Shape *self, const Ray *ray, const double t[2], int most,
			  HitList *out)
{
	const Superellipsoid *shape = self->data;
	const Line line = {shape, ray};
	double ends[KINK_PLANES + 1], last = t[0], before = t[0];
	bool enters = t[0] > ray->tmin, was_inside = !enters && is_inside(shape, ray_at(ray, t[0]));
	int count = kinks_between(ray, t, ends);
	for (int i = 0; i < count; last = ends[i++]) {
		double step = (ends[i] - last) / PINCHED_SAMPLES;
		for (int k = 1; k <= PINCHED_SAMPLES; k++) {
			double at = k < PINCHED_SAMPLES ? last + k * step : ends[i];
			bool inside = is_inside(shape, ray_at(ray, at));
			if (inside != was_inside) {
				double places[] = {before, at};
				hit_list_add(out, ray, self,
					     refine(&line, places, enters && before == t[0]), 0);
				if (out->count >= most)
					return;
			}
			before = at;
			was_inside = inside;
		}
	}
}

/* Crossings in rising order until the list has `most`. */
static void superellipsoid_cross(const Shape *self, const Ray *ray, int most, HitList *out)
{
	const Superellipsoid *shape = self->data;
	double t[2];
	int faces[2];
	if (!box_cross((Box3){vec3_all(-1), vec3_all(1)}, ray, t, faces) || t[1] < ray->tmin ||
	    t[0] > ray->tmax)
		return;
	t[0] = real_max(t[0], ray->tmin);
	t[1] = real_min(t[1], ray->tmax);
	if (!shape->convex) {
		cross_pinched(self, ray, t, most, out);
		return;
	}
	int count = cross_convex(shape, ray, most, t);
	for (int i = 0; i < count; i++)
		hit_list_add(out, ray, self, t[i], 0);
}

static void superellipsoid_intersect(const Shape *self, const Ray *ray, HitList *out)
{
	superellipsoid_cross(self, ray, INT_MAX, out);
}

static bool superellipsoid_nearest(const Shape *self, const Ray *ray, Hit *out)
{
	return hit_nearest_by(superellipsoid_cross, self, ray, out);
}

static bool superellipsoid_inside(const void *data, Vec3 p)
{
	return is_inside(data, p);
}

static Vec3 superellipsoid_normal(const void *data, const Hit *hit, Vec3 p)
{
	Vec3 gradient;
	(void)hit;
	gauge(data, p, &gradient);
	return vec3_is_finite(gradient) && vec3_length2(gradient) > 0 ? gradient : p;
}

const ShapeClass superellipsoid_class = {
	.name = "superellipsoid",
	.bounds = superellipsoid_bounds,
	.intersect = superellipsoid_intersect,
	.inside = superellipsoid_inside,
	.normal = superellipsoid_normal,
	.nearest = superellipsoid_nearest,
};
