/*
 * Lathes: a curve (r(s), y(s)) turned about the y axis. A ray o + t d meets it where |o + t d|_xz =
 * r(s) and oy + t dy = y(s); with t taken from the second, the first is a polynomial in s of twice
 * the curve's degree. A level ray (dy = 0) takes s from the second and t from the first.
 */
#include "geom/polynomial.h"
#include "geom/sweep.h"

/*
 * Runs of neighbouring segments share a ring around them, in a binary tree: node n has the children
 * 2n + 1 and 2n + 2, each with half of its segments; a node of one segment is a leaf.
 */
typedef struct Ring {
	double low, high;    /* heights */
	double inner, outer; /* squared radii */
} Ring;

typedef struct Lathe {
	const CurveSegment *segments;
	int count;
	Ring *rings;
	double radius, low, high;
	double tiny; /* a length that counts as nothing beside the lathe's size */
} Lathe;

static Ring ring_of(const CurveSegment *g)
{
	double a = fabs(g->lo.u), b = fabs(g->hi.u),
	       inner = g->lo.u < 0 && g->hi.u > 0 ? 0 : fmin(a, b), outer = fmax(a, b);
	return (Ring){g->lo.v, g->hi.v, inner * inner, outer * outer};
}

static int tree_size(int segments)
{
	int size = 1;
	while (size < segments)
		size *= 2;
	return 2 * size;
}

static void build_rings(Lathe *lathe, int node, int first, int count)
{
	Ring *ring = &lathe->rings[node];
	*ring = ring_of(&lathe->segments[first]);
	for (int i = first + 1; i < first + count; i++) {
		Ring other = ring_of(&lathe->segments[i]);
		*ring = (Ring){fmin(ring->low, other.low), fmax(ring->high, other.high),
			       fmin(ring->inner, other.inner), fmax(ring->outer, other.outer)};
	}
	if (count == 1)
		return;
	build_rings(lathe, 2 * node + 1, first, count / 2);
	build_rings(lathe, 2 * node + 2, first + count / 2, count - count / 2);
}

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
		.rings = ARENA_ARRAY(arena, Ring, tree_size(count)),
		.radius = fmax(fabs(bounds.lo.u), fabs(bounds.hi.u)),
		.low = bounds.lo.v,
		.high = bounds.hi.v,
	};
	lathe->tiny = 1e-12 * fmax(lathe->radius, lathe->high - lathe->low);
	build_rings(lathe, 0, 0, count);
	return lathe;
}

static bool lathe_bounds(const void *data, Box3 *box)
{
	const Lathe *lathe = data;
	double r = lathe->radius;
	*box = (Box3){{-r, lathe->low, -r}, {r, lathe->high, r}};
	return true;
}

/* The squared distance from the axis as a parabola of t: a t^2 + 2 b t + c. */
typedef struct AxisDistance { double a, b, c; } AxisDistance;

static AxisDistance axis_distance(const Ray *ray)
{
	Vec3 o = ray->origin, d = ray->direction;
	return (AxisDistance){d.x * d.x + d.z * d.z, o.x * d.x + o.z * d.z, o.x * o.x + o.z * o.z};
}

static void push(const Shape *self, const Ray *ray, Hit hit, HitList *out)
{
	hit.shape = self;
	if (hit.t > ray->tmin && hit.t < ray->tmax)
		hit_list_push(out, hit);
}

/* product += k a b, polynomials of degree 3 */
static void add_product(double *product, double k, const double *a, const double *b)
{
	for (int i = 0; i < 4; i++) {
		for (int j = 0; j < 4; j++)
			product[i + j] += k * a[i] * b[j];
	}
}

static void cross_segment(const Shape *self, const Ray *ray, int number, HitList *out)
{
	const CurveSegment *g = &((const Lathe *)self->data)->segments[number];
	AxisDistance q = axis_distance(ray);
	double dy = ray->direction.y;
	/* with w = y(s) - oy: a w^2 + 2 b dy w + c dy^2 - dy^2 r(s)^2 = 0 */
	double w[4] = {g->v[0] - ray->origin.y, g->v[1], g->v[2], g->v[3]}, p[7] = {q.c * dy * dy};
	add_product(p, q.a, w, w);
	add_product(p, -dy * dy, g->u, g->u);
	for (int i = 0; i < 4; i++)
		p[i] += 2 * q.b * dy * w[i];
	double s[7];
	int found = polynomial_roots(p, 6, -1e-9, 1, s);
	for (int i = 0; i < found; i++) {
		double t = (curve_point(g, s[i]).v - ray->origin.y) / dy;
		if (s[i] >= 0)
			push(self, ray, (Hit){.t = t, .part = number, .u = s[i]}, out);
	}
}

