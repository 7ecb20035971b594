/*
 * Textures: from a texture and a place to the layers that the integrator lights. A map or an
 * average of textures becomes several stacks of layers with weights. Points and normals go down
 * through the transformations of each level; bent normals come back up the same way.
 */
#include <math.h>

#include "surface/blend.h"
#include "surface/image_map.h"
#include "surface/texture.h"

/* Where a texture is asked, and how its space was reached from the outer one (the world when there
 * is none): by frame, or through the transformations of a patterned texture. */
typedef struct Place Place;
struct Place {
	SurfacePoint at;        /* p in the texture's space */
	Vec3 normal;            /* in the texture's space, of any length */
	const Transform *frame; /* or NULL */
	const Texture *through; /* or NULL */
	const Place *outer;
};

static void shade(const Texture *texture, const Place *place, double weight, Shading *out);

static Vec3 into(const Transform *t, Vec3 n) { return t ? transform_normal_inverse(t, n) : n; }
static Vec3 out_of(const Transform *t, Vec3 n) { return t ? transform_normal(t, n) : n; }

static Vec3 normal_to_world(const Place *place, Vec3 n)
{
	for (; place; place = place->outer) {
		if (place->through)
			n = out_of(place->through->transform,
				   pattern_unwarp_normal(&place->through->pattern, n));
		n = out_of(place->frame, n);
	}
	return vec3_normalize(n);
}

static Vec3 layer_normal(const Texture *texture, const Place *place, const SurfacePoint *inner)
{
	if (!texture->normal)
		return place->at.normal;
	Vec3 n = into(texture->transform, place->normal);
	if (!texture->normal->no_bump_scale)
		n = vec3_normalize(n);
	n = normal_perturb(texture->normal, inner, n);
	return normal_to_world(place, out_of(texture->transform, n));
}

static SurfacePoint point_inside(const Texture *texture, const Place *place)
{
	SurfacePoint inner = place->at;
	if (texture->transform)
		inner.p = transform_point_inverse(texture->transform, inner.p);
	return inner;
}

static ShadingLayer shade_layer(const Texture *texture, const Place *place)
{
	SurfacePoint inner = point_inside(texture, place);
	ShadingLayer layer = {.normal = layer_normal(texture, place, &inner),
			      .finish = texture->finish};
	inner.normal = layer.normal; /* what slope sees in a pigment */
	layer.color = pigment_color(texture->pigment, &inner);
	return layer;
}

static void shade_plain(const Texture *texture, const Place *place, double weight, Shading *out)
{
	if (out->stack_count == SHADING_MAX_STACKS || out->layer_count == SHADING_MAX_LAYERS)
		return;
	ShadingStack *stack = &out->stacks[out->stack_count++];
	*stack = (ShadingStack){(float)weight, out->layer_count, 0};
	for (; texture && out->layer_count < SHADING_MAX_LAYERS; texture = texture->next) {
		out->layers[out->layer_count++] = shade_layer(texture, place);
		stack->count++;
	}
}

static void shade_average(const Texture *texture, const Place *inner, double weight, Shading *out)
{
	double total = 0;
	for (int i = 0; i < texture->texture_count; i++)
		total += texture->textures[i].key;
	for (int i = 0; total != 0 && i < texture->texture_count; i++)
		shade(texture->textures[i].texture, inner,
		      weight * texture->textures[i].key / total, out);
}

static void shade_map(const Texture *texture, const Place *inner, double weight, Shading *out)
{
	const TextureEntry *entries = texture->textures;
	double value = pattern_value_unwarped(&texture->pattern, &inner->at);
	BlendSpan span = blend_find(entries, sizeof *entries, texture->texture_count, value);
	shade(entries[span.upper].texture, inner, weight * span.weight, out);
	if (span.lower != span.upper)
		shade(entries[span.lower].texture, inner, weight * (1 - span.weight), out);
}

/* Numbers beyond the textures go round, but the first of those stands for the last texture. */
static int material_number(int index, int count)
{
	return index == count ? count - 1 : index % count;
}

static void shade_material_map(const Texture *texture, const Place *inner, double weight,
			       Shading *out)
{
	int index = material_number(image_map_index(texture->image, inner->at.p),
				    texture->texture_count);
	shade(texture->textures[index < 0 ? 0 : index].texture, inner, weight, out);
}

static void shade(const Texture *texture, const Place *place, double weight, Shading *out)
{
	if (weight == 0)
		return;
	if (texture->kind == TEXTURE_PLAIN) {
		shade_plain(texture, place, weight, out);
		return;
	}
	Place inner = {.at = point_inside(texture, place), .through = texture, .outer = place};
	if (texture->kind == TEXTURE_UV) {
		inner = (Place){.at = place->at, .normal = place->at.normal};
		inner.at.p = vec3(place->at.uv.u, place->at.uv.v, 0);
		shade(texture->textures[0].texture, &inner, weight, out);
		return;
	}
	inner.at.p = pattern_warp_point(&texture->pattern, &inner.at);
	inner.normal = pattern_warp_normal(&texture->pattern,
					   into(texture->transform, place->normal));
	switch (texture->kind) {
	case TEXTURE_AVERAGE: shade_average(texture, &inner, weight, out); break;
	case TEXTURE_MATERIAL_MAP: shade_material_map(texture, &inner, weight, out); break;
	default: shade_map(texture, &inner, weight, out);
	}
}

