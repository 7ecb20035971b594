/* Parametric surfaces: the points (x, y, z)(u, v) inside a container. A thin shell without
 * inside. hit.u and hit.v: where. */
#ifndef GEOM_PARAMETRIC_H
#define GEOM_PARAMETRIC_H

#include "base/arena.h"
#include "geom/container.h"
#include "geom/shape.h"

typedef Vec3 ParametricPoint(const void *function, double u, double v);

typedef struct ParametricDesc {
	ParametricPoint *point;
	const void *function;
	Vec2 lo, hi; /* range of (u, v) */
	Container container;
	double accuracy;     /* 0.001 */
	double max_gradient; /* largest partial derivative; 1 */
	int precompute;      /* depth of the table of bounds; 0: none */
} ParametricDesc;

ParametricDesc parametric_default(void);
/* NULL with *error set for an empty range. */
const void *parametric_create(Arena *arena, const ParametricDesc *desc, const char **error);
extern const ShapeClass parametric_class;

#endif
