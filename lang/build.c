#include "lang/build.h"

#include "lang/build_atmosphere.h"
#include "lang/build_camera.h"
#include "lang/build_map.h"
#include "lang/build_media.h"
#include "lang/build_object.h"
#include "lang/build_photons.h"
#include "lang/build_settings.h"
#include "lang/build_texture.h"
#include "lang/build_transform.h"
#include "lang/cursor.h"
#include "lang/spline.h"

/* ---- the top level ---- */

/* An object enters the scene with the default texture of that moment. */
static void add_object(Context *context, const Object *object)
{
	if (!object)
		return;
	Object *copy = arena_copy(context->builder->arena, object, sizeof *copy);
	if (!copy->texture) {
		copy->texture_transform = transform_identity();
		copy->texture = context->defaults.texture;
		copy->texture_is_default = true;
	}
	scene_builder_add_object(context->builder, copy);
}

static void set_camera(Context *context, const Camera *camera)
{
	context->builder->camera = *camera;
	context->builder->has_camera = true;
}

static bool build_scene_block(Context *context, const Node *block)
{
	SceneBuilder *builder = context->builder;
	switch (block->word) {
	case W_camera:
		set_camera(context, build_camera(context, block, context->defaults.camera));
		return true;
	case W_global_settings:
		build_global_settings(context, block);
		return true;
	case W_background:
		build_background(context, block);
		return true;
	case W_fog:
		scene_builder_add_fog(builder, build_fog(context, block));
		return true;
	case W_rainbow:
		scene_builder_add_rainbow(builder, build_rainbow(context, block));
		return true;
	case W_sky_sphere:
		builder->sky_sphere = build_sky_sphere(context, block);
		return true;
	case W_media:
		build_media(context, block);
		return true;
	case W_default:
		build_defaults(context, block->children);
		return true;
	default:
		return false;
	}
}

bool build_scene_item(Context *context, const Node *item)
{
	const Node *at = item;
	if (build_is_object(item)) {
		add_object(context, build_object(context, item));
		return true;
	}
	if (item->kind == NODE_BLOCK && build_scene_block(context, item))
		return true;
	if (item->kind == NODE_WORD && build_old_setting(context, &at)) {
		Cursor rest = cursor_over(context, at);
		return cursor_end(&rest);
	}
	Cursor cursor = cursor_over(context, item);
	cursor_unexpected(&cursor);
	return false;
}

/* ---- #default ---- */

void build_defaults(Context *context, const Node *items)
{
	Cursor cursor = cursor_over(context, items);
	while (!cursor_at_end(&cursor)) {
		const Node *camera = cursor_accept_block(&cursor, W_camera);
		if (camera)
			context->defaults.camera = build_camera(context, camera,
								context->defaults.camera);
		else if (cursor_peek_block(&cursor) && build_texture_default(context, cursor.at))
			cursor_next(&cursor);
		else
			cursor_unexpected(&cursor);
	}
}

void build_init(Context *context)
{
	Camera camera = camera_default(1.33);
	camera.focal_distance = 1;
	context->defaults.camera = arena_copy(context->builder->arena, &camera, sizeof camera);
	context->builder->camera = camera;
	context->builder->background = rgbft(0, 0, 0, 0, 1);
	build_texture_init(context);
}

/* ---- values ---- */

/* texture { } texture { } ...: one value, the layers bottom to top. */
static Value build_layers(Cursor *cursor)
{
	const Texture *texture = NULL;
	const Node *block;
	while ((block = cursor_accept_block(cursor, W_texture)))
		texture = build_texture_stack(cursor->context, texture,
					      build_texture(cursor->context, block));
	return value_item(VALUE_TEXTURE, texture);
}

static const Transform *keep_transform(Context *context, const Node *block)
{
	Transform transform = build_transform(context, block);
	return arena_copy(context->builder->arena, &transform, sizeof transform);
}

/* Reported already when the item is NULL. */
static Value value_of(ValueKind kind, const void *item)
{
	return item ? value_item(kind, item) : value_none();
}

static Value build_block_value(Context *context, const Node *block)
{
	const Defaults *defaults = &context->defaults;
	switch (block->word) {
	case W_pigment:
		return value_item(VALUE_PIGMENT, build_pigment(context, block, defaults->pigment));
	case W_normal:
		return value_of(VALUE_NORMAL, build_normal(context, block, defaults->normal));
	case W_finish:
		return value_item(VALUE_FINISH, build_finish(context, block, defaults->finish));
	case W_interior: return value_item(VALUE_INTERIOR, build_interior(context, block, NULL));
	case W_material: return value_item(VALUE_MATERIAL, build_material(context, block));
	case W_media: return value_item(VALUE_MEDIA, build_media(context, block));
	case W_density: return value_item(VALUE_DENSITY, build_media(context, block));
	case W_camera:
		return value_item(VALUE_CAMERA, build_camera(context, block, defaults->camera));
	case W_fog: return value_item(VALUE_FOG, build_fog(context, block));
	case W_rainbow: return value_item(VALUE_RAINBOW, build_rainbow(context, block));
	case W_sky_sphere: return value_item(VALUE_SKY_SPHERE, build_sky_sphere(context, block));
	case W_transform: return value_item(VALUE_TRANSFORM, keep_transform(context, block));
	case W_estimator: return value_of(VALUE_ESTIMATOR, build_estimator(context, block));
	case W_density_map: return value_item(VALUE_DENSITY_MAP, build_media(context, block));
	case W_spline: return spline_build(context, block);
	case W_color_map:
	case W_colour_map:
	case W_pigment_map:
	case W_normal_map:
	case W_slope_map:
	case W_texture_map: return build_map(context, block);
	default:
		diag_error(context->diag, block->where, "'%s' is nothing that a name can hold",
			   word_text(block->word));
		return value_none();
	}
}

/* translate <...>, rotate <...>: a transformation without braces around it is a value, too. */
static Value build_bare_transform(Cursor *cursor)
{
	Transform transform = transform_identity();
	while (build_accept_transform(cursor, &transform))
		;
	return value_item(VALUE_TRANSFORM, arena_copy(cursor->context->builder->arena, &transform,
						      sizeof transform));
}

Value build_value(Context *context, const Node *items)
{
	Cursor cursor = cursor_over(context, items);
	Value value = value_none();
	if (cursor_at_end(&cursor))
		return value;
	if (cursor_peek_word(&cursor) == W_texture && cursor_peek_block(&cursor)) {
		value = build_layers(&cursor);
	} else if (items->kind == NODE_BLOCK && build_is_object(items)) {
		value = value_of(VALUE_OBJECT, build_object(context, cursor_next(&cursor)));
	} else if (items->kind == NODE_BLOCK) {
		value = build_block_value(context, cursor_next(&cursor));
	} else if (items->kind == NODE_VALUE || items->kind == NODE_ITEM) {
		value = cursor_next(&cursor)->value;
	} else if (build_peek_transform(&cursor)) {
		value = build_bare_transform(&cursor);
	}
	cursor_end(&cursor);
	return value;
}
