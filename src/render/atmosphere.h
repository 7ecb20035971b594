/* What a ray sees where it meets nothing, and what hangs in the air before it: sky, fog, rainbows.
 */
#ifndef RENDER_ATMOSPHERE_H
#define RENDER_ATMOSPHERE_H

#include "render/tracer.h"

/* The sky that a ray sees: sky_sphere's pigments, layered, over the background. */
Seen atmosphere_sky(const Tracer *tracer, const PathRay *path);
/* What is left of a sight at the given distance (INFINITY: the sky) behind the scene's rainbows and
 * fogs. */
Seen atmosphere_apply(Tracer *tracer, const Ray *ray, double distance, Seen seen);

/* What fogs leave of light along a ray, over the given distance. */
Rgb atmosphere_transmittance(const Scene *scene, const Ray *ray, double distance);

#endif
