/*
 * In the half plane (r, y): an arc of the bottom circle, one of the top circle, and between them an
 * arc that touches both from outside, whose centre (-h, v) lies across the axis: turned about y,
 * the inner leaf of a spindle torus. The arc's radius is twice the larger of the two.
 */
#include "geom/ovus.h"

#include "geom/polynomial.h"
#include "geom/ray_box.h"
#include "geom/sphere.h"

typedef struct Ovus {
	double bottom, top;       /* radii */
	double arc;               /* radius of the connecting arc; 0: the top sphere is all */
	double across, height;    /* h and v */
	double low, high;         /* where the arc meets the bottom and the top circle */
} Ovus;

enum { PART_BOTTOM, PART_TOP, PART_ARC };

const void *ovus_create(Arena *arena, double bottom_radius, double top_radius, const char **error)
{
	if (!(bottom_radius >= 0 && top_radius >= 0)) {
		*error = "the radii of an ovus must not be negative";
		return NULL;
	}
	Ovus *ovus = ARENA_NEW(arena, Ovus);
	ovus->bottom = bottom_radius;
	ovus->top = top_radius;
	if (top_radius >= 2 * bottom_radius) {
		ovus->low = ovus->high = -INFINITY;
		return ovus;
	}
	/* |(-h, v)| = arc - bottom and |(-h, v) - (0, bottom)| = arc - top. */
	ovus->arc = 2 * fmax(bottom_radius, top_radius);
	double to_bottom = ovus->arc - bottom_radius, to_top = ovus->arc - top_radius;
	ovus->height = ((to_bottom - to_top) * (to_bottom + to_top) / bottom_radius +
			bottom_radius) /
		       2;
	ovus->across = sqrt(fmax(0, to_bottom * to_bottom - ovus->height * ovus->height));
	ovus->low = -ovus->height * bottom_radius / to_bottom;
	ovus->high = bottom_radius + (bottom_radius - ovus->height) * top_radius / to_top;
	return ovus;
}

static bool ovus_bounds(const void *data, Box3 *box)
{
	const Ovus *ovus = data;
	double wide = fmax(fmax(ovus->bottom, ovus->top), ovus->arc - ovus->across);
	double floor = ovus->arc > 0 ? -ovus->bottom : ovus->bottom - ovus->top;
	*box = (Box3){vec3(-wide, floor, -wide), vec3(wide, ovus->bottom + ovus->top, wide)};
	return true;
}

static void cross_spheres(const Shape *self, const Ray *ray, HitList *out)
{
	const Ovus *ovus = self->data;
	double t[2];
	if (ovus->arc > 0 && sphere_cross(vec3_all(0), ovus->bottom, ray, t))
		for (int i = 0; i < 2; i++)
			if (ray_at(ray, t[i]).y < ovus->low)
				hit_list_add(out, ray, self, t[i], PART_BOTTOM);
	if (sphere_cross(vec3(0, ovus->bottom, 0), ovus->top, ray, t))
		for (int i = 0; i < 2; i++)
			if (ray_at(ray, t[i]).y > ovus->high)
				hit_list_add(out, ray, self, t[i], PART_TOP);
}

/* What the ray has between the arc's two ends, in a parameter from *middle on; false when
 * nothing. */
static bool arc_span(const Ovus *ovus, const Ray *ray, double *middle, double *half)
{
	double t[2], widest = 2 * (ovus->bottom + ovus->top);
	if (!sphere_cross(vec3_all(0), widest, ray, t))
		return false;
	ray_slabs_clip(ovus->low, ovus->high, ray->origin.y, 1 / ray->direction.y, t);
	*middle = 0.5 * (t[0] + t[1]);
	*half = 0.5 * (t[1] - t[0]);
	return t[0] < t[1];
}

/* (|q|^2 + h^2 - arc^2)^2 = 4 h^2 (x^2 + z^2) with q = p - (0, v, 0); on the inner leaf the
 * bracket is negative. */
static void cross_arc(const Shape *self, const Ray *ray, HitList *out)
{
	const Ovus *ovus = self->data;
	double middle, half, roots[4], k = 4 * ovus->across * ovus->across;
	if (!(ovus->arc > 0) || !arc_span(ovus, ray, &middle, &half))
		return;
	Vec3 q = vec3_sub(ray_at(ray, middle), vec3(0, ovus->height, 0)), d = ray->direction;
	double a = vec3_dot(d, d), b = 2 * vec3_dot(q, d);
	double c = vec3_dot(q, q) + (ovus->across - ovus->arc) * (ovus->across + ovus->arc);
	double quartic[5] = {c * c - k * (q.x * q.x + q.z * q.z),
			     2 * b * c - 2 * k * (q.x * d.x + q.z * d.z),
			     b * b + 2 * a * c - k * (d.x * d.x + d.z * d.z), 2 * a * b, a * a};
	int count = polynomial_roots(quartic, 4, -half, half, roots);
	for (int i = 0; i < count; i++)
		if ((a * roots[i] + b) * roots[i] + c <= 0)
			hit_list_add(out, ray, self, middle + roots[i], PART_ARC);
}

static void ovus_intersect(const Shape *self, const Ray *ray, HitList *out)
{
	cross_spheres(self, ray, out);
	cross_arc(self, ray, out);
}

static bool ovus_inside(const void *data, Vec3 p)
{
	const Ovus *ovus = data;
	if (p.y > ovus->high)
		return vec3_length2(vec3_sub(p, vec3(0, ovus->bottom, 0))) < ovus->top * ovus->top;
	if (p.y < ovus->low)
		return vec3_length2(p) < ovus->bottom * ovus->bottom;
	double r = sqrt(p.x * p.x + p.z * p.z) + ovus->across, y = p.y - ovus->height;
	return r * r + y * y < ovus->arc * ovus->arc;
}

static Vec3 ovus_normal(const void *data, const Hit *hit, Vec3 p)
{
	const Ovus *ovus = data;
	if (hit->part == PART_BOTTOM)
		return p;
	if (hit->part == PART_TOP)
		return vec3_sub(p, vec3(0, ovus->bottom, 0));
	double r = sqrt(p.x * p.x + p.z * p.z), stretch = r > 0 ? (r + ovus->across) / r : 1;
	return vec3(p.x * stretch, p.y - ovus->height, p.z * stretch);
}

/* As on a sphere around a point half a top radius up. */
static Vec2 ovus_uv(const void *data, const Hit *hit, Vec3 p)
{
	const Ovus *ovus = data;
	(void)hit;
	return sphere_uv_of(vec3_sub(p, vec3(0, 0.5 * ovus->top, 0)));
}

const ShapeClass ovus_class = {
	.name = "ovus",
	.bounds = ovus_bounds,
	.intersect = ovus_intersect,
	.inside = ovus_inside,
	.normal = ovus_normal,
	.uv = ovus_uv,
};
