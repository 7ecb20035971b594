#include "geom/plane.h"

/* Points this little above the plane still count as inside, so that a cut along the plane itself
 * is clean. */
static const double INSIDE_TOLERANCE = 1e-10;

typedef struct Plane {
	Vec3 normal; /* unit */
	double distance;
} Plane;

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

static bool plane_bounds(const void *data, Box3 *box)
{
	(void)data;
	(void)box;
	return false;
}

static bool plane_cross(const Plane *plane, const Ray *ray, double *t)
{
	double slope = vec3_dot(plane->normal, ray->direction);
	*t = (plane->distance - vec3_dot(plane->normal, ray->origin)) / slope;
	return slope != 0;
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
	.bounds = plane_bounds,
	.intersect = plane_intersect,
	.inside = plane_inside,
	.normal = plane_normal,
	.nearest = plane_nearest,
};
