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

/* What one pair of faces leaves of the interval t; false when nothing. */
static bool cross_slab(const double slab[2], double origin, double direction, int axis, double t[2],
		       int faces[2])
{
	if (direction == 0)
		return origin >= slab[0] && origin <= slab[1];
	bool up = direction > 0;
	double near = (slab[up ? 0 : 1] - origin) / direction,
	       far = (slab[up ? 1 : 0] - origin) / direction;
	if (near > t[0]) {
		t[0] = near;
		faces[0] = 2 * axis + (up ? 0 : 1);
	}
	if (far < t[1]) {
		t[1] = far;
		faces[1] = 2 * axis + (up ? 1 : 0);
	}
	return t[0] <= t[1];
}

bool box_cross(Box3 box, const Ray *ray, double t[2], int faces[2])
{
	Vec3 o = ray->origin, d = ray->direction;
	t[0] = -INFINITY;
	t[1] = INFINITY;
	return cross_slab((double[]){box.lo.x, box.hi.x}, o.x, d.x, 0, t, faces) &&
	       cross_slab((double[]){box.lo.y, box.hi.y}, o.y, d.y, 1, t, faces) &&
	       cross_slab((double[]){box.lo.z, box.hi.z}, o.z, d.z, 2, t, faces);
}

static bool box_bounds(const void *data, Box3 *box)
{
	*box = *(const Box3 *)data;
	return true;
}

static void box_intersect(const Shape *self, const Ray *ray, HitList *out)
{
	double t[2];
	int faces[2];
	if (!box_cross(*(const Box3 *)self->data, ray, t, faces))
		return;
	hit_list_add(out, ray, self, t[0], faces[0]);
	hit_list_add(out, ray, self, t[1], faces[1]);
}

static bool box_nearest(const Shape *self, const Ray *ray, Hit *out)
{
	double t[2];
	int faces[2];
	if (!box_cross(*(const Box3 *)self->data, ray, t, faces))
		return false;
	return hit_take(out, ray, self, t[0], faces[0]) || hit_take(out, ray, self, t[1], faces[1]);
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
};
