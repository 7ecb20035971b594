#include "geom/disc.h"

typedef struct Disc {
	Vec3 center, normal; /* unit */
	double radius2, hole2;
	double radius;
} Disc;

const void *disc_create(Arena *arena, const DiscDesc *desc)
{
	Disc *disc = ARENA_NEW(arena, Disc);
	disc->center = desc->center;
	disc->normal = vec3_normalize(desc->normal);
	disc->radius = fabs(desc->radius);
	disc->radius2 = desc->radius * desc->radius;
	disc->hole2 = desc->hole * desc->hole;
	return disc;
}

static bool disc_bounds(const void *data, Box3 *box)
{
	const Disc *disc = data;
	Vec3 n = disc->normal;
	Vec3 half = vec3(sqrt(fmax(0, 1 - n.x * n.x)), sqrt(fmax(0, 1 - n.y * n.y)),
			 sqrt(fmax(0, 1 - n.z * n.z)));
	half = vec3_scale(half, disc->radius);
	*box = (Box3){vec3_sub(disc->center, half), vec3_add(disc->center, half)};
	return true;
}

static bool disc_nearest(const Shape *self, const Ray *ray, Hit *out)
{
	const Disc *disc = self->data;
	double slope = vec3_dot(disc->normal, ray->direction);
	if (slope == 0)
		return false;
	double t = vec3_dot(disc->normal, vec3_sub(disc->center, ray->origin)) / slope;
	double r2 = vec3_length2(vec3_sub(ray_at(ray, t), disc->center));
	return r2 >= disc->hole2 && r2 <= disc->radius2 && hit_take(out, ray, self, t, 0);
}

static void disc_intersect(const Shape *self, const Ray *ray, HitList *out)
{
	Hit hit;
	if (disc_nearest(self, ray, &hit))
		hit_list_push(out, hit);
}

static bool disc_inside(const void *data, Vec3 p)
{
	const Disc *disc = data;
	return vec3_dot(disc->normal, vec3_sub(p, disc->center)) < 0;
}

static Vec3 disc_normal(const void *data, const Hit *hit, Vec3 p)
{
	(void)hit;
	(void)p;
	return ((const Disc *)data)->normal;
}

const ShapeClass disc_class = {
	.name = "disc",
	.flat = true,
	.bounds = disc_bounds,
	.intersect = disc_intersect,
	.inside = disc_inside,
	.normal = disc_normal,
	.nearest = disc_nearest,
	.inside_unbounded = true,
	.quick = true,
	.unit_normal = true,
};
