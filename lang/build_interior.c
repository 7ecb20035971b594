/* interior { ... } and material { ... } */
#include "lang/build_media.h"
#include "lang/build_texture.h"
#include "lang/build_transform.h"

static void take_number(Cursor *cursor, float *out)
{
	double number = *out;
	if (cursor_take_float(cursor, &number))
		*out = (float)number;
}

static void take_samples(Cursor *cursor, Interior *interior)
{
	if (!cursor_take_int(cursor, &interior->dispersion_samples) ||
	    interior->dispersion_samples >= 2)
		return;
	diag_error(cursor->context->diag, cursor->last->where,
		   "dispersion_samples takes 2 or more");
	interior->dispersion_samples = interior_default().dispersion_samples;
}

/* One word of an interior; false when none is next. */
static bool take_item(Cursor *cursor, Interior *interior)
{
	Transform ignored = transform_identity();
	const Node *media = cursor_accept_block(cursor, W_media);
	if (media)
		interior->media = build_media(cursor->context, media);
	else if (cursor_accept_word(cursor, W_ior))
		take_number(cursor, &interior->ior);
	else if (cursor_accept_word(cursor, W_caustics))
		take_number(cursor, &interior->caustics);
	else if (cursor_accept_word(cursor, W_fade_distance))
		take_number(cursor, &interior->fade_distance);
	else if (cursor_accept_word(cursor, W_fade_power))
		take_number(cursor, &interior->fade_power);
	else if (cursor_accept_word(cursor, W_fade_color) ||
		 cursor_accept_word(cursor, W_fade_colour))
		cursor_take_rgb(cursor, &interior->fade_color);
	else if (cursor_accept_word(cursor, W_dispersion))
		take_number(cursor, &interior->dispersion);
	else if (cursor_accept_word(cursor, W_dispersion_samples))
		take_samples(cursor, interior);
	else if (cursor_accept_word(cursor, W_refraction))
		cursor_optional_float(cursor, 1);
	else
		/* Only media have a place in space. */
		return build_accept_transform(cursor, &ignored);
	return true;
}

const Interior *build_interior(Context *context, const Node *block, const Interior *base)
{
	Cursor cursor = cursor_begin(context, block);
	const Interior *named = cursor_accept_item(&cursor, VALUE_INTERIOR);
	if (named && cursor_at_end(&cursor))
		return named;
	Interior *interior = ARENA_NEW(context->builder->arena, Interior);
	*interior = named ? *named : base ? *base : interior_default();
	while (!cursor_at_end(&cursor))
		if (!take_item(&cursor, interior))
			cursor_unexpected(&cursor);
	return interior;
}

static bool take_material_item(Cursor *cursor, Material *material)
{
	Context *context = cursor->context;
	Transform transform = transform_identity();
	const Node *block;
	if ((block = cursor_accept_block(cursor, W_texture)))
		material->texture = build_texture_stack(context, material->texture,
							build_texture(context, block));
	else if ((block = cursor_accept_block(cursor, W_interior_texture)))
		material->interior_texture = build_texture_stack(
			context, material->interior_texture, build_texture(context, block));
	else if ((block = cursor_accept_block(cursor, W_interior)))
		material->interior = build_interior(context, block, material->interior);
	else if (build_accept_transform(cursor, &transform)) {
		if (material->texture)
			material->texture = build_texture_transform(context, material->texture,
								    &transform);
		if (material->interior_texture)
			material->interior_texture = build_texture_transform(
				context, material->interior_texture, &transform);
	} else
		return false;
	return true;
}

const Material *build_material(Context *context, const Node *block)
{
	Cursor cursor = cursor_begin(context, block);
	const Material *named = cursor_accept_item(&cursor, VALUE_MATERIAL);
	if (named && cursor_at_end(&cursor))
		return named;
	Material *material = ARENA_NEW(context->builder->arena, Material);
	if (named)
		*material = *named;
	while (!cursor_at_end(&cursor))
		if (!take_material_item(&cursor, material))
			cursor_unexpected(&cursor);
	return material;
}
