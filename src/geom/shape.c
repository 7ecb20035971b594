#include "geom/shape.h"

#include "geom/csg.h"
#include "geom/ray_box.h"

/* Boxes are kept larger than the shape by this part of their size, so that rounding never loses
 * a hit. */
static const double BOX_MARGIN = 1e-9;

static Box3 infinite_box(void)
{
	return (Box3){vec3_all(-INFINITY), vec3_all(INFINITY)};
}

/* The ray in the shape's own space: itself, or *own filled in. */
static const Ray *ray_into_shape(const Shape *shape, const Ray *ray, Ray *own)
{
	if (!shape->transform)
		return ray;
	*own = (Ray){transform_point_inverse(shape->transform, ray->origin),
		     transform_vector_inverse(shape->transform, ray->direction), ray->tmin,
		     ray->tmax};
	return own;
}

static Vec3 point_into_shape(const Shape *shape, Vec3 world)
{
	return shape->transform ? transform_point_inverse(shape->transform, world) : world;
}

static bool is_clipped_away(const Shape *shape, Vec3 world)
{
	for (int i = 0; i < shape->clip_count; i++)
		if (!shape_inside(shape->clip[i], world))
			return true;
	return false;
}

static bool bounding_is_missed(const Shape *bound, const Ray *ray)
{
	if (shape_inside(bound, ray->origin))
		return false;
	HitList list;
	Ray whole = {ray->origin, ray->direction, 0, ray->tmax};
	hit_list_init(&list);
	shape_intersect(bound, &whole, &list);
	bool missed = list.count == 0;
	hit_list_free(&list);
	return missed;
}

static bool is_missed(const Shape *shape, const Ray *ray)
{
	for (int i = 0; i < shape->bound_count; i++)
		if (bounding_is_missed(shape->bound[i], ray))
			return true;
	return false;
}

void shape_intersect(const Shape *shape, const Ray *ray, HitList *out)
{
	if (shape->bound_count && is_missed(shape, ray))
		return;
	int first = out->count;
	Ray own;
	shape->class->intersect(shape, ray_into_shape(shape, ray, &own), out);
	if (shape->clip_count == 0)
		return;
	int kept = first;
	for (int i = first; i < out->count; i++)
		if (!is_clipped_away(shape, ray_at(ray, out->hits[i].t)))
			out->hits[kept++] = out->hits[i];
	out->count = kept;
}

static bool nearest_in_list(const HitList *list, Hit *out)
{
	if (list->count == 0)
		return false;
	*out = list->hits[0];
	for (int i = 1; i < list->count; i++)
		if (list->hits[i].t < out->t)
			*out = list->hits[i];
	return true;
}

bool shape_nearest(const Shape *shape, const Ray *ray, Hit *out)
{
	if (shape->class->nearest && shape->clip_count == 0) {
		if (shape->bound_count && is_missed(shape, ray))
			return false;
		Ray own;
		return shape->class->nearest(shape, ray_into_shape(shape, ray, &own), out);
	}
	HitList list;
	hit_list_init(&list);
	shape_intersect(shape, ray, &list);
	bool found = nearest_in_list(&list, out);
	hit_list_free(&list);
	return found;
}

bool shape_inside(const Shape *shape, Vec3 world)
{
	if (shape->clip_count && is_clipped_away(shape, world))
		return false;
	if (!shape->class->inside)
		return false;
	return shape->class->inside(shape->data, point_into_shape(shape, world)) != shape->inverted;
}

bool shape_is_bounded(const Shape *shape)
{
	return vec3_is_finite(shape->box.lo) && vec3_is_finite(shape->box.hi);
}

static Box3 class_box(const Shape *shape)
{
	Box3 box;
	if (!shape->class->bounds(shape->data, &box))
		return infinite_box();
	return shape->transform ? transform_box(shape->transform, box) : box;
}

/* How far to move both ends of an interval of which either may be infinite. */
static double margin_of(double lo, double hi)
{
	double low = isinf(lo) ? 0 : fabs(lo), high = isinf(hi) ? 0 : fabs(hi);
	return BOX_MARGIN * (low > high ? low : high);
}

