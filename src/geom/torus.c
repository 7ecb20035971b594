/*
 * (|p|^2 + R^2 - r^2)^2 = 4 R^2 (x^2 + z^2): a quartic along the ray. The ray's origin is first
 * moved to the middle of the piece that can touch the torus, which keeps the coefficients small
 * however far the camera is.
 */
#include "geom/torus.h"

#include "geom/polynomial.h"
#include "geom/ray_box.h"
#include "geom/sphere.h"

typedef struct Torus {
	double major, minor;
} Torus;

const void *torus_create(Arena *arena, double major, double minor)
{
	Torus *torus = ARENA_NEW(arena, Torus);
	*torus = (Torus){fabs(major), fmax(0, minor)};
	return torus;
}

static bool torus_bounds(const void *data, Box3 *box)
{
	const Torus *torus = data;
	double wide = torus->major + torus->minor;
	*box = (Box3){vec3(-wide, -torus->minor, -wide), vec3(wide, torus->minor, wide)};
	return true;
}

/* The piece of the line within the sphere and between the planes around the torus. */
static bool torus_near(const Torus *torus, const Ray *ray, double t[2])
{
	static const double MARGIN = 1 + 1e-9;
	if (!sphere_cross(vec3_all(0), (torus->major + torus->minor) * MARGIN, ray, t))
		return false;
	double high = torus->minor * MARGIN;
	ray_slabs_clip(-high, high, ray->origin.y, 1 / ray->direction.y, t);
	return t[0] < t[1];
}

/* Coefficients of the quartic for the line o + s d. */
static void torus_quartic(const Torus *torus, Vec3 o, Vec3 d, double c[5])
{
	double k = 4 * torus->major * torus->major;
	double a = vec3_dot(d, d), b = 2 * vec3_dot(o, d);
	double h = vec3_dot(o, o) + (torus->major - torus->minor) * (torus->major + torus->minor);
	c[4] = a * a;
	c[3] = 2 * a * b;
	c[2] = b * b + 2 * a * h - k * (d.x * d.x + d.z * d.z);
	c[1] = 2 * b * h - 2 * k * (o.x * d.x + o.z * d.z);
	c[0] = h * h - k * (o.x * o.x + o.z * o.z);
}

static int torus_cross(const Torus *torus, const Ray *ray, double t[4])
{
	double near[2], c[5];
	if (torus->minor == 0 || !torus_near(torus, ray, near) || near[1] <= ray->tmin ||
	    near[0] >= ray->tmax)
		return 0;
	double middle = 0.5 * (near[0] + near[1]), half = 0.5 * (near[1] - near[0]);
	torus_quartic(torus, ray_at(ray, middle), ray->direction, c);
	int count = polynomial_roots(c, 4, -half, half, t);
	for (int i = 0; i < count; i++)
		t[i] += middle;
	return count;
}

static void torus_intersect(const Shape *self, const Ray *ray, HitList *out)
{
	double t[4];
	int count = torus_cross(self->data, ray, t);
	for (int i = 0; i < count; i++)
		hit_list_add(out, ray, self, t[i], 0);
}

static bool torus_nearest(const Shape *self, const Ray *ray, Hit *out)
{
	double t[4];
	return hit_take_first(out, ray, self, t, torus_cross(self->data, ray, t));
}

static bool torus_inside(const void *data, Vec3 p)
{
	const Torus *torus = data;
	double across = sqrt(p.x * p.x + p.z * p.z) - torus->major;
	return across * across + p.y * p.y < torus->minor * torus->minor;
}

static Vec3 torus_normal(const void *data, const Hit *hit, Vec3 p)
{
	const Torus *torus = data;
	(void)hit;
	double distance = sqrt(p.x * p.x + p.z * p.z);
	if (distance == 0)
		return vec3(0, p.y, 0);
	double inner = torus->major / distance;
	return vec3(p.x - p.x * inner, p.y, p.z - p.z * inner);
}

/* u goes round the axis, v round the tube. */
static Vec2 torus_uv(const void *data, const Hit *hit, Vec3 p)
{
	const Torus *torus = data;
	(void)hit;
	double across = sqrt(p.x * p.x + p.z * p.z) - torus->major;
	return (Vec2){0.5 - atan2(p.z, p.x) / (2 * M_PI), 0.5 + atan2(p.y, across) / (2 * M_PI)};
}

const ShapeClass torus_class = {
	.name = "torus",
	.bounds = torus_bounds,
	.intersect = torus_intersect,
	.inside = torus_inside,
	.normal = torus_normal,
	.uv = torus_uv,
	.nearest = torus_nearest,
	.closed = shape_class_is_closed,
};
