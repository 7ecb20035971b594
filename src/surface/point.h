/* What a pattern, pigment, normal or texture may know about the place where it is evaluated. */
#ifndef SURFACE_POINT_H
#define SURFACE_POINT_H

#include "base/vec.h"

typedef struct SurfacePoint {
	Vec3 p; /* the point, in the space of whoever is asked; each level passes on its own */
	Vec3 normal;    /* unit, world space: the shading normal before perturbation */
	Vec3 direction; /* unit, world space: where the ray goes */
	Vec2 uv;
	Vec3 world;     /* the point in world space */
} SurfacePoint;

#endif
