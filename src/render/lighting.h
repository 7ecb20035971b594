/* What light sources do to a point of a surface: arrival, shadows, area lights. */
#ifndef RENDER_LIGHTING_H
#define RENDER_LIGHTING_H

#include "render/tracer.h"

/* A point that light falls on. */
typedef struct LitPoint {
	Vec3 p;
	const Surface *surface;
	const InsideStack *inside; /* of the ray that sees it */
	double footprint;          /* width of a sample's share of the picture there */
	Vec3 view, across;         /* the ray's direction, and the picture's horizontal */
} LitPoint;

/* Light of all sources that the surface sends to the viewer. */
Rgb lighting_at(Tracer *tracer, const LitPoint *at, const Bsdf *bsdf);

/* The share of the light, by colour, that comes from the point `from` of a source to p. */
Rgb shadow_visibility(Tracer *tracer, const LitPoint *at, int light, Vec3 direction,
		      double distance);

#endif
