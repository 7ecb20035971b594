/*
 * texture { ... }. A transformation in a texture moves the pigment and the normal, or the pattern,
 * that are there when it stands; so it goes to these as a warp, at once.
 */
#include "lang/build_texture.h"

#include "lang/build_image.h"
#include "lang/build_map.h"
#include "lang/build_pattern.h"
#include "lang/build_transform.h"

static Arena *scene_arena(const Context *context) { return context->builder->arena; }

/* ---- transformations ---- */

static const Pigment *transform_pigment(Context *context, const Pigment *pigment,
					const Transform *transform)
{
	Pigment *copy = arena_copy(scene_arena(context), pigment, sizeof *copy);
	build_pattern_transform(context, &copy->pattern, transform);
	return copy;
}

static const Normal *transform_normal_block(Context *context, const Normal *normal,
					    const Transform *transform)
{
	Normal *copy = arena_copy(scene_arena(context), normal, sizeof *copy);
	build_pattern_transform(context, &copy->pattern, transform);
	return copy;
}

/* One layer, in place. A plain colour stays what it is wherever it is. */
static void transform_layer(Context *context, Texture *texture, const Transform *transform)
{
	if (texture->kind != TEXTURE_PLAIN) {
		build_pattern_transform(context, &texture->pattern, transform);
		return;
	}
	if (texture->pigment->kind != PIGMENT_COLOR)
		texture->pigment = transform_pigment(context, texture->pigment, transform);
	if (texture->normal)
		texture->normal = transform_normal_block(context, texture->normal, transform);
}

/* A list with its structs copied, so that they may be changed. */
static Texture *copy_layers(Context *context, const Texture *texture)
{
	Texture *first = arena_copy(scene_arena(context), texture, sizeof *first);
	for (Texture *layer = first; layer->next;) {
		Texture *next = arena_copy(scene_arena(context), layer->next, sizeof *next);
		layer->next = next;
		layer = next;
	}
	return first;
}

static void transform_layers(Context *context, Texture *texture, const Transform *transform)
{
	/* The lists that are changed here are copies made by copy_layers. */
	for (Texture *layer = texture; layer; layer = (Texture *)(void *)layer->next)
		transform_layer(context, layer, transform);
}

const Texture *build_texture_transform(Context *context, const Texture *texture,
				       const Transform *transform)
{
	Texture *copy = copy_layers(context, texture);
	transform_layers(context, copy, transform);
	return copy;
}

const Texture *build_texture_stack(Context *context, const Texture *bottom, const Texture *top)
{
	if (!bottom)
		return top;
	Texture *copy = copy_layers(context, bottom);
	Texture *last = copy;
	while (last->next)
		last = (Texture *)(void *)last->next;
	last->next = top;
	return copy;
}

/* ---- patterned textures ---- */

static void take_list(Cursor *cursor, Texture *texture)
{
	Arena *arena = scene_arena(cursor->context);
	int most = texture->pattern.class->list;
	Cursor inner;
	bool braces = build_pattern_inner_list(cursor, &inner);
	TextureEntry *entries = ARENA_ARRAY(arena, TextureEntry, most);
	int count = build_texture_list(braces ? &inner : cursor, entries, most);
	for (int i = count; i < most; i++)
		entries[i] = (TextureEntry){i, cursor->context->defaults.texture};
	texture->kind = TEXTURE_LIST;
	texture->textures = entries;
	texture->texture_count = most;
	if (braces)
		cursor_end(&inner);
}

static void take_pattern(Cursor *cursor, Texture *texture)
{
	if (!texture->pattern.class)
		return;
	if (texture->pattern.class->list > 0)
		take_list(cursor, texture);
	else
		texture->kind = TEXTURE_MAP;
}

static void take_texture_map(Cursor *cursor, Texture *texture)
{
	const TextureMap *map = build_texture_map(cursor->context, cursor_next(cursor));
	texture->textures = map->entries;
	texture->texture_count = map->count;
}

