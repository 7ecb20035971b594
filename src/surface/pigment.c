/*
 * Pigments: the colour of a point. Pigments inside a map, a list or an average are asked at the
 * point as the outer pattern's warps bent it, as POV-Ray does.
 */
#include <math.h>

#include "surface/blend.h"
#include "surface/image_map.h"
#include "surface/texture.h"

static Rgbft color_map_color(const Pigment *pigment, const SurfacePoint *at)
{
	const ColorEntry *colors = pigment->colors;
	double value = pattern_value_unwarped(&pigment->pattern, at);
	BlendSpan span = blend_find(colors, sizeof *colors, pigment->color_count, value);
	if (span.lower == span.upper)
		return colors[span.upper].color;
	return rgbft_lerp(colors[span.lower].color, colors[span.upper].color, (float)span.weight);
}

static Rgbft pigment_map_color(const Pigment *pigment, const SurfacePoint *at)
{
	const PigmentEntry *entries = pigment->pigments;
	double value = pattern_value_unwarped(&pigment->pattern, at);
	BlendSpan span = blend_find(entries, sizeof *entries, pigment->pigment_count, value);
	Rgbft upper = pigment_color(entries[span.upper].pigment, at);
	if (span.lower == span.upper)
		return upper;
	return rgbft_lerp(pigment_color(entries[span.lower].pigment, at), upper,
			  (float)span.weight);
}

static Rgbft average_color(const Pigment *pigment, const SurfacePoint *at)
{
	Rgbft sum = {0, 0, 0, 0, 0};
	double total = 0;
	for (int i = 0; i < pigment->pigment_count; i++) {
		float weight = (float)pigment->pigments[i].key;
		Rgbft c = pigment_color(pigment->pigments[i].pigment, at);
		sum = rgbft(sum.r + weight * c.r, sum.g + weight * c.g, sum.b + weight * c.b,
		            sum.filter + weight * c.filter, sum.transmit + weight * c.transmit);
		total += weight;
	}
	return total != 0 ? rgbft_lerp(rgbft(0, 0, 0, 0, 0), sum, (float)(1 / total)) : sum;
}

static Rgbft image_color(const Pigment *pigment, const SurfacePoint *at)
{
	Rgbft color;
	image_map_color(pigment->image, at->p, &color);
	return color;
}

Rgbft pigment_color(const Pigment *pigment, const SurfacePoint *at)
{
	if (pigment->kind == PIGMENT_COLOR)
		return pigment->color;
	SurfacePoint inner = *at;
	if (pigment->kind == PIGMENT_UV) {
		inner.p = vec3(at->uv.u, at->uv.v, 0);
		return pigment_color(pigment->pigments[0].pigment, &inner);
	}
	inner.p = pattern_warp_point(&pigment->pattern, at);
	switch (pigment->kind) {
	case PIGMENT_COLOR_MAP: return color_map_color(pigment, &inner);
	case PIGMENT_PIGMENT_MAP:
	case PIGMENT_LIST: return pigment_map_color(pigment, &inner);
	case PIGMENT_AVERAGE: return average_color(pigment, &inner);
	case PIGMENT_IMAGE: return image_color(pigment, &inner);
	default: return pigment->color;
	}
}

static bool color_is_clear(Rgbft c) { return c.filter > 0 || c.transmit > 0; }

static bool image_is_opaque(const ImageMap *image)
{
	bool alpha = image->palette ? true : image->channels == 2 || image->channels == 4;
	bool bounded = image->once || image->mapping != IMAGE_MAPPING_PLANAR;
	return !alpha && !bounded && image->filter_all <= 0 && image->transmit_all <= 0;
}

bool pigment_is_opaque(const Pigment *pigment)
{
	switch (pigment->kind) {
	case PIGMENT_COLOR:
		return !color_is_clear(pigment->color);
	case PIGMENT_IMAGE:
		return image_is_opaque(pigment->image);
	case PIGMENT_COLOR_MAP:
		for (int i = 0; i < pigment->color_count; i++)
			if (color_is_clear(pigment->colors[i].color))
				return false;
		return true;
	default:
		for (int i = 0; i < pigment->pigment_count; i++)
			if (!pigment_is_opaque(pigment->pigments[i].pigment))
				return false;
		return true;
	}
}

bool pigment_uses_uv(const Pigment *pigment)
{
	if (pigment->kind == PIGMENT_UV)
		return true;
	bool nested = pigment->kind == PIGMENT_PIGMENT_MAP || pigment->kind == PIGMENT_LIST ||
		      pigment->kind == PIGMENT_AVERAGE;
	for (int i = 0; nested && i < pigment->pigment_count; i++)
		if (pigment_uses_uv(pigment->pigments[i].pigment))
			return true;
	return false;
}
