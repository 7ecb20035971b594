/*
 * Lathes: a curve (r(s), y(s)) turned about the y axis. Of a ray, seen from its point nearest to
 * the lathe's middle, the squared distance from the axis is a parabola of its height y: the ray
 * crosses where (times the square of its rise) that is r(s)^2 at y(s), a polynomial in s of twice
 * the curve's degree. The curve is cut into short spans (geom/lathe_spans.h), for which the
 * polynomial's Bernstein coefficients are a sum of three products of numbers known before: their
 * signs tell most spans that are missed (Descartes), and of the others Newton's iteration finds the
 * crossing. Rays that hardly rise or fall are cancellation's prey in that form: they take s from
 * the height and t from the radius.
 */
#include "geom/lathe_spans.h"
#include "geom/sweep.h"

/* Rays that rise by less than this share of their length are taken as nearly level. */
static const double SLOW_RISE = 1e-5;

typedef struct Lathe {
	const CurveSegment *segments;
	int count;
	LatheSpans spans;
	double radius, low, high;
	double tiny; /* a length that counts as nothing beside the lathe's size */
} Lathe;

const void *lathe_create(Arena *arena, const LatheDesc *desc, const char **error)
{
	int count;
	CurveSegment *segments = curve_from_points(arena, desc->kind, desc->points,
						   desc->point_count, &count, error);
	if (!segments)
		return NULL;
	Outline bounds = outline_create(segments, count);
	Lathe *lathe = ARENA_NEW(arena, Lathe);
	*lathe = (Lathe){
		.segments = segments,
		.count = count,
		.spans = lathe_spans_create(arena, segments, count),
		.radius = fmax(fabs(bounds.lo.u), fabs(bounds.hi.u)),
		.low = bounds.lo.v,
		.high = bounds.hi.v,
	};
	lathe->tiny = 1e-12 * fmax(lathe->radius, lathe->high - lathe->low);
	return lathe;
}

static bool lathe_bounds(const void *data, Box3 *box)
{
	const Lathe *lathe = data;
	double r = lathe->radius;
	*box = (Box3){{-r, lathe->low, -r}, {r, lathe->high, r}};
	return true;
}

/* A ray on its way through the lathe. Where it gets the nearest crossing alone, tmax and the
 * heights close in on it. */
typedef struct Turning {
	const Shape *self;
	const LatheSpans *spans;
	double tmin, tmax;
	HitList *out; /* NULL: the nearest alone, to best */
	Hit *best;
	bool found;

	double shift;     /* of the parameter t that the rest is by */
	double a, b, c;   /* squared distance from the axis: a t^2 + 2 b t + c */
	double y, rise;   /* height over the lathe's middle: y + rise t */
	double rise2, speed; /* speed: the direction's length */
	double p[3];      /* rise^2 times that distance as a parabola of height */
	double lowest, least; /* the parabola's: height, value */
	double slack;     /* rounding of the parabola's values */
	double low, high; /* between the ray's ends */
	double start2;    /* squared distance at the ray's start */
} Turning;

/* ---- the ray ---- */

static void take(Turning *turning, double t, int segment, double s)
{
	t += turning->shift;
	if (!(t > turning->tmin && t < turning->tmax))
		return;
	Hit hit = {.t = t, .shape = turning->self, .part = segment, .u = s};
	if (turning->out) {
		hit_list_push(turning->out, hit);
		return;
	}
	*turning->best = hit;
	turning->found = true;
	turning->tmax = t;
	double height = turning->y + turning->rise * (t - turning->shift);
	*(turning->rise > 0 ? &turning->high : &turning->low) = height;
}

static void set_line(Turning *turning, const Ray *ray)
{
	Vec3 d = ray->direction, middle = vec3(0, turning->spans->middle, 0);
	turning->shift = vec3_dot(vec3_sub(middle, ray->origin), d) / vec3_length2(d);
	Vec3 o = vec3_sub(ray_at(ray, turning->shift), middle);
	turning->a = d.x * d.x + d.z * d.z;
	turning->b = o.x * d.x + o.z * d.z;
	turning->c = o.x * o.x + o.z * o.z;
	turning->y = o.y;
	turning->rise = d.y;
	turning->rise2 = d.y * d.y;
	turning->speed = sqrt(turning->a + turning->rise2);
}

