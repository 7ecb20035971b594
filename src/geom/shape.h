/*
 * A shape as the renderer sees it: a class (what it can do), the class' data in the shape's own
 * space, and a place in the world. Immutable once made; data may be shared by many shapes
 * (instances). CSG is a shape whose data are shapes.
 *
 * Rays keep their parameter: a class gets the world ray taken into its own space with the direction
 * NOT normalised again, so t means the same everywhere.
 *
 * A new shape is one .c file with a ShapeClass, one header with its data, and one row in lang's
 * table of words.
 */
#ifndef GEOM_SHAPE_H
#define GEOM_SHAPE_H

#include <stdbool.h>

#include "base/arena.h"
#include "base/transform.h"
#include "base/vec.h"

typedef struct Shape Shape;
typedef struct ShapeClass ShapeClass;

typedef struct Ray {
	Vec3 origin, direction;
	double tmin, tmax; /* only hits with tmin < t < tmax count */
} Ray;

static inline Vec3 ray_at(const Ray *ray, double t)
{
	return vec3_mad(ray->origin, t, ray->direction);
}

/* One crossing of a ray with a primitive's surface. part, u, v mean what the primitive's class
 * wants: a side, a triangle and its barycentrics, a spline segment... They are kept for the
 * class' own normal and uv. */
typedef struct Hit {
	double t;
	const Shape *shape; /* the primitive, never a CSG */
	int part;
	double u, v;
} Hit;

enum { HIT_LIST_INLINE = 24 };

/* Hits in any order. Start with hit_list_init; hit_list_free gives back what growing took. */
typedef struct HitList {
	Hit *hits;
	int count, capacity;
	Hit first[HIT_LIST_INLINE];
} HitList;

void hit_list_init(HitList *list);
void hit_list_free(HitList *list);
void hit_list_grow(HitList *list);
static inline void hit_list_push(HitList *list, Hit hit)
{
	if (list->count == list->capacity)
		hit_list_grow(list);
	list->hits[list->count++] = hit;
}
/* Sorts by increasing t. */
void hit_list_sort(HitList *list);
/* Pushes the crossing at t when it lies between the ray's ends. */
static inline void hit_list_add(HitList *list, const Ray *ray, const Shape *shape, double t,
				int part)
{
	if (t > ray->tmin && t < ray->tmax)
		hit_list_push(list, (Hit){.t = t, .shape = shape, .part = part});
}
/* For `nearest`: takes the crossing at t when it lies between the ray's ends. */
static inline bool hit_take(Hit *out, const Ray *ray, const Shape *shape, double t, int part)
{
	if (!(t > ray->tmin && t < ray->tmax))
		return false;
	*out = (Hit){.t = t, .shape = shape, .part = part};
	return true;
}
/* The first such of crossings that rise. */
static inline bool hit_take_first(Hit *out, const Ray *ray, const Shape *shape, const double *t,
				  int count)
{
	for (int i = 0; i < count; i++)
		if (hit_take(out, ray, shape, t[i], 0))
			return true;
	return false;
}

/* What a class may have that finds crossings in rising order: pushes at least the first `most` of
 * those between the ray's ends. */
typedef void ShapeCross(const Shape *self, const Ray *ray, int most, HitList *out);
/* Its `nearest`. */
bool hit_nearest_by(ShapeCross *cross, const Shape *self, const Ray *ray, Hit *out);

enum { SHAPE_MAX_TEXTURES = 16 };

/* Textures that cover a hit, by number, with weights that add up to 1. */
typedef struct ShapeTextures {
	int numbers[SHAPE_MAX_TEXTURES];
	double weights[SHAPE_MAX_TEXTURES];
	int count;
} ShapeTextures;

