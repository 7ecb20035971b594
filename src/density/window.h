/*
 * What a pixel sees of a surface: a parallelogram around the gather point, in which light is
 * counted.
 */
#ifndef DENSITY_WINDOW_H
#define DENSITY_WINDOW_H

#include "density/estimator.h"

/* x and y are dual to the sides: a point is inside when the products of both with what leads there
 * from at are within a half. */
typedef struct Window {
	double at[3], x[3], y[3];
	double area;
	Vec3 reach; /* from at to the sides of the box around it; its length: to the corners
		     or a little farther */
} Window;

/* As the point's pixel lies on the surface, or a square when that is not known; at least so wide.
 * Nothing is inside one without a width, whose area is 0. */
Window window_around(const GatherPoint *point, double least_width);
/* What leads from `from` to p, in the window's sides: with from = at, a place in the window. */
static inline void window_measure(const Window *w, const double from[3], const float p[3],
				  double *x, double *y)
{
	double d[3] = {p[0] - from[0], p[1] - from[1], p[2] - from[2]};
	*x = d[0] * w->x[0] + d[1] * w->x[1] + d[2] * w->x[2];
	*y = d[0] * w->y[0] + d[1] * w->y[1] + d[2] * w->y[2];
}

#endif
