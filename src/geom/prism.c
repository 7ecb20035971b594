/*
 * Prisms. A ray and the direction of the sweep span a plane (linear sweep), a ray and the apex do
 * (conic sweep); where that plane cuts the curve is a cubic in the curve's parameter, and t follows
 * linearly from the point found.
 */
#include "geom/prism.h"

#include "geom/sweep.h"

struct Prism {
	Outline outline;
	const double *side; /* per segment: +1 when (v', -u') points outward, else -1 */
	double low, high;
	bool conic, open;
};

enum { CAP_LOW = -1, CAP_HIGH = -2 };

/* ---- making ---- */

typedef struct Parts {
	CurveSegment *segments;
	int count;
} Parts;

static bool same_point(Vec2 a, Vec2 b)
{
	return fabs(a.u - b.u) < 1e-9 && fabs(a.v - b.v) < 1e-9;
}

/* The curves before a spline's first point and after its last: control points only. */
static int controls_before(CurveKind kind)
{
	return kind == CURVE_QUADRATIC || kind == CURVE_CUBIC;
}
static int controls_after(CurveKind kind) { return kind == CURVE_CUBIC; }

/* Number of points of the closed part that starts at points[0]; 0 when it does not close. */
static int part_length(CurveKind kind, const Vec2 *points, int count)
{
	int first = controls_before(kind);
	for (int i = first + 2; i < count; i++) {
		if (same_point(points[i], points[first]) && i + controls_after(kind) < count)
			return i + controls_after(kind) + 1;
	}
	return 0;
}

static bool add_part(Arena *arena, Parts *parts, CurveKind kind, const Vec2 *points, int count,
		     const char **error)
{
	int added;
	CurveSegment *part = curve_from_points(arena, kind, points, count, &added, error);
	if (!part)
		return false;
	for (int i = 0; i < added; i++)
		parts->segments[parts->count++] = part[i];
	return true;
}

static bool add_parts(Arena *arena, Parts *parts, const PrismDesc *desc, const char **error)
{
	if (desc->kind == CURVE_BEZIER)
		return add_part(arena, parts, desc->kind, desc->points, desc->point_count, error);
	for (int start = 0; start < desc->point_count;) {
		int length = part_length(desc->kind, desc->points + start,
					 desc->point_count - start);
		if (length == 0) {
			*error =
				"the curve of a prism must close: its last point repeats its first";
			return start > 0; /* what is left over after a closed part is ignored, as
					     POV-Ray does */
		}
		if (!add_part(arena, parts, desc->kind, desc->points + start, length, error))
			return false;
		start += length;
	}
	return parts->count > 0;
}

static const double *find_sides(Arena *arena, const Outline *outline)
{
	double *side = ARENA_ARRAY(arena, double, outline->count);
	double step = 1e-6 * fmax(outline->hi.u - outline->lo.u, outline->hi.v - outline->lo.v);
	for (int i = 0; i < outline->count; i++) {
		Vec2 p = curve_point(&outline->segments[i], 0.43),
		     d = curve_tangent(&outline->segments[i], 0.43);
		double scale = step / fmax(hypot(d.u, d.v), 1e-300);
		side[i] = outline_inside(outline, (Vec2){p.u + scale * d.v, p.v - scale * d.u}) ? -1
												: 1;
	}
	return side;
}

Prism *prism_from_outline(Arena *arena, const Outline *outline, double low, double high)
{
	Prism *prism = ARENA_NEW(arena, Prism);
	prism->outline = *outline;
	prism->side = find_sides(arena, &prism->outline);
	prism->low = fmin(low, high);
	prism->high = fmax(low, high);
	return prism;
}

const void *prism_create(Arena *arena, const PrismDesc *desc, const char **error)
{
	Parts parts = {ARENA_ARRAY(arena, CurveSegment, desc->point_count + 1), 0};
	*error = desc->point_count < 3 ? "a prism needs at least three points" : NULL;
	if (*error || !add_parts(arena, &parts, desc, error))
		return NULL;
	*error = NULL;
	Outline outline = outline_create(parts.segments, parts.count);
	Prism *prism = prism_from_outline(arena, &outline, desc->low, desc->high);
	prism->conic = desc->conic;
	prism->open = desc->open;
	return prism;
}

/* ---- tracing ---- */

void prism_box(const Prism *p, Box3 *box)
{
	*box = (Box3){{p->outline.lo.u, p->low, p->outline.lo.v},
		      {p->outline.hi.u, p->high, p->outline.hi.v}};
	if (!p->conic)
		return;
	Box3 b = box3_empty();
	for (int i = 0; i < 2; i++) {
		double y = i ? p->high : p->low;
		b = box3_add(b, vec3(p->outline.lo.u * y, y, p->outline.lo.v * y));
		b = box3_add(b, vec3(p->outline.hi.u * y, y, p->outline.hi.v * y));
	}
	if (p->low < 0 && p->high > 0)
		b = box3_add(b, vec3(0, 0, 0));
	*box = b;
}

