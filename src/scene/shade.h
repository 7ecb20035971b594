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
static inline double shade_epsilon(Vec3 p)
{
	double scale = real_max(fabs(p.x), real_max(fabs(p.y), fabs(p.z)));
	/* POV-Ray's 0.001 for scenes of usual size, finer for tiny ones, and never under what
	 * doubles can tell apart. */
	return real_max(real_min(1e-3, 1e-4 * scale), 1e-9 * scale);
}
/* Whether the light shines on the surface at all (light groups). */
bool shade_light_reaches(const Light *light, const Surface *surface);
/* What of light goes straight through the textures: the sum over their stacks. */
Rgb shade_transmittance(const Shading *shading);
/* What is left of light after a way through an interior: fade_distance, fade_power, fade_color. */
Rgb shade_attenuation(const Interior *interior, double distance);

#endif
