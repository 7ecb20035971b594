/* The prism's own functions, for shapes that are made of prisms (text). Space: curves in xz, swept
 * along y. */
#ifndef GEOM_PRISM_H
#define GEOM_PRISM_H

#include "base/arena.h"
#include "geom/outline.h"
#include "geom/shape.h"

typedef struct Prism Prism;

/* A closed, linear one; the outline's segments must outlive it. */
Prism *prism_from_outline(Arena *arena, const Outline *outline, double low, double high);
/* Bounds. */
void prism_box(const Prism *prism, Box3 *box);
/* Pushes the crossings with hit's shape and v. */
void prism_cross(const Prism *prism, const Ray *ray, Hit hit, HitList *out);
/* Whether p is inside. */
bool prism_contains(const Prism *prism, Vec3 p);
/* Whether the hit is on an end or a side of a straight piece of the outline. */
bool prism_is_flat(const Prism *prism, const Hit *hit);
/* The outward normal at the hit, p: of any length. */
Vec3 prism_outward(const Prism *prism, const Hit *hit, Vec3 p);

#endif
