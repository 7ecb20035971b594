/* The words that any object takes: transformations, surfaces, clips and flags. */
#include "lang/build_object.h"

#include <stddef.h>

#include "lang/build_photons.h"
#include "lang/build_texture.h"
#include "lang/build_transform.h"

/* Words with an optional on or off, and the flag each sets. */
static const struct {
	Word word;
	size_t offset;
} flag_rows[] = {
	{W_hollow, offsetof(ObjectFlags, hollow)},
	{W_no_shadow, offsetof(ObjectFlags, no_shadow)},
	{W_no_image, offsetof(ObjectFlags, no_image)},
	{W_no_reflection, offsetof(ObjectFlags, no_reflection)},
	{W_no_radiosity, offsetof(ObjectFlags, no_radiosity)},
	{W_double_illuminate, offsetof(ObjectFlags, double_illuminate)},
	{W_uv_mapping, offsetof(ObjectFlags, uv_mapping)},
	{W_cutaway_textures, offsetof(ObjectFlags, cutaway_textures)},
	{W_split_union, offsetof(ObjectFlags, split_union)},
	{W_global_lights, offsetof(ObjectFlags, global_lights)},
};

static bool accept_flag(Cursor *cursor, Object *object)
{
	for (size_t i = 0; i < sizeof flag_rows / sizeof *flag_rows; i++) {
		if (!cursor_accept_word(cursor, flag_rows[i].word))
			continue;
		Tristate *flag = (Tristate *)((char *)&object->flags + flag_rows[i].offset);
		*flag = cursor_optional_bool(cursor) ? ON : OFF;
		return true;
	}
	return false;
}

/* Brings the texture so far into the space that the object stands in now, so that another can be
 * put beside it. */
static void settle_texture(Context *context, Object *object)
{
	if (object->texture && !transform_is_identity(&object->texture_transform)) {
		object->texture = build_texture_transform(context, object->texture,
							  &object->texture_transform);
		if (object->interior_texture)
			object->interior_texture = build_texture_transform(
				context, object->interior_texture, &object->texture_transform);
	}
	object->texture_transform = transform_identity();
}

static void add_texture(Context *context, Object *object, const Texture *texture)
{
	settle_texture(context, object);
	object->texture = build_texture_stack(context, object->texture, texture);
}

/* The topmost layer, a copy of its own that may be changed; the layers below are copied with it. */
static Texture *own_top_layer(Context *context, Object *object)
{
	Arena *arena = context->builder->arena;
	settle_texture(context, object);
	const Texture *from = object->texture ? object->texture : context->defaults.texture;
	const Texture **link = &object->texture;
	Texture *copy = NULL;
	for (; from; from = from->next) {
		copy = arena_copy(arena, from, sizeof *copy);
		*link = copy;
		link = &copy->next;
	}
	return copy;
}

/* pigment, normal and finish right in the object change its texture, or the default one. */
static void change_texture(Context *context, Object *object, const Node *block)
{
	Texture *top = own_top_layer(context, object);
	if (top->kind != TEXTURE_PLAIN) {
		diag_error(context->diag, block->where, "'%s' cannot change a patterned texture",
			   word_text(block->word));
		return;
	}
	if (block->word == W_pigment)
		top->pigment = build_pigment(context, block, top->pigment);
	else if (block->word == W_normal)
		top->normal = build_normal(context, block, top->normal);
	else
		top->finish = build_finish(context, block, top->finish);
}

static void set_interior_texture(Context *context, Object *object, const Texture *texture)
{
	settle_texture(context, object);
	object->interior_texture = build_texture_stack(context, object->interior_texture, texture);
}

static void add_material(Context *context, Object *object, const Material *material)
{
	if (!material)
		return;
	if (material->texture)
		add_texture(context, object, material->texture);
	if (material->interior_texture)
		set_interior_texture(context, object, material->interior_texture);
	if (material->interior)
		object->interior = material->interior;
}

static bool accept_surface(Cursor *cursor, Object *object)
{
	if (!cursor_peek_block(cursor))
		return false;
	Context *context = cursor->context;
	const Node *block = cursor->at;
	switch (block->word) {
	case W_texture:
		add_texture(context, object, build_texture(context, block));
		break;
	case W_interior_texture:
		set_interior_texture(context, object, build_texture(context, block));
		break;
	case W_pigment:
	case W_normal:
	case W_finish:
		change_texture(context, object, block);
		break;
	case W_interior:
		object->interior = build_interior(context, block, object->interior);
		break;
	case W_material:
		add_material(context, object, build_material(context, block));
		break;
	default:
		return false;
	}
	cursor_next(cursor);
	return true;
}

/* Puts the objects of a block behind those that are there. */
static const Object *const *read_clips(Cursor *cursor, const Object *const *old, int *count)
{
	ObjectList list = {0};
	build_object_list(cursor, &list);
	if (!list.count && cursor_at_end(cursor))
		cursor_expected(cursor, "an object");
	cursor_end(cursor);
	const Object **all = ARENA_ARRAY(cursor->context->builder->arena, const Object *,
					 *count + list.count);
	for (int i = 0; i < *count; i++)
		all[i] = old[i];
	for (int i = 0; i < list.count; i++)
		all[*count + i] = list.items[i];
	*count += list.count;
	return all;
}

/* clipped_by { ... } and bounded_by { ... }; each may borrow the other's objects by its word alone.
 */
static bool accept_clip(Cursor *cursor, Object *object)
{
	const Node *block = cursor_accept_block(cursor, W_clipped_by);
	bool clip = block;
	if (!clip && !(block = cursor_accept_block(cursor, W_bounded_by)))
		return false;
	Cursor inside = cursor_begin(cursor->context, block);
	if (cursor_accept_word(&inside, clip ? W_bounded_by : W_clipped_by)) {
		object->clip_is_bound = true;
		cursor_end(&inside);
		if (clip) {
			object->clip = object->bound;
			object->clip_count = object->bound_count;
		} else {
			object->bound = object->clip;
			object->bound_count = object->clip_count;
		}
	} else if (clip) {
		object->clip = read_clips(&inside, object->clip, &object->clip_count);
	} else {
		object->bound = read_clips(&inside, object->bound, &object->bound_count);
	}
	return true;
}

/* Words that steer POV-Ray's own way of computing and change nothing here. */
static bool accept_hint(Cursor *cursor)
{
	const Node *block = cursor_accept_block(cursor, W_radiosity);
	if (block) {
		double importance;
		Cursor inside = cursor_begin(cursor->context, block);
		while (cursor_accept_word(&inside, W_importance))
			cursor_take_float(&inside, &importance);
		cursor_end(&inside);
		return true;
	}
	if (!cursor_accept_word(cursor, W_sturm) && !cursor_accept_word(cursor, W_hierarchy))
		return false;
	cursor_optional_bool(cursor);
	return true;
}

bool build_object_modifier(Cursor *cursor, Object *object)
{
	Transform transform = transform_identity();
	if (build_accept_transform(cursor, &transform)) {
		object_transform(cursor->context->builder->arena, object, &transform);
		return true;
	}
	if (cursor_accept_word(cursor, W_inverse)) {
		object->inverse = !object->inverse;
		return true;
	}
	const Node *photons = cursor_accept_block(cursor, W_photons);
	if (photons) {
		build_photons_object(cursor->context, photons, object);
		return true;
	}
	return accept_surface(cursor, object) || accept_flag(cursor, object) ||
	       accept_clip(cursor, object) || accept_hint(cursor);
}
