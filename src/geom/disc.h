/* A flat disc, perhaps with a hole. In CSG it divides space as its plane does: the side away
 * from the normal is inside. */
#ifndef GEOM_DISC_H
#define GEOM_DISC_H

#include "base/arena.h"
#include "geom/shape.h"

typedef struct DiscDesc {
	Vec3 center, normal; /* the normal of any length */
	double radius, hole; /* hole 0: none */
} DiscDesc;

/* A disc whose normal is zero is never hit. */
const void *disc_create(Arena *arena, const DiscDesc *desc);
extern const ShapeClass disc_class;

#endif
