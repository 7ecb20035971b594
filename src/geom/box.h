/* A box along the axes. hit.part: 0 1 2 3 4 5 for the faces at low x, high x, low y, high y, low
 * z, high z. */
#ifndef GEOM_BOX_H
#define GEOM_BOX_H

#include "base/arena.h"
#include "geom/shape.h"

/* Any two opposite corners. A box without thickness is hit twice at the same place. */
const void *box_create(Arena *arena, Vec3 corner, Vec3 opposite);
extern const ShapeClass box_class;

/* The part of the line that lies in the box, whatever the ray's own ends; faces get the numbers
 * of the faces entered and left. False when it misses. */
bool box_cross(Box3 box, const Ray *ray, double t[2], int faces[2]);

#endif
