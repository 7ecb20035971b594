/* The space that a sphere sweeps as it moves along a spline while its radius changes. */
#ifndef GEOM_SPHERE_SWEEP_H
#define GEOM_SPHERE_SWEEP_H

#include "base/arena.h"
#include "geom/shape.h"

typedef enum SphereSweepKind {
	SPHERE_SWEEP_LINEAR,
	SPHERE_SWEEP_CUBIC,
	SPHERE_SWEEP_B_SPLINE
} SphereSweepKind;

typedef struct SphereSweepDesc {
	SphereSweepKind kind;
	const Vec3 *centers;
	const double *radii;
	int count;
	double tolerance; /* 1e-6 */
} SphereSweepDesc;

/* NULL with *error set for fewer than 2 spheres (linear) or 4 (the others). */
const void *sphere_sweep_create(Arena *arena, const SphereSweepDesc *desc, const char **error);
extern const ShapeClass sphere_sweep_class;

#endif