/* tiles { texture { } tile2 texture { } }: an old checker. */
static void take_tiles(Cursor *cursor, Texture *texture)
{
	Context *context = cursor->context;
	Cursor inside = cursor_begin(context, cursor_next(cursor));
	TextureEntry *entries = ARENA_ARRAY(scene_arena(context), TextureEntry, 2);
	/* The first texture is where checker has its second. */
	TextureEntry given[2] = {{0, context->defaults.texture}, {0, context->defaults.texture}};
	build_texture_list(&inside, &given[0], 1);
	if (!cursor_accept_word(&inside, W_tile2))
		cursor_expected(&inside, "'tile2'");
	build_texture_list(&inside, &given[1], 1);
	entries[0] = (TextureEntry){0, given[1].texture};
	entries[1] = (TextureEntry){1, given[0].texture};
	cursor_end(&inside);
	pattern_init(&texture->pattern, pattern_find("checker"));
	texture->kind = TEXTURE_LIST;
	texture->textures = entries;
	texture->texture_count = 2;
}

enum { MATERIAL_MAP_MAX = 256 };

static void take_material_map(Cursor *cursor, Texture *texture)
{
	Context *context = cursor->context;
	Cursor inside = cursor_begin(context, cursor_next(cursor));
	double bump_size = 0;
	const ImageMap *image = build_image(&inside, W_material_map, &bump_size);
	TextureEntry *entries = ARENA_ARRAY(scene_arena(context), TextureEntry, MATERIAL_MAP_MAX);
	int count = build_texture_list(&inside, entries, MATERIAL_MAP_MAX);
	if (count == 0)
		cursor_expected(&inside, "'texture {'");
	cursor_end(&inside);
	if (!image || count == 0)
		return;
	texture->kind = TEXTURE_MATERIAL_MAP;
	texture->image = image;
	texture->textures = entries;
	texture->texture_count = count;
}

/* The rest of the block is the texture at (u, v, 0). */
static void take_uv_mapping(Cursor *cursor, Texture *texture)
{
	TextureEntry *entry = ARENA_NEW(scene_arena(cursor->context), TextureEntry);
	*entry = (TextureEntry){0, build_texture_body(cursor)};
	texture->kind = TEXTURE_UV;
	texture->textures = entry;
	texture->texture_count = 1;
}

/* ---- items ---- */

/* A pigment, normal or finish: with its block, or as POV-Ray also reads it, by its bare name. Of
 * several layers the top one changes (the manual says the bottom one; the program does not). */
static bool take_part(Cursor *cursor, Texture *texture)
{
	Context *context = cursor->context;
	while (texture->next)
		texture = (Texture *)(void *)texture->next;
	const Node *block;
	const void *named;
	if ((block = cursor_accept_block(cursor, W_pigment)))
		texture->pigment = build_pigment(context, block, texture->pigment);
	else if ((block = cursor_accept_block(cursor, W_normal)))
		texture->normal = build_normal(context, block, texture->normal);
	else if ((block = cursor_accept_block(cursor, W_finish)))
		texture->finish = build_finish(context, block, texture->finish);
	else if ((named = cursor_accept_item(cursor, VALUE_PIGMENT)))
		texture->pigment = named;
	else if ((named = cursor_accept_item(cursor, VALUE_NORMAL)))
		texture->normal = named;
	else if ((named = cursor_accept_item(cursor, VALUE_FINISH)))
		texture->finish = named;
	else
		return false;
	if (texture->kind != TEXTURE_PLAIN)
		diag_warning(context->diag, cursor_where(cursor),
		             "a pigment, normal or finish in a patterned texture has no effect");
	return true;
}

/* False when nothing that belongs here is next. */
static bool take_kind(Cursor *cursor, Texture *texture)
{
	switch (cursor_peek_word(cursor)) {
	case W_texture_map: take_texture_map(cursor, texture); return true;
	case W_tiles: take_tiles(cursor, texture); return true;
	case W_material_map: take_material_map(cursor, texture); return true;
	case W_uv_mapping: cursor_next(cursor); take_uv_mapping(cursor, texture); return true;
	case W_average:
		cursor_next(cursor);
		texture->kind = TEXTURE_AVERAGE;
		texture->pattern.class = NULL;
		return true;
	default:
		break;
	}
	if (!build_accept_pattern(cursor, &texture->pattern))
		return false;
	take_pattern(cursor, texture);
	return true;
}

