#include "geom/plane.h"

/* Points this little above the plane still count as inside, so that a cut along the plane itself
 * is clean. */
static const double INSIDE_TOLERANCE = 1e-10;

const void *plane_create(Arena *arena, Vec3 normal, double distance, const char **error)
{
	if (vec3_length2(normal) == 0) {
		*error = "a plane's normal has no direction";
		return NULL;
	}
	Plane *plane = ARENA_NEW(arena, Plane);
	*plane = (Plane){vec3_normalize(normal), distance};
	return plane;
}

static const void *plane_placed(Arena *arena, const void *data, const Transform *transform)
{
	const Plane *plane = data;
	Plane *placed = ARENA_NEW(arena, Plane);
	placed->normal = vec3_normalize(transform_normal(transform, plane->normal));
	placed->distance = vec3_dot(
		placed->normal,
		transform_point(transform, vec3_scale(plane->normal, plane->distance)));
	return placed;
}

/* The least of n x over an interval; a factor 0 makes even an infinite end nothing. */
static double least_product(double n, double lo, double hi)
{
	return n == 0 ? 0 : n * (n > 0 ? lo : hi);
}

/* n.x x <= distance - (the least that y and z give), and so for each axis. */
static Box3 plane_cut(const void *data, bool outside, Box3 box)
{
	const Plane *plane = data;
	double *lo = &box.lo.x, *hi = &box.hi.x, sign = outside ? -1 : 1;
	double n[] = {sign * plane->normal.x, sign * plane->normal.y, sign * plane->normal.z};
	for (int i = 0; i < 3; i++) {
		int j = (i + 1) % 3, k = (i + 2) % 3;
		double most = sign * plane->distance - least_product(n[j], lo[j], hi[j]) -
			      least_product(n[k], lo[k], hi[k]);
		if (n[i] > 0 && most / n[i] < hi[i])
			hi[i] = most / n[i];
		if (n[i] < 0 && most / n[i] > lo[i])
			lo[i] = most / n[i];
	}
	return box;
}

static bool plane_bounds(const void *data, Box3 *box)
{
	(void)data;
	(void)box;
	return false;
}

static void plane_intersect(const Shape *self, const Ray *ray, HitList *out)
{
	double t;
	if (plane_cross(self->data, ray, &t))
		hit_list_add(out, ray, self, t, 0);
}

static bool plane_nearest(const Shape *self, const Ray *ray, Hit *out)
{
	double t;
	return plane_cross(self->data, ray, &t) && hit_take(out, ray, self, t, 0);
}

static bool plane_inside(const void *data, Vec3 p)
{
	const Plane *plane = data;
	return vec3_dot(plane->normal, p) - plane->distance < INSIDE_TOLERANCE;
}

static Vec3 plane_normal(const void *data, const Hit *hit, Vec3 p)
{
	(void)hit;
	(void)p;
	return ((const Plane *)data)->normal;
}

const ShapeClass plane_class = {
	.name = "plane",
	.flat = true,
	.bounds = plane_bounds,
	.intersect = plane_intersect,
	.inside = plane_inside,
	.normal = plane_normal,
	.nearest = plane_nearest,
	.cut = plane_cut,
	.placed = plane_placed,
	.quick = true,
	.unit_normal = true,
	.closed = shape_class_is_closed,
};
