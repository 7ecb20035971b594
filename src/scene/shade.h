/* A hit made ready for shading: place, sides, textures. */
#ifndef SCENE_SHADE_H
#define SCENE_SHADE_H

#include "scene/object.h"

typedef struct ShadePoint {
	SurfacePoint at;        /* normal: turned against the ray */
	const Surface *surface;
	const Hit *hit;
	bool back;              /* the ray comes from inside */
} ShadePoint;

void shade_point_init(ShadePoint *point, const Ray *ray, const Hit *hit);
/* The texture at the point: the outer or the interior one, or what a mesh's corners blend. */
void shade_textures(const ShadePoint *point, Shading *out);
/* The distance within which a ray that starts at p does not meet the surface it starts from. */
double shade_epsilon(Vec3 p);
/* What is left of light after a way through an interior: fade_distance, fade_power, fade_color. */
Rgb shade_attenuation(const Interior *interior, double distance);

#endif