static void set_parabola(Turning *turning)
{
	double a = turning->a, b = turning->b * turning->rise, c = turning->c * turning->rise2,
	       y = turning->y;
	turning->p[2] = a;
	turning->p[1] = 2 * (b - a * y);
	turning->p[0] = (a * y - 2 * b) * y + c;
	turning->lowest = a > 0 ? y - b / a : 0;
	turning->least = c - (a > 0 ? b * b / a : 0);
	const Lathe *lathe = turning->self->data;
	double reach = fabs(y) + lathe->high - lathe->low;
	turning->slack = 1e-14 * ((a * reach + fabs(b)) * reach + c);
}

static void set_ends(Turning *turning)
{
	double from = turning->tmin - turning->shift, to = turning->tmax - turning->shift;
	double first = turning->y + turning->rise * from, last = turning->y + turning->rise * to;
	turning->low = real_min(first, last);
	turning->high = real_max(first, last);
	turning->start2 = (turning->a * from + 2 * turning->b) * from + turning->c;
}

/* ---- a span ---- */

/* The one crossing between two parameters with coefficients of different sign at the ends. Heights
 * are taken from the ray's own here, which keeps slowly rising rays exact. */
static double crossing(const Turning *turning, const LatheSpan *span, const double range[2],
		       const double b[LATHE_DEGREE + 1])
{
	double lo = range[0], hi = range[1], tilt = turning->b * turning->rise;
	double s = lo + (hi - lo) * b[0] / (b[0] - b[LATHE_DEGREE]);
	/* A slow ray's two crossings are close in s, and far apart in t. */
	double precision = 1e-7 * fabs(turning->rise) / turning->speed;
	const double *u = span->u, *v = span->v;
	for (int i = 0; i < 60; i++) {
		double w = v[0] - turning->y + s * (v[1] + s * (v[2] + s * v[3])),
		       r = u[0] + s * (u[1] + s * (u[2] + s * u[3]));
		double w_slope = v[1] + s * (2 * v[2] + s * 3 * v[3]),
		       r_slope = u[1] + s * (2 * u[2] + s * 3 * u[3]);
		double value = (turning->a * w + 2 * tilt) * w +
			       turning->rise2 * (turning->c - r * r);
		double slope = 2 * ((turning->a * w + tilt) * w_slope -
				    turning->rise2 * r * r_slope);
		*((value > 0) == (b[0] > 0) ? &lo : &hi) = s;
		double next = s - value / slope;
		if (!(next >= lo && next <= hi))
			next = 0.5 * (lo + hi);
		double step = fabs(next - s);
		s = next;
		if (step < precision)
			break;
	}
	return s;
}

static void cross_once(Turning *turning, const LatheSpan *span, const double range[2],
		       const double b[LATHE_DEGREE + 1])
{
	double s = crossing(turning, span, range, b);
	const double *v = span->v;
	double w = v[0] - turning->y + s * (v[1] + s * (v[2] + s * v[3]));
	take(turning, w / turning->rise, span->segment, span->start + s * span->length);
}

/* de Casteljau's scheme in the middle: b becomes the left half, right the right one. */
static void halve(double b[LATHE_DEGREE + 1], double right[LATHE_DEGREE + 1])
{
	for (int k = 0; k <= LATHE_DEGREE; k++) {
		right[LATHE_DEGREE - k] = b[LATHE_DEGREE];
		for (int i = LATHE_DEGREE; i > k; i--)
			b[i] = 0.5 * (b[i - 1] + b[i]);
	}
}

/* One change of sign is one crossing; more are parted, a few times. What is still not parted then
 * is a touch, or one crossing among others so close that they do not matter. Signs at the ends of
 * a part are those of its neighbours, so that none is lost between them. */
