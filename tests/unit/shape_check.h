/* What must hold for any shape, tried with random rays: used by the tests of the primitives. */
#ifndef TESTS_UNIT_SHAPE_CHECK_H
#define TESTS_UNIT_SHAPE_CHECK_H

#include <string.h>

#include "base/random.h"
#include "geom/shape.h"
#include "tests/unit/check.h"

static inline Shape test_shape(const ShapeClass *class, const void *data)
{
	Shape shape = {.class = class, .data = data};
	shape_finish(&shape);
	return shape;
}

static inline Vec3 test_point(Sampler *sampler, double size)
{
	double x = sampler_next(sampler) - 0.5, y = sampler_next(sampler) - 0.5,
	       z = sampler_next(sampler) - 0.5;
	return vec3(2 * size * x, 2 * size * y, 2 * size * z);
}

/* A ray from well outside of a ball of that size around the origin through a point of it; the
 * direction of any length. */
static inline Ray test_ray(Sampler *sampler, double size)
{
	Vec3 from = vec3_scale(vec3_normalize(test_point(sampler, 1)), 3 * size);
	double speed = 0.2 + sampler_next(sampler);
	return (Ray){from, vec3_scale(vec3_sub(test_point(sampler, 0.6 * size), from), speed), -1e9,
		     1e9};
}

/* What may be checked of a class. */
typedef struct ShapeTraits {
	const char *name;
	double size;      /* rays pass a ball of this size */
	double step;      /* inside must change within this distance of a crossing */
	bool no_inside;   /* a surface only */
	bool both_ways;   /* crossings where inside does not change are allowed */
	bool fixed;       /* CSG: has no transform of its own */
} ShapeTraits;

/* Inside must change at every crossing, and the normal point to the outside. */
static inline int test_crossings(const Shape *shape, const Ray *ray, const HitList *list,
				 const ShapeTraits *traits)
{
	double speed = vec3_length(ray->direction), step = traits->step / speed;
	int bad = 0;
	for (int i = 0; i < list->count; i++) {
		const Hit *hit = &list->hits[i];
		Vec3 p = ray_at(ray, hit->t), n = hit_normal(hit, p);
		bad += fabs(vec3_length(n) - 1) > 1e-6;
		/* Grazing and crowded crossings prove nothing. */
		double facing = vec3_dot(n, ray->direction) / speed;
		bool crowded = (i > 0 && hit->t - list->hits[i - 1].t < 4 * step) ||
		               (i + 1 < list->count && list->hits[i + 1].t - hit->t < 4 * step);
		if (traits->no_inside || crowded || fabs(facing) < 0.1)
			continue;
		bool before = shape_inside(shape, ray_at(ray, hit->t - step));
		bool after = shape_inside(shape, ray_at(ray, hit->t + step));
		bad += before == after ? !traits->both_ways : after != (facing < 0);
	}
	return bad;
}

/* nearest must be the least of all. */
static inline int test_nearest(const Shape *shape, const Ray *ray, const HitList *list)
{
	Hit hit;
	bool found = shape_nearest(shape, ray, &hit);
	if (found != (list->count > 0))
		return 1;
	return found && fabs(hit.t - list->hits[0].t) > 1e-9 * (1 + fabs(hit.t));
}

/* A ray that ends, and one that starts, between the first two crossings have the first and the
 * others; the latter's nearest is the second, within the step. */
static inline int test_ends(const Shape *shape, const Ray *ray, const HitList *list, double step)
{
	Ray before = *ray, after = *ray;
	HitList first, others;
	Hit hit;
	if (list->count < 2 || !(list->hits[1].t - list->hits[0].t > 1e-6))
		return 0;
	before.tmax = after.tmin = 0.5 * (list->hits[0].t + list->hits[1].t);
	hit_list_init(&first);
	hit_list_init(&others);
	shape_intersect(shape, &before, &first);
	shape_intersect(shape, &after, &others);
	int bad = first.count != 1 || others.count != list->count - 1 ||
		  !shape_nearest(shape, &after, &hit) ||
		  fabs(hit.t - list->hits[1].t) * vec3_length(ray->direction) > step;
	hit_list_free(&first);
	hit_list_free(&others);
	return bad;
}

static inline int test_in_box(const Shape *shape, const Ray *ray, const HitList *list)
{
	int bad = 0;
	for (int i = 0; i < list->count; i++)
		bad += !box3_contains(shape->box, ray_at(ray, list->hits[i].t));
	return bad;
}

/* The same data under a transform must be hit at the same parameters by the transformed ray. */
static inline int test_transformed(const Shape *shape, const Ray *ray, const HitList *list)
{
	Transform spin = transform_rotate(vec3(20, -50, 130)),
		  grow = transform_scale(vec3(2, 0.5, 3));
	Transform shift = transform_translate(vec3(5, -7, 1)),
		  both = transform_compose(&spin, &grow);
	Transform all = transform_compose(&both, &shift);
	Shape moved = *shape;
	moved.transform = &all;
	shape_finish(&moved);
	Ray world = {transform_point(&all, ray->origin), transform_vector(&all, ray->direction),
		     ray->tmin, ray->tmax};
	HitList other;
	hit_list_init(&other);
	shape_intersect(&moved, &world, &other);
	hit_list_sort(&other);
	int bad = other.count != list->count;
	for (int i = 0; i < list->count && i < other.count; i++) {
		bad += fabs(other.hits[i].t - list->hits[i].t) > 1e-6 * (1 + fabs(list->hits[i].t));
		Vec3 p = ray_at(&world, other.hits[i].t);
		bad += !box3_contains(moved.box, p);
		bad += fabs(vec3_length(hit_normal(&other.hits[i], p)) - 1) > 1e-9;
	}
	hit_list_free(&other);
	return bad;
}

/* Which of a ray's crossings are on flat faces (f), and which are not (c). */
static inline void check_flat(const Shape *shape, Ray ray, const char *wanted)
{
	HitList list;
	hit_list_init(&list);
	shape_intersect(shape, &ray, &list);
	hit_list_sort(&list);
	CHECK(list.count == (int)strlen(wanted));
	for (int i = 0; i < list.count && wanted[i]; i++) {
		Vec3 p = ray_at(&ray, list.hits[i].t);
		bool flat = hit_is_flat(&list.hits[i], p, hit_shading_normal(&list.hits[i], p));
		CHECK(flat == (wanted[i] == 'f'));
	}
	hit_list_free(&list);
}

/* Tries rays against the shape; rare misfits at grazing rays are forgiven, up to one ray in 200. */
static inline void check_shape(const Shape *shape, const ShapeTraits *traits, int rays)
{
	int bad = 0, moved = 0, hits = 0;
	for (int n = 0; n < rays; n++) {
		Sampler sampler = {11, (uint64_t)n, 0};
		Ray ray = test_ray(&sampler, traits->size);
		HitList list;
		hit_list_init(&list);
		shape_intersect(shape, &ray, &list);
		hit_list_sort(&list);
		hits += list.count;
		bad += test_crossings(shape, &ray, &list, traits) +
		       test_nearest(shape, &ray, &list) +
		       test_ends(shape, &ray, &list, traits->step);
		bad += test_in_box(shape, &ray, &list);
		moved += traits->fixed ? 0 : test_transformed(shape, &ray, &list);
		hit_list_free(&list);
	}
	if (hits < rays / 20 || bad > rays / 200 || moved > rays / 200) {
		check_failures++;
		printf("%s: %d rays, %d crossings, %d misfits, %d when moved\n", traits->name, rays,
		       hits, bad, moved);
	}
}

#endif
