#include "geom/box.h"

const void *box_create(Arena *arena, Vec3 corner, Vec3 opposite)
{
	Box3 *box = ARENA_NEW(arena, Box3);
	*box = (Box3){vec3_min(corner, opposite), vec3_max(corner, opposite)};
	return box;
}

static const void *box_placed(Arena *arena, const void *data, const Transform *transform)
{
	const Box3 *box = data;
	if (!transform_is_upright(transform))
		return NULL;
	return box_create(arena, transform_point(transform, box->lo),
			  transform_point(transform, box->hi));
}

typedef struct BoxCrossing {
	double near[3], far[3]; /* of each pair of faces; a NaN for a ray in a face's plane */
	double enter, leave;
} BoxCrossing;

static inline void cross_slab(double lo, double hi, double origin, double direction, int axis,
			      BoxCrossing *out)
{
	double inverse = 1 / direction;
	double a = (lo - origin) * inverse, b = (hi - origin) * inverse;
	double near = inverse < 0 ? b : a, far = inverse < 0 ? a : b;
	out->near[axis] = near;
	out->far[axis] = far;
	out->enter = real_max(near, out->enter); /* the second for a NaN */
	out->leave = real_min(far, out->leave);
}

static inline bool cross_faces(const Box3 *box, const Ray *ray, BoxCrossing *out)
{
	Vec3 o = ray->origin, d = ray->direction;
	out->enter = -INFINITY;
	out->leave = INFINITY;
	cross_slab(box->lo.x, box->hi.x, o.x, d.x, 0, out);
	cross_slab(box->lo.y, box->hi.y, o.y, d.y, 1, out);
	cross_slab(box->lo.z, box->hi.z, o.z, d.z, 2, out);
	return out->enter <= out->leave;
}

static int near_face(const BoxCrossing *at, const Ray *ray)
{
	int axis = at->near[0] == at->enter ? 0 : at->near[1] == at->enter ? 1 : 2;
	return 2 * axis + (vec3_axis(ray->direction, axis) < 0);
}

static int far_face(const BoxCrossing *at, const Ray *ray)
{
	int axis = at->far[0] == at->leave ? 0 : at->far[1] == at->leave ? 1 : 2;
	return 2 * axis + !(vec3_axis(ray->direction, axis) < 0);
}

bool box_cross(Box3 box, const Ray *ray, double t[2], int faces[2])
{
	BoxCrossing at;
	if (!cross_faces(&box, ray, &at))
		return false;
	t[0] = at.enter;
	t[1] = at.leave;
	faces[0] = near_face(&at, ray);
	faces[1] = far_face(&at, ray);
	return true;
}

static bool box_bounds(const void *data, Box3 *box)
{
	*box = *(const Box3 *)data;
	return true;
}

static void box_intersect(const Shape *self, const Ray *ray, HitList *out)
{
	BoxCrossing at;
	if (!cross_faces(self->data, ray, &at))
		return;
	hit_list_add(out, ray, self, at.enter, near_face(&at, ray));
	hit_list_add(out, ray, self, at.leave, far_face(&at, ray));
}

static bool box_nearest(const Shape *self, const Ray *ray, Hit *out)
{
	BoxCrossing at;
	if (!cross_faces(self->data, ray, &at) || at.leave <= ray->tmin || at.enter >= ray->tmax)
		return false;
	if (at.enter > ray->tmin)
		return hit_take(out, ray, self, at.enter, near_face(&at, ray));
	return hit_take(out, ray, self, at.leave, far_face(&at, ray));
}

static bool box_inside(const void *data, Vec3 p)
{
	return box3_contains(*(const Box3 *)data, p);
}

static Vec3 box_normal(const void *data, const Hit *hit, Vec3 p)
{
	static const Vec3 normals[] = {{-1, 0, 0}, {1, 0, 0},  {0, -1, 0},
				       {0, 1, 0},  {0, 0, -1}, {0, 0, 1}};
	(void)data;
	(void)p;
	return normals[hit->part];
}

/* The cross of six faces that POV-Ray unfolds over the unit square: 4 columns along u, 3 rows
 * along v. */
static Vec2 box_uv(const void *data, const Hit *hit, Vec3 p)
{
	const Box3 *box = data;
	Vec3 size = vec3_sub(box->hi, box->lo), from = vec3_sub(p, box->lo);
	double x = from.x / size.x / 4, z = from.z / size.z / 4;
	double y_row = (1 + from.y / size.y) / 3, z_row = from.z / size.z / 3;
	switch (hit->part) {
	case 0: return (Vec2){z, y_row};
	case 1: return (Vec2){0.75 - z, y_row};
	case 2: return (Vec2){0.25 + x, z_row};
	case 3: return (Vec2){0.25 + x, 1 - z_row};
	case 4: return (Vec2){1 - x, y_row};
	default: return (Vec2){0.25 + x, y_row};
	}
}

const ShapeClass box_class = {
	.name = "box",
	.flat = true,
	.bounds = box_bounds,
	.intersect = box_intersect,
	.inside = box_inside,
	.normal = box_normal,
	.uv = box_uv,
	.nearest = box_nearest,
	.placed = box_placed,
	.quick = true,
	.unit_normal = true,
	.closed = shape_class_is_closed,
};
