/*
 * Where photons leave a light, and the emitter coordinates they keep (Spencer & Jones 2013,
 * section 4.1).
 *
 *   parallel and cylinder lights   2-D origin on the plane through the light's position across its
 * axis, in scene units, relative to the position: with the world position a 5-D tree point lights
 * exit direction on the unit sphere: a 6-D tree spotlights                     exit direction on
 * the unit hemisphere: a 6-D tree area lights                    exit direction alone. Direction
 * and point together have four dimensions, but a caustic's structure is made by the direction; the
 * point only blurs it, by the light's size over its distance. What is left of the point acts as
 * noise on the neighbourhoods
 *
 * Emission is aimed at a ball around a target. Brightness follows POV-Ray: where a photon lands
 * counts for how far its light has come in all, along the bent path, so that a clear pane or a flat
 * mirror changes no light, fading or not, by its place. emission_flux gives what falls on the
 * target, emission_growth what becomes of it farther on. For lights that fade with the square of
 * the distance, as real ones do, that is no change.
 */
#ifndef LIGHT_EMISSION_H
#define LIGHT_EMISSION_H

#include <stdbool.h>

#include "base/color.h"
#include "base/vec.h"
#include "light/light.h"

typedef struct EmissionAim {
	Vec3 center;
	double radius;
	double reach; /* share of the ball's disc or cap, from its middle, shot at; 0: all */
	Vec3 half;    /* sides, halved, of the box around the target; 0: it fills the ball */
} EmissionAim;

/* The part of the emitter's parameter space that may reach the target: a disc or a rectangle of the
 * plane, or a cap of directions. */
typedef struct EmissionRegion {
	bool plane;
	bool rectangle;   /* from -side - across to side + across, about the middle */
	bool own;         /* the light's own disc or cone, narrower than what covers the ball */
	Vec3 origin;      /* the disc's centre, moved back to before the ball, or the cap's apex */
	Vec3 axis, u, v;  /* axis: where the light goes, or the cap's middle */
	double radius;    /* disc */
	Vec2 side, across; /* rectangle: emitter coordinates */
	Vec2 middle;      /* of the disc or rectangle: emitter coordinates */
	double rise;      /* cap: 1 - cosine of the half angle, 0..2 */
	double measure;   /* area, or solid angle */
} EmissionRegion;

typedef struct Emission {
	Vec3 origin, direction; /* direction is unit */
	float coordinates[3];
	double measure;         /* of the region the sample was taken from */
} Emission;

/* What of the light's emitter space has to be sampled for all that may reach the target. */
EmissionRegion emission_region(const Light *light, const EmissionAim *aim);
/* 2: coordinates on a plane; 3: on the sphere. */
int emission_dimensions(const Light *light);

/* Whether samples differ in the point of the light where they start, each with a region of its own:
 * that seen from a point chosen by two numbers in [0, 1). */
bool emission_takes_point(const Light *light);
EmissionRegion emission_region_from(const Light *light, const EmissionAim *aim, const double s[2]);

enum { EMISSION_RUN_MAX = 64 };

/* Samples, uniform over the region, at most EMISSION_RUN_MAX, from two numbers in [0, 1) each;
 * writes over the numbers. */
void emission_run(const EmissionRegion *region, int count, double *s, double *t, Emission *out);

/* The same for a point of the unit disc, from the light's own position; the cap's or disc's edge is
 * at radius 1. Not for rectangles. */
Emission emission_from_disc(const EmissionRegion *region, Vec2 disc);

/* The flux of a path that stands for `share` of its region (1/number of paths), when it first lands
 * at p; *distance: from the light, or from a collimated light's plane. */
Rgb emission_flux(const Light *light, const Emission *emission, Vec3 p, double share,
		  double *distance);
/* What the flux at one distance is multiplied with at another, farther along the path. */
double emission_growth(const Light *light, double distance, double farther);

#endif