static void isolate(Turning *turning, const LatheSpan *span, double b[LATHE_DEGREE + 1],
		    const double range[2])
{
	enum { ALL = (1 << (LATHE_DEGREE + 1)) - 1 };
	static const double shortest = 1.0 / (1 << 28);
	unsigned signs = 0;
	for (int i = 0; i <= LATHE_DEGREE; i++)
		signs |= (unsigned)(b[i] > 0) << i;
	if (signs == 0 || signs == ALL)
		return;
	bool ends_differ = (signs & 1) != signs >> LATHE_DEGREE;
	unsigned changes = (signs ^ signs >> 1) & ALL >> 1;
	bool one = (changes & (changes - 1)) == 0;
	if (one || (range[1] - range[0] <= shortest && ends_differ)) {
		cross_once(turning, span, range, b);
		return;
	}
	if (range[1] - range[0] <= shortest)
		return;
	double right[LATHE_DEGREE + 1], middle = 0.5 * (range[0] + range[1]);
	halve(b, right);
	isolate(turning, span, b, (double[2]){range[0], middle});
	isolate(turning, span, right, (double[2]){middle, range[1]});
}

static void cross_span(Turning *turning, const LatheSpan *span)
{
	double b[LATHE_DEGREE + 1];
	const double *p = turning->p;
	for (int i = 0; i <= LATHE_DEGREE; i++)
		b[i] = p[2] * span->height2[i] + p[1] * span->height[i] + p[0] -
		       turning->rise2 * span->radius2[i];
	isolate(turning, span, b, (double[2]){0, 1});
}

/* ---- the tree ---- */

static double parabola(const Turning *turning, double height)
{
	return (turning->p[2] * height + turning->p[1]) * height + turning->p[0];
}

/* Whether the ray passes the ring by: it is never between its heights and, there, between its
 * radii. */
static bool passes_by(const Turning *turning, const LatheRing *ring)
{
	double low = real_max(ring->low, turning->low), high = real_min(ring->high, turning->high);
	if (low > high)
		return true;
	double first = parabola(turning, low), last = parabola(turning, high);
	if (real_max(first, last) < turning->rise2 * ring->inner - turning->slack)
		return true;
	double least = low < turning->lowest && turning->lowest < high ? turning->least
								       : real_min(first, last);
	return least > turning->rise2 * ring->outer + turning->slack;
}

/* The child on the side that the ray comes from goes first, since a crossing there hides others. */
static void cross_rings(Turning *turning, int number)
{
	const LatheNode *node = &turning->spans->nodes[number];
	if (passes_by(turning, &node->ring))
		return;
	if (!node->second) {
		cross_span(turning, &turning->spans->spans[node->span]);
		return;
	}
	bool swap = node->by_radius ? turning->start2 > node->border2 : turning->rise < 0;
	cross_rings(turning, swap ? node->second : number + 1);
	cross_rings(turning, swap ? number + 1 : node->second);
}

/* ---- rays that hardly rise ---- */

/* Where a ray that is nearly level leaves (side 1) or enters (-1) the span's surface: its height
 * says at which radius that is, and from where it is there a better height is known. */
static void cross_span_level(Turning *turning, const LatheSpan *span, double side)
{
	const double *v = span->height, *u = span->u;
	double low = real_min(v[0], v[LATHE_DEGREE]), high = real_max(v[0], v[LATHE_DEGREE]);
	double a = turning->a, b = turning->b, t = -b / a, s = 0;
	for (int i = 0; i < 5; i++) {
		double height = turning->y + turning->rise * t;
		s = lathe_span_at_height(span, real_min(real_max(height, low), high));
		double r = u[0] + s * (u[1] + s * (u[2] + s * u[3]));
		double square = b * b - a * (turning->c - r * r);
		if (!(square >= 0))
			return;
		t = (side * sqrt(square) - b) / a;
	}
	double height = turning->y + turning->rise * t;
	if ((v[0] > height) != (v[LATHE_DEGREE] > height))
		take(turning, t, span->segment, span->start + s * span->length);
}

/* Spans as flat as the ray, which tell it no radius, are crossed as ever. */
static void cross_spans_level(Turning *turning)
{
	for (int i = 0; i < turning->spans->count; i++) {
		const LatheSpan *span = &turning->spans->spans[i];
		const double *v = span->height, *r2 = span->radius2;
		double rise = v[LATHE_DEGREE] - v[0];
		bool flat = rise * rise <= 1e-4 * fabs(r2[LATHE_DEGREE] - r2[0]);
		if (flat && turning->rise != 0)
			cross_span(turning, span);
		if (flat)
			continue;
		cross_span_level(turning, span, -1);
		cross_span_level(turning, span, 1);
	}
}