static bool take_no_bump_scale(Cursor *cursor, Texture *texture)
{
	if (!cursor_accept_word(cursor, W_no_bump_scale))
		return false;
	bool keep = cursor_optional_bool(cursor);
	if (!texture->normal)
		return true;
	Normal *normal = arena_copy(scene_arena(cursor->context), texture->normal, sizeof *normal);
	normal->no_bump_scale = keep;
	texture->normal = normal;
	return true;
}

static bool take_item(Cursor *cursor, Texture *texture)
{
	Transform transform = transform_identity();
	if (take_part(cursor, texture))
		return true;
	if (build_accept_transform(cursor, &transform)) {
		transform_layers(cursor->context, texture, &transform);
		return true;
	}
	if (take_no_bump_scale(cursor, texture) || take_kind(cursor, texture))
		return true;
	return texture->kind != TEXTURE_PLAIN &&
	       build_accept_pattern_modifier(cursor, &texture->pattern);
}

/* A patterned texture without textures falls back to the default. */
static void check_entries(Cursor *cursor, Texture *texture)
{
	if (texture->kind == TEXTURE_PLAIN || texture->texture_count > 0)
		return;
	diag_error(cursor->context->diag, cursor_where(cursor),
		   "a patterned texture needs a texture_map or textures");
	texture->kind = TEXTURE_PLAIN;
}

const Texture *build_texture_body(Cursor *cursor)
{
	Context *context = cursor->context;
	const Texture *named = cursor_accept_item(cursor, VALUE_TEXTURE);
	if (named && cursor_at_end(cursor))
		return named;
	Texture *texture = copy_layers(context, named ? named : context->defaults.texture);
	if (texture->kind == TEXTURE_PLAIN && !named)
		texture->pattern = build_pattern_none();
	while (!cursor_at_end(cursor))
		if (!take_item(cursor, texture))
			cursor_unexpected(cursor);
	check_entries(cursor, texture);
	return texture;
}

const Texture *build_texture(Context *context, const Node *block)
{
	Cursor cursor = cursor_begin(context, block);
	return build_texture_body(&cursor);
}

/* ---- defaults ---- */

static void set_defaults(Context *context, const Texture *texture)
{
	context->defaults.texture = texture;
	context->defaults.pigment = texture->pigment;
	context->defaults.normal = texture->normal;
	context->defaults.finish = texture->finish;
}

void build_texture_init(Context *context)
{
	Arena *arena = scene_arena(context);
	Pigment *pigment = ARENA_NEW(arena, Pigment);
	Finish *finish = ARENA_NEW(arena, Finish);
	Texture *texture = ARENA_NEW(arena, Texture);
	*pigment = (Pigment){.kind = PIGMENT_COLOR, .pattern = build_pattern_none()};
	*finish = finish_default();
	*texture = (Texture){.kind = TEXTURE_PLAIN, .pigment = pigment, .finish = finish,
	                     .pattern = build_pattern_none()};
	set_defaults(context, texture);
}

bool build_texture_default(Context *context, const Node *block)
{
	const Defaults *defaults = &context->defaults;
	Texture *texture = arena_copy(scene_arena(context), defaults->texture, sizeof *texture);
	switch (block->word) {
	case W_pigment: texture->pigment = build_pigment(context, block, defaults->pigment); break;
	case W_normal: texture->normal = build_normal(context, block, defaults->normal); break;
	case W_finish: texture->finish = build_finish(context, block, defaults->finish); break;
	case W_texture: {
		const Texture *whole = build_texture(context, block);
		if (whole->kind == TEXTURE_PLAIN)
			*texture = *whole;
		else
			diag_error(context->diag, block->where,
				   "a patterned texture cannot be the default");
		break;
	}
	default:
		return false;
	}
	set_defaults(context, texture);
	return true;
}