/* Dropped stacks leave their share to the others. */
static void rescale(Shading *out)
{
	float total = 0;
	for (int i = 0; i < out->stack_count; i++)
		total += out->stacks[i].weight;
	for (int i = 0; total > 0 && i < out->stack_count; i++)
		out->stacks[i].weight /= total;
}

/* Layers of one colour each without bumps are the same everywhere; false for others. */
static bool shade_uniform(const Texture *texture, Vec3 normal, Shading *out)
{
	int count = 0;
	for (; texture && count < SHADING_MAX_LAYERS; texture = texture->next) {
		if (texture->kind != TEXTURE_PLAIN || texture->normal ||
		    texture->pigment->kind != PIGMENT_COLOR)
			return false;
		ShadingLayer *layer = &out->layers[count++];
		layer->color = texture->pigment->color;
		layer->normal = normal;
		layer->finish = texture->finish;
	}
	out->layer_count = count;
	out->stack_count = 1;
	out->stacks[0] = (ShadingStack){1, 0, count};
	return true;
}

static void shade_part(const TexturePart *part, const SurfacePoint *at, Shading *out)
{
	const Transform *attach = part->attach;
	Place place = {.at = *at, .normal = into(attach, at->normal), .frame = attach};
	place.at.p = attach ? transform_point_inverse(attach, at->world) : at->world;
	shade(part->texture, &place, part->weight, out);
}

void texture_shade_parts(const TexturePart *parts, int count, const SurfacePoint *at, Shading *out)
{
	if (count == 1 && shade_uniform(parts->texture, at->normal, out))
		return;
	out->layer_count = out->stack_count = 0;
	for (int i = 0; i < count; i++)
		shade_part(&parts[i], at, out);
	rescale(out);
}

void texture_shade(const Texture *texture, const Transform *attach, const SurfacePoint *at,
		   Shading *out)
{
	texture_shade_parts(&(TexturePart){texture, attach, 1}, 1, at, out);
}

bool texture_is_opaque(const Texture *texture)
{
	if (texture->kind == TEXTURE_PLAIN) {
		for (; texture; texture = texture->next)
			if (pigment_is_opaque(texture->pigment))
				return true;
		return false;
	}
	for (int i = 0; i < texture->texture_count; i++)
		if (!texture_is_opaque(texture->textures[i].texture))
			return false;
	return true;
}

static bool finish_is_dull(const Finish *finish)
{
	return rgb_is_black(finish->reflection.min) && rgb_is_black(finish->reflection.max) &&
	       (finish->diffuse != 0 || finish->diffuse_back != 0 || finish->phong > 0 ||
		finish->specular > 0);
}

bool texture_is_dull(const Texture *texture)
{
	for (; texture; texture = texture->next) {
		if (texture->kind == TEXTURE_PLAIN && !finish_is_dull(texture->finish))
			return false;
		for (int i = 0; i < texture->texture_count; i++)
			if (!texture_is_dull(texture->textures[i].texture))
				return false;
	}
	return true;
}

bool texture_is_uniform(const Texture *texture)
{
	return texture->kind == TEXTURE_PLAIN && !texture->next && !texture->normal &&
	       texture->pigment->kind == PIGMENT_COLOR;
}

static bool layer_uses_uv(const Texture *texture)
{
	if (texture->kind == TEXTURE_UV)
		return true;
	if (texture->kind == TEXTURE_PLAIN)
		return pigment_uses_uv(texture->pigment) ||
		       (texture->normal && normal_uses_uv(texture->normal));
	for (int i = 0; i < texture->texture_count; i++)
		if (texture_uses_uv(texture->textures[i].texture))
			return true;
	return false;
}

bool texture_uses_uv(const Texture *texture)
{
	for (; texture; texture = texture->next)
		if (layer_uses_uv(texture))
			return true;
	return false;
}

const Texture *texture_by_uv(Arena *arena, const Texture *texture)
{
	TextureEntry *entry = ARENA_NEW(arena, TextureEntry);
	Texture *uv = ARENA_NEW(arena, Texture);
	*entry = (TextureEntry){0, texture};
	*uv = (Texture){.kind = TEXTURE_UV, .textures = entry, .texture_count = 1};
	return uv;
}

const struct Interior *texture_interior(const Texture *texture)
{
	for (; texture; texture = texture->next) {
		if (texture->kind == TEXTURE_PLAIN && texture->finish->interior)
			return texture->finish->interior;
		for (int i = 0; i < texture->texture_count; i++) {
			const struct Interior *inside = texture_interior(
				texture->textures[i].texture);
			if (inside)
				return inside;
		}
	}
	return NULL;
}