struct ShapeClass {
	const char *name; /* as in the scene language */
	/* Bounds in own space; false when unbounded. */
	bool (*bounds)(const void *data, Box3 *box);
	/* Pushes every crossing with ray->tmin < t < ray->tmax, in any order, with hit.shape =
	 * self. Tangent touches may be left out. scene ray already in own space. */
	void (*intersect)(const Shape *self, const Ray *ray, HitList *out);
	/* True when p (own space) is inside. NULL for a surface that has no inside (a triangle,
	 * a disc counts as half space: see its file). The Shape's inverted flag is applied by
	 * the caller. */
	bool (*inside)(const void *data, Vec3 p);
	/* Normal at own-space point p of a hit, in own space, outward for solids, any length. */
	Vec3 (*normal)(const void *data, const Hit *hit, Vec3 p);
	/* uv at own-space point p; NULL: POV-Ray's default (x and y of the point). */
	Vec2 (*uv)(const void *data, const Hit *hit, Vec3 p);
	/* Optional: the nearest crossing alone, for shapes where it is much cheaper than all;
	 * true when there is one. */
	bool (*nearest)(const Shape *self, const Ray *ray, Hit *out);
	/* Optional: a smooth shading normal that differs from the geometric one (meshes, height
	 * fields); own space. */
	Vec3 (*shading_normal)(const void *data, const Hit *hit, Vec3 p);
	/* Optional: which of the owner's several textures cover the hit (meshes with
	 * texture_list, blob components): fills out, returns how many; 0: the owner's one
	 * texture. Number -1 stands for the owner's texture. p: the hit's place in own space. */
	int (*textures)(const void *data, const Hit *hit, Vec3 p, ShapeTextures *out);
	/* Made of flat faces. */
	bool flat;
	/* Optional, where only some faces are flat: whether the hit's is. */
	bool (*flat_at)(const void *data, const Hit *hit);
	/* Optional, with shading_normal: true when that surely differs over the hit's face. */
	bool (*bent)(const void *data, const Hit *hit);
	/* nearest() costs about what a test against the box does, nobody need ask the box first;
	 * and it leaves *out alone when there is no crossing. */
	bool quick;
	/* normal() gives unit length. */
	bool unit_normal;
	/* inside() can hold outside of bounds(): a disc divides all space. */
	bool inside_unbounded;
	/* Optional: true when inside() changes along a ray only where intersect() finds a crossing:
	 * no open ends. */
	bool (*closed)(const void *data);
	/* Optional, for shapes without bounds: a box around what of `box` (own space, sides may be
	 * infinite) lies inside the shape, or outside of it. */
	Box3 (*cut)(const void *data, bool outside, Box3 box);
	/* Optional: data that are the same shape with the transform taken in, so that no ray needs
	 * to be; NULL when there are none. */
	const void *(*placed)(Arena *arena, const void *data, const Transform *transform);
};

struct Shape {
	const ShapeClass *class;
	const void *data;
	const Transform *transform; /* own space to world; NULL: the same. CSG has none: its
				       children carry theirs */
	bool inverted; /* inside and outside swapped: `inverse`, and what a difference takes away */
	const Shape *const *clip;   /* clipped_by: crossings outside any of these do not count */
	int clip_count;
	const Shape *const
		*bound; /* bounded_by: a ray that misses all of one of these misses the shape */
	int bound_count;
	Box3 box; /* world bounds (clip included); infinite sides where unbounded */
	bool closed; /* the class says so, and no clip or bound takes crossings away */
	bool part;                  /* of a CSG: a crossing of this shape alone says nothing */
	const void *owner; /* what the scene attached to a primitive: its Surface. Opaque here */
};

/* For classes that are closed whatever their data. */
bool shape_class_is_closed(const void *data);

/* Fills in box and closed from the class, the transform, the clips and the bounds. Call once, last.
 */
void shape_finish(Shape *shape);

/* Every crossing of a world ray with the shape, CSG and clipping applied, in any order. */
void shape_intersect(const Shape *shape, const Ray *ray, HitList *out);
/* The nearest one; false when there is none. */
bool shape_nearest(const Shape *shape, const Ray *ray, Hit *out);
/* Whether the point, of world space, is inside and not clipped away; never of a mere surface. */
bool shape_inside(const Shape *shape, Vec3 world);
/* Whether its box is finite. */
bool shape_is_bounded(const Shape *shape);

/* At a hit on a primitive, world space, unit length. The geometric normal points outward
 * (inverted shapes: inward). */
Vec3 hit_normal(const Hit *hit, Vec3 world);
/* What smooth triangles interpolate; of others the geometric one. */
Vec3 hit_shading_normal_anyhow(const Hit *hit, Vec3 world);
/* The same, at once for shapes of which the class alone says all. */
static inline Vec3 hit_shading_normal(const Hit *hit, Vec3 world)
{
	const Shape *shape = hit->shape;
	const ShapeClass *class = shape->class;
	if (shape->transform || !class->unit_normal || class->shading_normal || shape->inverted)
		return hit_shading_normal_anyhow(hit, world);
	return class->normal(shape->data, hit, world);
}
/* Whether the surface is flat and shaded as such up to the edge of a face. shading: what
 * hit_shading_normal gives, on either side. */
bool hit_is_flat(const Hit *hit, Vec3 world, Vec3 shading);
/* The class' (u, v), in 0..1 as a rule; x and y where it has none. */
Vec2 hit_uv(const Hit *hit, Vec3 world);
/* Which of the owner's numbered textures cover the hit; 0: the owner's one texture alone. */
int hit_textures(const Hit *hit, Vec3 world, ShapeTextures *out);

#endif
