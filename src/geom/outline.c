#include "geom/outline.h"

#include <string.h>

#include "geom/polynomial.h"

Vec2 curve_point(const CurveSegment *g, double s)
{
	return (Vec2){g->u[0] + s * (g->u[1] + s * (g->u[2] + s * g->u[3])),
		      g->v[0] + s * (g->v[1] + s * (g->v[2] + s * g->v[3]))};
}

Vec2 curve_tangent(const CurveSegment *g, double s)
{
	return (Vec2){g->u[1] + s * (2 * g->u[2] + s * 3 * g->u[3]),
		      g->v[1] + s * (2 * g->v[2] + s * 3 * g->v[3])};
}

static void include_value(double *lo, double *hi, double x)
{
	*lo = fmin(*lo, x);
	*hi = fmax(*hi, x);
}

/* A cubic's range over [0, 1]: its ends and where its derivative is zero. */
static void cubic_range(const double a[4], double *lo, double *hi)
{
	*lo = *hi = a[0];
	include_value(lo, hi, a[0] + a[1] + a[2] + a[3]);
	double qa = 3 * a[3], qb = 2 * a[2], qc = a[1], root[2];
	double discriminant = qb * qb - 4 * qa * qc;
	if (discriminant < 0)
		return;
	double q = -0.5 * (qb + copysign(sqrt(discriminant), qb));
	root[0] = qa != 0 ? q / qa : -1;
	root[1] = q != 0 ? qc / q : -1;
	for (int i = 0; i < 2; i++) {
		double s = root[i];
		if (s > 0 && s < 1)
			include_value(lo, hi, a[0] + s * (a[1] + s * (a[2] + s * a[3])));
	}
}

void curve_finish(CurveSegment *segment)
{
	cubic_range(segment->u, &segment->lo.u, &segment->hi.u);
	cubic_range(segment->v, &segment->lo.v, &segment->hi.v);
}

/* Coefficients of one coordinate from the points around a segment, k pointing at the segment's own
 * first point. */
static void coefficients(CurveKind kind, const double *k, double a[4])
{
	memset(a, 0, 4 * sizeof *a);
	switch (kind) {
	case CURVE_LINEAR:
		a[0] = k[0];
		a[1] = k[1] - k[0];
		break;
	case CURVE_QUADRATIC: /* through k0 and k1, leaving k0 along k1 - k-1 */
		a[0] = k[0];
		a[1] = 0.5 * (k[1] - k[-1]);
		a[2] = 0.5 * (k[-1] - 2 * k[0] + k[1]);
		break;
	case CURVE_CUBIC: /* Catmull-Rom */
		a[0] = k[0];
		a[1] = 0.5 * (k[1] - k[-1]);
		a[2] = 0.5 * (2 * k[-1] - 5 * k[0] + 4 * k[1] - k[2]);
		a[3] = 0.5 * (-k[-1] + 3 * k[0] - 3 * k[1] + k[2]);
		break;
	case CURVE_BEZIER:
		a[0] = k[0];
		a[1] = 3 * (k[1] - k[0]);
		a[2] = 3 * (k[0] - 2 * k[1] + k[2]);
		a[3] = k[3] - 3 * k[2] + 3 * k[1] - k[0];
		break;
	}
}

/* How many points stand before the first segment's start, and how many a segment needs from there
 * on. */
static const struct { int before, span, step; } layout[] = {
	[CURVE_LINEAR] = {0, 2, 1},
	[CURVE_QUADRATIC] = {1, 2, 1},
	[CURVE_CUBIC] = {1, 3, 1},
	[CURVE_BEZIER] = {0, 4, 4},
};

