/*
 * In the frame of the axis: z along it from the base, the rest across. The side is |across|^2 = (r0
 * + slope z)^2 for 0 <= z <= height. Radii of different sign make a double cone.
 */
#include "geom/cone.h"

#include "geom/polynomial.h"

typedef struct Cone {
	Vec3 base, axis; /* axis: unit, towards the cap */
	double height, base_radius, cap_radius;
	double slope;    /* of the radius along the axis */
	bool open;
} Cone;

enum { PART_SIDE, PART_BASE, PART_CAP };

const void *cone_create(Arena *arena, const ConeDesc *desc, const char **error)
{
	double height = vec3_distance(desc->base, desc->cap);
	if (!(height > 0)) {
		*error = "base and cap are the same point";
		return NULL;
	}
	Cone *cone = ARENA_NEW(arena, Cone);
	cone->base = desc->base;
	cone->axis = vec3_normalize(vec3_sub(desc->cap, desc->base));
	cone->height = height;
	double sign = desc->base_radius < 0 && desc->cap_radius < 0 ? -1 : 1;
	cone->base_radius = sign * desc->base_radius;
	cone->cap_radius = sign * desc->cap_radius;
	cone->slope = (cone->cap_radius - cone->base_radius) / height;
	cone->open = desc->open;
	return cone;
}

static bool cone_bounds(const void *data, Box3 *box)
{
	const Cone *cone = data;
	Vec3 a = cone->axis, cap = vec3_mad(cone->base, cone->height, a);
	Vec3 across = vec3(sqrt(fmax(0, 1 - a.x * a.x)), sqrt(fmax(0, 1 - a.y * a.y)),
			   sqrt(fmax(0, 1 - a.z * a.z)));
	Vec3 low = vec3_scale(across, fabs(cone->base_radius)),
	     high = vec3_scale(across, fabs(cone->cap_radius));
	*box = (Box3){vec3_min(vec3_sub(cone->base, low), vec3_sub(cap, high)),
	              vec3_max(vec3_add(cone->base, low), vec3_add(cap, high))};
	return true;
}

/* Splits v into its part along the axis and the rest. */
static double cone_split(const Cone *cone, Vec3 v, Vec3 *across)
{
	double along = vec3_dot(v, cone->axis);
	*across = vec3_mad(v, -along, cone->axis);
	return along;
}

/* A ray seen from the axis, its origin moved to the point nearest to the middle of the cone,
 * which keeps far origins exact. */
typedef struct ConeRay {
	double shift; /* what was added to t = 0 */
	Vec3 across, across_step;
	double along, along_step;
} ConeRay;

static ConeRay cone_ray(const Cone *cone, const Ray *ray)
{
	ConeRay out;
	Vec3 middle = vec3_mad(cone->base, 0.5 * cone->height, cone->axis);
	out.shift = vec3_dot(vec3_sub(middle, ray->origin), ray->direction) /
		    vec3_length2(ray->direction);
	Vec3 start = vec3_sub(ray_at(ray, out.shift), cone->base);
	out.along = cone_split(cone, start, &out.across);
	out.along_step = cone_split(cone, ray->direction, &out.across_step);
	return out;
}

static int cross_side(const Cone *cone, const ConeRay *ray, Hit hits[4])
{
	double radius = cone->base_radius + cone->slope * ray->along,
	       radius_step = cone->slope * ray->along_step;
	double roots[2];
	int count = polynomial_quadratic(
		vec3_length2(ray->across_step) - radius_step * radius_step,
		2 * (vec3_dot(ray->across, ray->across_step) - radius * radius_step),
		vec3_length2(ray->across) - radius * radius, roots);
	int kept = 0;
	for (int i = 0; i < count; i++) {
		double z = ray->along + roots[i] * ray->along_step;
		if (z >= 0 && z <= cone->height)
			hits[kept++] = (Hit){.t = roots[i] + ray->shift, .part = PART_SIDE};
	}
	return kept;
}

static int cross_disc(const ConeRay *ray, double z, double radius, Hit *hit)
{
	double t = (z - ray->along) / ray->along_step;
	Vec3 across = vec3_mad(ray->across, t, ray->across_step);
	hit->t = t + ray->shift;
	return vec3_length2(across) <= radius * radius;
}

/* All crossings, whatever the ray's ends; at most 4 by rounding at the rims. */
static int cone_cross(const Cone *cone, const Ray *world, Hit hits[4])
{
	ConeRay ray = cone_ray(cone, world);
	int count = cross_side(cone, &ray, hits);
	if (cone->open || count == 2 || ray.along_step == 0)
		return count;
	hits[count].part = PART_BASE;
	count += cross_disc(&ray, 0, cone->base_radius, &hits[count]);
	hits[count].part = PART_CAP;
	count += cross_disc(&ray, cone->height, cone->cap_radius, &hits[count]);
	return count;
}

static void cone_intersect(const Shape *self, const Ray *ray, HitList *out)
{
	Hit hits[4];
	int count = cone_cross(self->data, ray, hits);
	for (int i = 0; i < count; i++)
		hit_list_add(out, ray, self, hits[i].t, hits[i].part);
}

static bool cone_nearest(const Shape *self, const Ray *ray, Hit *out)
{
	Hit hits[4];
	int count = cone_cross(self->data, ray, hits);
	Ray left = *ray;
	bool found = false;
	for (int i = 0; i < count; i++) {
		if (!hit_take(out, &left, self, hits[i].t, hits[i].part))
			continue;
		left.tmax = hits[i].t;
		found = true;
	}
	return found;
}

static bool cone_inside(const void *data, Vec3 p)
{
	const Cone *cone = data;
	Vec3 across;
	double z = cone_split(cone, vec3_sub(p, cone->base), &across);
	double radius = cone->base_radius + cone->slope * z;
	return z >= 0 && z <= cone->height && vec3_length2(across) <= radius * radius;
}

static bool cone_closed(const void *data)
{
	return !((const Cone *)data)->open;
}

static Vec3 cone_normal(const void *data, const Hit *hit, Vec3 p)
{
	const Cone *cone = data;
	if (hit->part == PART_BASE)
		return vec3_neg(cone->axis);
	if (hit->part == PART_CAP)
		return cone->axis;
	Vec3 across;
	double z = cone_split(cone, vec3_sub(p, cone->base), &across);
	return vec3_mad(across, -cone->slope * (cone->base_radius + cone->slope * z), cone->axis);
}

/* The ends. */
static bool cone_flat_at(const void *data, const Hit *hit)
{
	(void)data;
	return hit->part != PART_SIDE;
}

const ShapeClass cone_class = {
	.name = "cone",
	.bounds = cone_bounds,
	.intersect = cone_intersect,
	.inside = cone_inside,
	.normal = cone_normal,
	.flat_at = cone_flat_at,
	.nearest = cone_nearest,
	.closed = cone_closed,
};

const ShapeClass cylinder_class = {
	.name = "cylinder",
	.bounds = cone_bounds,
	.intersect = cone_intersect,
	.inside = cone_inside,
	.normal = cone_normal,
	.flat_at = cone_flat_at,
	.nearest = cone_nearest,
	.closed = cone_closed,
};