/* The line c0 + c1 u + c2 v = 0 in the curve's plane that the ray sweeps over. */
static void swept_line(const Prism *prism, const Ray *ray, double c[3])
{
	Vec3 o = ray->origin, d = ray->direction;
	if (prism->conic) {
		Vec3 m = vec3_cross(o, d);
		c[0] = m.y;
		c[1] = m.x;
		c[2] = m.z;
	} else {
		c[0] = o.x * d.z - o.z * d.x;
		c[1] = -d.z;
		c[2] = d.x;
	}
}

/* Where the ray is over the curve's point p. */
static double ray_parameter(const Prism *prism, const Ray *ray, Vec2 p)
{
	Vec3 o = ray->origin, d = ray->direction;
	double nx = p.u - o.x, nz = p.v - o.z, dx = d.x, dz = d.z;
	if (prism->conic) {
		nx = p.u * o.y - o.x;
		nz = p.v * o.y - o.z;
		dx = d.x - p.u * d.y;
		dz = d.z - p.v * d.y;
	}
	return fabs(dx) > fabs(dz) ? nx / dx : nz / dz;
}

static void cross_sides(const Prism *prism, const Ray *ray, Hit hit, HitList *out)
{
	double c[3], s[3];
	swept_line(prism, ray, c);
	for (int i = 0; i < prism->outline.count; i++) {
		int found = curve_cross_line(&prism->outline.segments[i], c, s);
		for (int k = 0; k < found; k++) {
			double t = ray_parameter(prism, ray,
						 curve_point(&prism->outline.segments[i], s[k]));
			double y = ray->origin.y + t * ray->direction.y;
			if (t > ray->tmin && t < ray->tmax && y >= prism->low && y <= prism->high)
				hit_list_push(out, (Hit){t, hit.shape, i, s[k], hit.v});
		}
	}
}

/* The curve's plane coordinates of the point p. */
static Vec2 in_plane(const Prism *prism, Vec3 p)
{
	if (!prism->conic)
		return (Vec2){p.x, p.z};
	return p.y != 0 ? (Vec2){p.x / p.y, p.z / p.y} : (Vec2){INFINITY, INFINITY};
}

static void cross_cap(const Prism *prism, const Ray *ray, Hit hit, HitList *out)
{
	double y = hit.part == CAP_LOW ? prism->low : prism->high;
	double t = (y - ray->origin.y) / ray->direction.y;
	Vec3 p = ray_at(ray, t);
	p.y = y;
	if (t > ray->tmin && t < ray->tmax && outline_inside(&prism->outline, in_plane(prism, p)))
		hit_list_push(out, (Hit){t, hit.shape, hit.part, 0, hit.v});
}

void prism_cross(const Prism *prism, const Ray *ray, Hit hit, HitList *out)
{
	if (ray->direction.x != 0 || ray->direction.z != 0 || prism->conic)
		cross_sides(prism, ray, hit, out);
	if (prism->open || ray->direction.y == 0)
		return;
	hit.part = CAP_LOW;
	cross_cap(prism, ray, hit, out);
	hit.part = CAP_HIGH;
	cross_cap(prism, ray, hit, out);
}

bool prism_contains(const Prism *prism, Vec3 p)
{
	return p.y >= prism->low && p.y <= prism->high &&
	       outline_inside(&prism->outline, in_plane(prism, p));
}

Vec3 prism_outward(const Prism *prism, const Hit *hit, Vec3 p)
{
	if (hit->part < 0)
		return vec3(0, hit->part == CAP_HIGH ? 1 : -1, 0);
	const CurveSegment *segment = &prism->outline.segments[hit->part];
	Vec2 at = curve_point(segment, hit->u), d = curve_tangent(segment, hit->u);
	double side = prism->side[hit->part];
	if (!prism->conic)
		return vec3(side * d.v, 0, -side * d.u);
	if (p.y < 0)
		side = -side;
	return vec3(side * d.v, side * (d.u * at.v - d.v * at.u), -side * d.u);
}

bool prism_is_flat(const Prism *prism, const Hit *hit)
{
	if (hit->part < 0)
		return true;
	const CurveSegment *s = &prism->outline.segments[hit->part];
	return s->u[2] == 0 && s->u[3] == 0 && s->v[2] == 0 && s->v[3] == 0;
}

/* ---- the class ---- */

static bool prism_bounds(const void *data, Box3 *box)
{
	prism_box(data, box);
	return true;
}

static void prism_intersect(const Shape *self, const Ray *ray, HitList *out)
{
	prism_cross(self->data, ray, (Hit){.shape = self}, out);
}

static bool prism_inside(const void *data, Vec3 p)
{
	return prism_contains(data, p);
}

static Vec3 prism_normal(const void *data, const Hit *hit, Vec3 p)
{
	return prism_outward(data, hit, p);
}

static bool prism_flat_at(const void *data, const Hit *hit)
{
	return prism_is_flat(data, hit);
}

const ShapeClass prism_class = {
	.name = "prism",
	.bounds = prism_bounds,
	.intersect = prism_intersect,
	.inside = prism_inside,
	.normal = prism_normal,
	.flat_at = prism_flat_at,
};
