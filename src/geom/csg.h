/*
 * Constructive solid geometry over shapes in world space. A difference is an intersection whose later children are
 * inverted. A union keeps inner surfaces, a merge removes them.
 */
#ifndef GEOM_CSG_H
#define GEOM_CSG_H

#include "base/arena.h"
#include "geom/shape.h"

typedef struct Csg {
	const Shape *const *children;
	int count;
} Csg;

extern const ShapeClass csg_union_class, csg_intersection_class, csg_merge_class;

#endif
