/*
 * Which objects' insides a ray is in, in the order in which it entered them: for indices of
 * refraction, attenuation, and whether fog reaches here. A surface is known by its object and
 * interior: parts of a union with one interior are one, two objects with the same declared one are
 * not.
 */
#ifndef SCENE_INSIDE_H
#define SCENE_INSIDE_H

#include "scene/accel.h"
#include "scene/object.h"

enum { INSIDE_MAX = 24 }; /* deeper nesting is forgotten */

typedef struct InsideItem {
	const Interior *interior; /* or NULL */
	int id;                   /* the surface's object */
	bool hollow;
} InsideItem;

typedef struct InsideStack {
	int count;
	InsideItem items[INSIDE_MAX];
} InsideStack;

/* All that a place is in: where a path starts. */
void inside_start(InsideStack *stack, const Accel *accel, Vec3 place);
void inside_copy(InsideStack *to, const InsideStack *from);
/* The surface's entry, or -1: for those who ask several things at one crossing. */
static inline int inside_find(const InsideStack *stack, const Surface *surface)
{
	for (int i = stack->count - 1; i >= 0; i--) {
		const InsideItem *item = &stack->items[i];
		if (item->interior == surface->interior && item->id == surface->id)
			return i;
	}
	return -1;
}
bool inside_has(const InsideStack *stack, const Surface *surface);
/* Crossing the surface: leaves its inside if it was in, enters it if not. */
void inside_cross(InsideStack *stack, const Surface *surface);
void inside_cross_at(InsideStack *stack, int at, const Surface *surface);
/* True when the ray is in no object that is not hollow: fog and the sky's media are here. */
bool inside_is_open(const InsideStack *stack);
/* Index of refraction on this side of the surface over the other side's, for a ray about to cross
 * it. */
double inside_ratio(const InsideStack *stack, const Surface *surface);
/* The same for one colour of light: hue 0 is red, 1 is violet, 0.5 has the index that the scene
 * gives. */
double inside_ratio_of_hue(const InsideStack *stack, const Surface *surface, double hue);
/* What POV-Ray has in its place for Fresnel's share of a mirror: on the way out into another object
 * the surface's own index over that of the object entered last, which mostly is itself, so that
 * faces mirror nothing from inside there; measured. */
double inside_mirror_ratio_of_hue(const InsideStack *stack, const Surface *surface, double hue);
/* The index at the top of the stack, leaving out one entry (-1: none). */
static inline double inside_top_ior(const InsideStack *stack, int except, double hue)
{
	int top = stack->count - 1 - (stack->count - 1 == except);
	return top >= 0 && stack->items[top].interior
		       ? interior_ior(stack->items[top].interior, hue)
		       : 1;
}
/* With the surface's entry known, as inside_find gives it. */
static inline double inside_ratio_at(const InsideStack *stack, int at, const Surface *surface,
				     double hue)
{
	double here = inside_top_ior(stack, -1, hue);
	if (at >= 0)
		return here / inside_top_ior(stack, at, hue);
	return surface->interior ? here / interior_ior(surface->interior, hue) : here;
}

#endif