static Box3 box_with_margin(Box3 box)
{
	if (box3_is_empty(box))
		return box;
	Vec3 margin = vec3(margin_of(box.lo.x, box.hi.x), margin_of(box.lo.y, box.hi.y),
			   margin_of(box.lo.z, box.hi.z));
	return (Box3){vec3_sub(box.lo, margin), vec3_add(box.hi, margin)};
}

static Box3 clip_box(const Shape *shape, Box3 box)
{
	for (int i = 0; i < shape->clip_count; i++)
		box = shape_region_cut(shape->clip[i], box);
	return box;
}

/* A class whose inside is bounded, or cuts what is; CSG looks at its children. */
Box3 shape_region_cut(const Shape *shape, Box3 box)
{
	if (csg_is(shape))
		box = box3_intersect(box, csg_region_box(shape));
	else if (shape->class->cut && !shape->transform && !box3_is_empty(box))
		box = box3_intersect(
			box, box_with_margin(shape->class->cut(shape->data, shape->inverted, box)));
	else if (!shape->inverted && !shape->class->inside_unbounded)
		box = box3_intersect(box, box_with_margin(class_box(shape)));
	return clip_box(shape, box);
}

Box3 shape_region_box(const Shape *shape)
{
	return shape_region_cut(shape, infinite_box());
}

void shape_finish(Shape *shape)
{
	if (shape->transform && transform_is_identity(shape->transform))
		shape->transform = NULL;
	Box3 box = clip_box(shape, csg_is(shape) ? csg_surface_box(shape) : class_box(shape));
	/* A bound with a hole in it, inverted, bounds nothing. */
	for (int i = 0; i < shape->bound_count; i++)
		box = box3_intersect(box, shape_region_box(shape->bound[i]));
	shape->box = box_with_margin(box);
	shape->closed = shape->clip_count == 0 && shape->bound_count == 0 &&
			shape->class->closed && shape->class->closed(shape->data);
}

bool shape_class_is_closed(const void *data)
{
	(void)data;
	return true;
}

static Vec3 normal_to_world(const Hit *hit, Vec3 normal)
{
	const Shape *shape = hit->shape;
	if (shape->transform)
		normal = transform_normal(shape->transform, normal);
	if (shape->transform || !shape->class->unit_normal)
		normal = vec3_normalize(normal);
	return shape->inverted ? vec3_neg(normal) : normal;
}

Vec3 hit_normal(const Hit *hit, Vec3 world)
{
	const Shape *shape = hit->shape;
	return normal_to_world(
		hit, shape->class->normal(shape->data, hit, point_into_shape(shape, world)));
}

Vec3 hit_shading_normal_anyhow(const Hit *hit, Vec3 world)
{
	const Shape *shape = hit->shape;
	const ShapeClass *class = shape->class;
	Vec3 own = point_into_shape(shape, world);
	return normal_to_world(hit, class->shading_normal
					    ? class->shading_normal(shape->data, hit, own)
					    : class->normal(shape->data, hit, own));
}

bool hit_is_flat(const Hit *hit, Vec3 world, Vec3 shading)
{
	const ShapeClass *class = hit->shape->class;
	if (class->flat_at)
		return class->flat_at(hit->shape->data, hit);
	if (!class->flat || !class->shading_normal)
		return class->flat;
	if (class->bent && class->bent(hit->shape->data, hit))
		return false;
	return vec3_length2(vec3_cross(hit_normal(hit, world), shading)) < 1e-12;
}

Vec2 hit_uv(const Hit *hit, Vec3 world)
{
	const Shape *shape = hit->shape;
	if (!shape->class->uv)
		return (Vec2){world.x, world.y};
	return shape->class->uv(shape->data, hit, point_into_shape(shape, world));
}

int hit_textures(const Hit *hit, Vec3 world, ShapeTextures *out)
{
	const Shape *shape = hit->shape;
	out->count = 0;
	if (!shape->class->textures)
		return 0;
	return out->count = shape->class->textures(shape->data, hit, point_into_shape(shape, world),
						   out);
}
