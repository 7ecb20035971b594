/* The slab test of a ray against world boxes, for many boxes a ray. */
#ifndef GEOM_RAY_BOX_H
#define GEOM_RAY_BOX_H

#include "geom/shape.h"

typedef struct RaySlabs {
	Vec3 origin, inverse; /* 1 / direction; infinite for a direction in the plane of the slab */
	double tmin, tmax;
} RaySlabs;

static inline RaySlabs ray_slabs(const Ray *ray)
{
	Vec3 d = ray->direction;
	return (RaySlabs){ray->origin, vec3(1 / d.x, 1 / d.y, 1 / d.z), ray->tmin, ray->tmax};
}

/* What a slab leaves of the interval t. A NaN, from a ray in the very plane of the slab's side,
 * leaves it as it is: comparing with it is false, so these comparisons stand as they do. */
static inline void ray_slabs_clip(double lo, double hi, double origin, double inverse, double t[2])
{
	double a = (lo - origin) * inverse, b = (hi - origin) * inverse;
	double near = inverse < 0 ? b : a, far = inverse < 0 ? a : b;
	t[0] = near > t[0] ? near : t[0];
	t[1] = far < t[1] ? far : t[1];
}

/* The part of the ray that is in the box: from t[0] to t[1]; t[0] > t[1] when none is. */
static inline void ray_slabs_range(const RaySlabs *ray, const Box3 *box, double t[2])
{
	t[0] = ray->tmin;
	t[1] = ray->tmax;
	ray_slabs_clip(box->lo.x, box->hi.x, ray->origin.x, ray->inverse.x, t);
	ray_slabs_clip(box->lo.y, box->hi.y, ray->origin.y, ray->inverse.y, t);
	ray_slabs_clip(box->lo.z, box->hi.z, ray->origin.z, ray->inverse.z, t);
}

/* True when the ray may hit something in the box, which should be a little larger than what it
 * holds. */
static inline bool ray_slabs_hit(const RaySlabs *ray, const Box3 *box)
{
	double t[2];
	ray_slabs_range(ray, box, t);
	return t[0] <= t[1];
}

#endif
