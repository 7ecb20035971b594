/*
 * Constructive solid geometry over shapes in world space. A difference is an intersection whose
 * later children are inverted. A union keeps inner surfaces, a merge removes them.
 *
 * `inverted` on a CSG shape follows De Morgan: an inverted union or merge acts as the intersection
 * of its inverted children, an inverted intersection as their merge. The primitives inside still
 * report their own normals: csg_invert makes a copy whose primitives are inverted themselves.
 */
#ifndef GEOM_CSG_H
#define GEOM_CSG_H

#include "base/arena.h"
#include "geom/shape.h"

typedef struct CsgTree CsgTree;

typedef struct Csg {
	const Shape *const *children; /* finished (shape_finish) */
	int count;
	const CsgTree *tree; /* finds the children near a ray or point; NULL: looks at each */
} Csg;

extern const ShapeClass csg_union_class, csg_intersection_class, csg_merge_class;

/* Data for the three classes, with a tree when there are many children. children must outlive
 * it. */
const Csg *csg_create(Arena *arena, const Shape *const *children, int count);

/* Whether the data is a Csg. */
bool csg_is(const Shape *shape);
/* A finished copy of a finished shape with inside and outside swapped, down to the primitives. */
const Shape *csg_invert(Arena *arena, const Shape *shape);

/* For shape_finish: bounds of the surface of a CSG shape, whose children are finished. */
Box3 csg_surface_box(const Shape *shape);
/* And of its inside, infinite for inverted solids. */
Box3 csg_region_box(const Shape *shape);
/* Of any shape: bounds of where shape_inside holds (infinite for inverted solids). */
Box3 shape_region_box(const Shape *shape);
/* Bounds of where within the box it holds: a half space, or what a quadric encloses, cut off only
 * what others leave. */
Box3 shape_region_cut(const Shape *shape, Box3 box);

#endif
