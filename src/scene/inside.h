/*
 * Which objects' insides a ray is in, in the order in which it entered them: for indices of
 * refraction, attenuation, and whether fog reaches here. A surface is known by its object and
 * interior: parts of a union with one interior are one, two objects with the same declared one are
 * not.
 */
#ifndef SCENE_INSIDE_H
#define SCENE_INSIDE_H

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

void inside_copy(InsideStack *to, const InsideStack *from);
/* The surface's entry, or -1: for those who ask several things at one crossing. */
int inside_find(const InsideStack *stack, const Surface *surface);
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
double inside_ratio_at(const InsideStack *stack, int at, const Surface *surface, double hue);

#endif