/* ---- the class ---- */

static void cross(Turning *turning, const Ray *ray)
{
	const Lathe *lathe = turning->self->data;
	turning->spans = &lathe->spans;
	turning->tmin = ray->tmin;
	turning->tmax = ray->tmax;
	set_line(turning, ray);
	set_ends(turning);
	set_parabola(turning);
	if (fabs(turning->rise) < SLOW_RISE * turning->speed)
		cross_spans_level(turning);
	else
		cross_rings(turning, 0);
}

static void lathe_intersect(const Shape *self, const Ray *ray, HitList *out)
{
	Turning turning = {.self = self, .out = out};
	cross(&turning, ray);
}

static bool lathe_nearest(const Shape *self, const Ray *ray, Hit *out)
{
	Turning turning = {.self = self, .best = out};
	cross(&turning, ray);
	return turning.found;
}

/* Whether the half line from (r, y) away from the axis crosses the span; a height where two spans
 * meet is the lower one's. */
static bool lies_beyond(const LatheSpan *span, double y, double r2)
{
	const double *ends = span->radius2;
	if ((span->height[0] > y) == (span->height[LATHE_DEGREE] > y))
		return false;
	if (real_min(ends[0], ends[LATHE_DEGREE]) > r2)
		return true;
	if (real_max(ends[0], ends[LATHE_DEGREE]) <= r2)
		return false;
	double s = lathe_span_at_height(span, y);
	double r = span->u[0] + s * (span->u[1] + s * (span->u[2] + s * span->u[3]));
	return r * r > r2;
}

static bool crosses_odd(const LatheSpans *spans, int number, double y, double r2)
{
	const LatheNode *node = &spans->nodes[number];
	if (y < node->ring.low || y > node->ring.high || r2 > node->ring.outer)
		return false;
	if (!node->second)
		return lies_beyond(&spans->spans[node->span], y, r2);
	return crosses_odd(spans, number + 1, y, r2) ^ crosses_odd(spans, node->second, y, r2);
}

/* Inside when the half line from (r, y) away from the axis crosses the curve an odd number of
 * times. */
static bool lathe_inside(const void *data, Vec3 p)
{
	const LatheSpans *spans = &((const Lathe *)data)->spans;
	return crosses_odd(spans, 0, p.y - spans->middle, p.x * p.x + p.z * p.z);
}

/* The curve ends where it began, or on the axis. */
static bool lathe_closed(const void *data)
{
	const Lathe *lathe = data;
	Vec2 first = curve_point(&lathe->segments[0], 0),
	     last = curve_point(&lathe->segments[lathe->count - 1], 1);
	bool joined = hypot(first.u - last.u, first.v - last.v) <= lathe->tiny;
	return joined || (fabs(first.u) <= lathe->tiny && fabs(last.u) <= lathe->tiny);
}

static Vec3 lathe_normal(const void *data, const Hit *hit, Vec3 p)
{
	const Lathe *lathe = data;
	const CurveSegment *g = &lathe->segments[hit->part];
	Vec2 d = curve_tangent(g, hit->u);
	double r = sqrt(p.x * p.x + p.z * p.z);
	if (r <= lathe->tiny)
		return vec3(0, -d.u != 0 ? -d.u : 1, 0);
	double side = curve_point(g, hit->u).u < 0 ? -d.v / r : d.v / r;
	return vec3(side * p.x, -d.u, side * p.z);
}

static Vec2 lathe_uv(const void *data, const Hit *hit, Vec3 p)
{
	return (Vec2){vec3_turn(p), (hit->part + hit->u) / ((const Lathe *)data)->count};
}

const ShapeClass lathe_class = {
	.name = "lathe",
	.bounds = lathe_bounds,
	.intersect = lathe_intersect,
	.inside = lathe_inside,
	.normal = lathe_normal,
	.uv = lathe_uv,
	.nearest = lathe_nearest,
	.closed = lathe_closed,
};
