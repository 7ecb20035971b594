/*
 * Light sources as the scene language describes them, in world space; plain immutable data. What
 * reaches a point is light_sample's answer, before shadows.
 */
#ifndef LIGHT_LIGHT_H
#define LIGHT_LIGHT_H

#include "base/color.h"
#include "base/vec.h"

typedef enum LightKind { LIGHT_POINT, LIGHT_SPOT, LIGHT_CYLINDER } LightKind;

typedef struct Light {
	LightKind kind;
	Rgb color;
	Vec3 position, point_at;
	bool parallel;
	bool shadowless;               /* shadowless, and fill lights */
	double radius, falloff;        /* spot: cosines of the angles; cylinder: radii */
	double tightness;
	double fade_distance, fade_power; /* 0: no fading */
	bool area;
	Vec3 axis1, axis2;             /* whole edges of the area */
	int size1, size2;
	int adaptive;                  /* -1: off */
	bool jitter, circular, orient, area_illumination;
	bool media_interaction, media_attenuation;
	bool photons_refraction, photons_reflection;
	bool photons_area;             /* photons start from the whole area */
	double photons_share;          /* paths beside other lights'; 1 */
	int group;                     /* light_group it belongs to; 0: lights everything */
	const void *projected_through; /* const Shape *, for the renderer */
} Light;

Light light_default(void);

/* How much fade_distance and fade_power leave at a distance. */
double light_fade(const Light *light, double distance);

/* Direction (unit, from p to the light), distance (infinite-ish for parallel lights: to the light's
 * plane) and unshadowed colour that arrives at p from the point `from` on the light (from:
 * position, or a point of the area). */
Rgb light_arrival(const Light *light, Vec3 from, Vec3 p, Vec3 *direction, double *distance);

#endif