static void cross_segment_level(const Shape *self, const Ray *ray, int number, HitList *out)
{
	const CurveSegment *g = &((const Lathe *)self->data)->segments[number];
	AxisDistance q = axis_distance(ray);
	double c[3] = {-ray->origin.y, 0, 1}, s[3];
	int found = curve_cross_line(g, c, s);
	for (int i = 0; i < found; i++) {
		double r = curve_point(g, s[i]).u, t[2];
		int times = polynomial_quadratic(q.a, 2 * q.b, q.c - r * r, t);
		for (int k = 0; k < times; k++)
			push(self, ray, (Hit){.t = t[k], .part = number, .u = s[i]}, out);
	}
}

typedef struct Turning {
	const Shape *self;
	const Lathe *lathe;
	const Ray *ray;
	AxisDistance q;
	double inverse, closest; /* 1 / dy; where the ray is nearest to the axis */
	bool level;
	HitList *out;
} Turning;

static double larger(double a, double b) { return a > b ? a : b; }
static double smaller(double a, double b) { return a < b ? a : b; }

static double distance_at(const AxisDistance *q, double t)
{
	return (q->a * t + 2 * q->b) * t + q->c;
}

/* Whether the ray passes the ring by: it is never between its heights and, there, between its
 * radii. A little slack covers rounding. */
static bool passes_by(const Turning *turning, const Ring *ring)
{
	const Ray *ray = turning->ray;
	double near = ray->tmin, far = ray->tmax;
	if (turning->level) {
		if (ray->origin.y < ring->low || ray->origin.y > ring->high)
			return true;
	} else {
		double a = (ring->low - ray->origin.y) * turning->inverse,
		       b = (ring->high - ray->origin.y) * turning->inverse;
		near = larger(near, smaller(a, b));
		far = smaller(far, larger(a, b));
	}
	double slack = 1e-9 * (fabs(near) + (far < 1e30 ? fabs(far) : 0));
	near -= slack;
	far += slack;
	if (near > far)
		return true;
	double t = smaller(larger(turning->closest, near), far);
	if (distance_at(&turning->q, t) > ring->outer * (1 + 1e-9))
		return true;
	return far < 1e30 && larger(distance_at(&turning->q, near), distance_at(&turning->q, far)) <
				     ring->inner * (1 - 1e-9);
}

static void cross_rings(const Turning *turning, int node, int first, int count)
{
	if (passes_by(turning, &turning->lathe->rings[node]))
		return;
	if (count > 1) {
		cross_rings(turning, 2 * node + 1, first, count / 2);
		cross_rings(turning, 2 * node + 2, first + count / 2, count - count / 2);
	} else if (turning->level) {
		cross_segment_level(turning->self, turning->ray, first, turning->out);
	} else {
		cross_segment(turning->self, turning->ray, first, turning->out);
	}
}

static void lathe_intersect(const Shape *self, const Ray *ray, HitList *out)
{
	Turning turning = {
		.self = self, .lathe = self->data, .ray = ray, .q = axis_distance(ray), .out = out};
	double dy = ray->direction.y, reach = sqrt(turning.q.a + dy * dy);
	turning.level = fabs(dy) < 1e-9 * reach;
	turning.inverse = 1 / dy;
	turning.closest = turning.q.a > 0 ? -turning.q.b / turning.q.a : 0;
	cross_rings(&turning, 0, 0, turning.lathe->count);
}

/* Inside when the half line from (r, y) away from the axis crosses the curve an odd number of
 * times. */
static bool lathe_inside(const void *data, Vec3 p)
{
	const Lathe *lathe = data;
	double r = hypot(p.x, p.z), c[3] = {-p.y, 0, 1}, s[3];
	if (p.y < lathe->low || p.y > lathe->high || r > lathe->radius)
		return false;
	bool inside = false;
	for (int i = 0; i < lathe->count; i++) {
		int found = curve_cross_line(&lathe->segments[i], c, s);
		for (int k = 0; k < found; k++)
			inside ^= fabs(curve_point(&lathe->segments[i], s[k]).u) > r;
	}
	return inside;
}

static Vec3 lathe_normal(const void *data, const Hit *hit, Vec3 p)
{
	const Lathe *lathe = data;
	const CurveSegment *g = &lathe->segments[hit->part];
	Vec2 d = curve_tangent(g, hit->u);
	double r = hypot(p.x, p.z);
	if (r <= lathe->tiny)
		return vec3(0, -d.u != 0 ? -d.u : 1, 0);
	double sign = curve_point(g, hit->u).u < 0 ? -1 : 1;
	return vec3(sign * d.v * p.x / r, -d.u, sign * d.v * p.z / r);
}

static Vec2 lathe_uv(const void *data, const Hit *hit, Vec3 p)
{
	double turn = atan2(p.x, p.z) / (2 * M_PI);
	return (Vec2){turn < 0 ? turn + 1 : turn,
		      (hit->part + hit->u) / ((const Lathe *)data)->count};
}

const ShapeClass lathe_class = {
	.name = "lathe",
	.bounds = lathe_bounds,
	.intersect = lathe_intersect,
	.inside = lathe_inside,
	.normal = lathe_normal,
	.uv = lathe_uv,
};
