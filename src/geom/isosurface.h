/*
 * Isosurfaces: where a function of space equals a threshold, inside a container. The function is a
 * callback, so that this room needs to know nothing about how functions are made.
 */
#ifndef GEOM_ISOSURFACE_H
#define GEOM_ISOSURFACE_H

#include "base/arena.h"
#include "geom/container.h"
#include "geom/shape.h"

typedef double IsosurfaceValue(const void *function, Vec3 p);

typedef struct IsosurfaceDesc {
	IsosurfaceValue *value;
	const void *function;
	Container container;
	double threshold;    /* 0 */
	double accuracy;     /* 0.001: length of the last interval */
	double max_gradient; /* 1.1 */
	bool evaluate;       /* adapt the gradient from these three numbers */
	double evaluate_parameters[3];
	bool open;           /* no surface where the container cuts */
	int max_trace;       /* surfaces looked for along a ray: 1; 0: all_intersections */
} IsosurfaceDesc;

IsosurfaceDesc isosurface_default(void);
/* An accuracy or gradient that is not positive counts as the default. */
const void *isosurface_create(Arena *arena, const IsosurfaceDesc *desc);
extern const ShapeClass isosurface_class;

#endif
