/*
 * A ray at the boundary of two clear bodies: Snell's law and Fresnel's equations, which share the
 * cosine within the second body and with it the square root.
 */
#ifndef SURFACE_REFRACTION_H
#define SURFACE_REFRACTION_H

#include "base/vec.h"

/* Indices that differ by less than this share bend no ray. */
static inline bool refraction_bends(double ior) { return fabs(ior - 1) >= 1e-10; }

typedef struct Refraction {
	double cosine; /* between the ray, turned round, and the normal on its side */
	double ior;    /* of the side that the ray comes from over the other's */
	double inner2, inner; /* cosine within the other body, its square first; inner2 under 0: the
				 ray is totally reflected, and inner is 0 */
} Refraction;

static inline Refraction refraction_of(double cosine, double ior)
{
	double inner2 = 1 - ior * ior * (1 - cosine * cosine);
	return (Refraction){cosine, ior, inner2, sqrt(real_max(inner2, 0))};
}

/* Fresnel's reflectance for unpolarised light. */
static inline double refraction_mirrored(const Refraction *at)
{
	if (at->inner2 <= 0)
		return 1;
	/* ((ior cosine - inner) / (ior cosine + inner))^2 and ((cosine - ior inner) / (cosine + ior
	 * inner))^2, halved, over one denominator: divisions are slow. */
	double a = at->ior * at->cosine, b = at->ior * at->inner;
	double across = a + at->inner, along = at->cosine + b;
	double s = (a - at->inner) * along, p = (at->cosine - b) * across, all = across * along;
	return (s * s + p * p) / (2 * all * all);
}

/* Where a ray that is not totally reflected goes on; direction and normal are unit. */
static inline Vec3 refraction_direction(const Refraction *at, Vec3 direction, Vec3 normal)
{
	return vec3_unit_again(vec3_mad(vec3_scale(direction, at->ior),
					at->ior * at->cosine - at->inner, normal));
}

#endif