CurveSegment *curve_from_points(Arena *arena, CurveKind kind, const Vec2 *points, int point_count,
				int *count, const char **error)
{
	int before = layout[kind].before, span = layout[kind].span, step = layout[kind].step;
	int segments = (point_count - before - span) / step + 1;
	*error = point_count < before + span ? "too few points for this kind of spline" : NULL;
	if (kind == CURVE_BEZIER && point_count % 4 != 0)
		*error = "a bezier_spline takes four points a segment";
	if (*error)
		return NULL;
	CurveSegment *result = ARENA_ARRAY(arena, CurveSegment, segments);
	for (int i = 0; i < segments; i++) {
		double u[5], v[5];
		for (int k = 0; k < before + span; k++) {
			u[k] = points[i * step + k].u;
			v[k] = points[i * step + k].v;
		}
		coefficients(kind, u + before, result[i].u);
		coefficients(kind, v + before, result[i].v);
		curve_finish(&result[i]);
	}
	*count = segments;
	return result;
}

Outline outline_create(const CurveSegment *segments, int count)
{
	Outline outline = {segments, count, {INFINITY, INFINITY}, {-INFINITY, -INFINITY}};
	for (int i = 0; i < count; i++) {
		include_value(&outline.lo.u, &outline.hi.u, segments[i].lo.u);
		include_value(&outline.lo.u, &outline.hi.u, segments[i].hi.u);
		include_value(&outline.lo.v, &outline.hi.v, segments[i].lo.v);
		include_value(&outline.lo.v, &outline.hi.v, segments[i].hi.v);
	}
	return outline;
}

/* The function c0 + c1 u + c2 v is linear over the segment's box, so its sign at the corners tells
 * whether it can be zero. */
static bool line_misses(const CurveSegment *g, const double c[3])
{
	double middle = c[0] + c[1] * 0.5 * (g->lo.u + g->hi.u) + c[2] * 0.5 * (g->lo.v + g->hi.v);
	double reach = fabs(c[1]) * 0.5 * (g->hi.u - g->lo.u) +
		       fabs(c[2]) * 0.5 * (g->hi.v - g->lo.v);
	return fabs(middle) > reach * (1 + 1e-12);
}

int curve_cross_line(const CurveSegment *g, const double c[3], double s[3])
{
	if (line_misses(g, c))
		return 0;
	double a[4];
	for (int k = 0; k < 4; k++)
		a[k] = c[1] * g->u[k] + c[2] * g->v[k];
	a[0] += c[0];
	double root[3];
	int found = polynomial_roots(a, 3, -1e-9, 1, root), kept = 0;
	for (int i = 0; i < found; i++) {
		if (root[i] >= 0)
			s[kept++] = root[i];
	}
	return kept;
}

/* Crossings of the half line from p along +u. A segment that starts or ends at p's height is
 * counted by whether its ends lie on different sides, so a joint counts once. */
static bool crosses_odd(const CurveSegment *g, Vec2 p)
{
	if (p.v < g->lo.v || p.v > g->hi.v || p.u > g->hi.u)
		return false;
	Vec2 start = curve_point(g, 0), end = curve_point(g, 1);
	bool differs = (start.v > p.v) != (end.v > p.v);
	if (p.u < g->lo.u)
		return differs;
	double c[3] = {-p.v, 0, 1}, s[3];
	int found = curve_cross_line(g, c, s), right = 0;
	for (int i = 0; i < found; i++)
		right += curve_point(g, s[i]).u > p.u;
	/* With all crossings on one side the ends decide, which is exact at joints. */
	if (found == 0)
		return differs && (fabs(end.v - p.v) < fabs(start.v - p.v) ? end.u : start.u) > p.u;
	if (right == found)
		return differs;
	return right & 1;
}

bool outline_inside(const Outline *outline, Vec2 p)
{
	if (p.u < outline->lo.u || p.u > outline->hi.u || p.v < outline->lo.v ||
	    p.v > outline->hi.v)
		return false;
	bool inside = false;
	for (int i = 0; i < outline->count; i++)
		inside ^= crosses_odd(&outline->segments[i], p);
	return inside;
}
