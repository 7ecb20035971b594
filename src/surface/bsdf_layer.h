/*
 * The mirror and the passage of a single layer without bumps: bsdf_events of a stack of one, for
 * paths that meet such surfaces by the million. Inline; and what an event weighs is told apart from
 * where it goes, since of two only one is followed.
 */
#ifndef SURFACE_BSDF_LAYER_H
#define SURFACE_BSDF_LAYER_H

#include "surface/bsdf.h"
#include "surface/refraction.h"

/* What a finish mirrors of a ray; its cosine is within [0, 1]. */
static inline Rgb bsdf_finish_mirror(const Finish *finish, const Rgbft *color, const Refraction *at)
{
	if (rgb_is_black(finish->reflection.max) && rgb_is_black(finish->reflection.min))
		return rgb_all(0);
	double share;
	if (finish->reflection.fresnel)
		share = refraction_mirrored(at);
	else
		share = finish->reflection.falloff == 1
				? 1 - at->cosine
				: pow(1 - at->cosine, finish->reflection.falloff);
	Rgb mirror = rgb_lerp(finish->reflection.min, finish->reflection.max, (float)share);
	if (finish->reflection.metallic != 0)
		mirror = rgb_mul(mirror,
				 bsdf_metal_tint(rgbft_rgb(*color), finish->reflection.metallic,
						 at->cosine));
	return mirror;
}

static inline float bsdf_left_of(float mirrored) { return mirrored < 1 ? 1 - mirrored : 0; }

/* What a layer lets through beside its mirror. */
static inline Rgb bsdf_finish_through(const Finish *finish, const Rgbft *color, Rgb mirror)
{
	Rgb through = rgbft_transmittance(*color);
	if (!finish->conserve_energy)
		return through;
	return rgb_mul(through, rgb(bsdf_left_of(mirror.r), bsdf_left_of(mirror.g),
				    bsdf_left_of(mirror.b)));
}

/* Field by field: a structure that is put together elsewhere and copied is read back in wide pieces
 * before its narrow ones have arrived, which takes longer than all the rest of an event. */
static inline void bsdf_set_event(BsdfEvent *event, BsdfEventKind kind, Rgb weight, float exponent)
{
	event->kind = kind;
	event->weight.r = weight.r;
	event->weight.g = weight.g;
	event->weight.b = weight.b;
	event->exponent = exponent;
	event->bent = false;
	event->total = false;
}

/* The passage and the mirror, in this order, all but where they go, which bsdf_layer_direction
 * tells. Either may be black, which then stands for no event. */
static inline void bsdf_layer_events(const Finish *finish, const Rgbft *color, const Refraction *at,
				     BsdfEvent out[2])
{
	Rgb mirrored = bsdf_finish_mirror(finish, color, at);
	Rgb through = bsdf_finish_through(finish, color, mirrored);
	bool bent = refraction_bends(at->ior);
	bool total = bent && at->inner2 < 0 && !rgb_is_black(through);
	bsdf_set_event(&out[0], BSDF_TRANSMIT, total ? rgb_all(1) : through, 1);
	out[0].bent = bent;
	out[0].total = total;
	bsdf_set_event(&out[1], BSDF_REFLECT, total ? rgb_all(0) : mirrored,
		       finish->reflection.exponent);
}

/* Where an event sends a ray; the normal is the one that the refraction's cosine was taken with. */
static inline Vec3 bsdf_layer_direction(const BsdfEvent *event, const Refraction *at,
					Vec3 direction, Vec3 normal)
{
	if (event->kind == BSDF_REFLECT || event->total)
		return vec3_reflect(direction, normal);
	return event->bent ? refraction_direction(at, direction, normal) : direction;
}

#endif
