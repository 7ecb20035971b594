/* pigment { ... } */
#include "lang/build_image.h"
#include "lang/build_map.h"
#include "lang/build_pattern.h"
#include "lang/build_pigment_default.h"
#include "lang/build_texture.h"

/* ---- lists ---- */

static void take_color_list(Cursor *cursor, Pigment *pigment, int most)
{
	ColorEntry *colors = ARENA_ARRAY(cursor->context->builder->arena, ColorEntry, most);
	for (int i = 0; i < most; i++) {
		colors[i] = (ColorEntry){i, build_default_list_color(&pigment->pattern, i)};
		if (cursor_peek_numeric(cursor))
			cursor_take_color(cursor, &colors[i].color);
	}
	pigment->kind = PIGMENT_COLOR_MAP;
	pigment->colors = colors;
	pigment->color_count = most;
}

static void take_pigment_list(Cursor *cursor, Pigment *pigment, int most)
{
	Arena *arena = cursor->context->builder->arena;
	PigmentEntry *entries = ARENA_ARRAY(arena, PigmentEntry, most);
	int count = build_pigment_list(cursor, entries, most);
	for (int i = count; i < most; i++)
		entries[i] = (PigmentEntry){i, cursor->context->defaults.pigment};
	pigment->kind = PIGMENT_LIST;
	pigment->pigments = entries;
	pigment->pigment_count = most;
}

static void take_list(Cursor *cursor, Pigment *pigment)
{
	int most = pigment->pattern.class->list;
	Cursor inner;
	bool braces = build_pattern_inner_list(cursor, &inner);
	Cursor *list = braces ? &inner : cursor;
	if (cursor_peek_word(list) == W_pigment)
		take_pigment_list(list, pigment, most);
	else
		take_color_list(list, pigment, most);
	if (braces)
		cursor_end(&inner);
}

/* ---- kinds ---- */

static bool is_list(const Pigment *pigment)
{
	return pigment->pattern.class && pigment->pattern.class->list > 0;
}

/* A new pattern keeps a map or a list's colours that are there already, from an identifier. */
static void become_patterned(Cursor *cursor, Pigment *pigment)
{
	if (!pigment->pattern.class) {
		pigment->kind = PIGMENT_COLOR;
		return;
	}
	if (is_list(pigment)) {
		take_list(cursor, pigment);
		return;
	}
	if (pigment->kind == PIGMENT_PIGMENT_MAP || pigment->kind == PIGMENT_LIST)
		pigment->kind = PIGMENT_PIGMENT_MAP;
	else if (pigment->color_count > 0)
		pigment->kind = PIGMENT_COLOR_MAP;
	else
		build_default_map(pigment);
}

static void take_image_map(Cursor *cursor, Pigment *pigment)
{
	Cursor inside = cursor_begin(cursor->context, cursor_next(cursor));
	double bump_size = 0;
	const ImageMap *image = build_image(&inside, W_image_map, &bump_size);
	cursor_end(&inside);
	if (image) {
		pigment->kind = PIGMENT_IMAGE;
		pigment->image = image;
	}
}

/* The rest of the block is the pigment at (u, v, 0). */
static void take_uv_mapping(Cursor *cursor, Pigment *pigment)
{
	Context *context = cursor->context;
	PigmentEntry *entry = ARENA_NEW(context->builder->arena, PigmentEntry);
	const Pigment *base = arena_copy(context->builder->arena, pigment, sizeof *base);
	*entry = (PigmentEntry){0, build_pigment_body(cursor, base)};
	pigment->kind = PIGMENT_UV;
	pigment->pigments = entry;
	pigment->pigment_count = 1;
}

static void take_color_map(Cursor *cursor, Pigment *pigment)
{
	const ColorMap *map = build_color_map(cursor->context, cursor_next(cursor));
	if (is_list(pigment))
		diag_error(cursor->context->diag, cursor->last->where,
			   "'%s' takes colours or pigments, not a map",
			   pigment->pattern.class->name);
	if (map->count == 0 || is_list(pigment))
		return;
	pigment->kind = pigment->pattern.class ? PIGMENT_COLOR_MAP : pigment->kind;
	pigment->colors = map->entries;
	pigment->color_count = map->count;
}

static void take_pigment_map(Cursor *cursor, Pigment *pigment)
{
	const PigmentMap *map = build_pigment_map(cursor->context, cursor_next(cursor));
	if (map->count == 0)
		return;
	if (pigment->kind != PIGMENT_AVERAGE && pigment->pattern.class)
		pigment->kind = PIGMENT_PIGMENT_MAP;
	pigment->pigments = map->entries;
	pigment->pigment_count = map->count;
}

static void take_quick_color(Cursor *cursor, Pigment *pigment)
{
	cursor_next(cursor);
	pigment->has_quick_color = cursor_take_color(cursor, &pigment->quick_color);
}

/* The kind of pigment or one modifier; false when none is next. */
static bool take_item(Cursor *cursor, Pigment *pigment)
{
	if (cursor_peek_numeric(cursor)) {
		cursor_take_color(cursor, &pigment->color);
		pigment->kind = PIGMENT_COLOR;
		return true;
	}
	switch (cursor_peek_word(cursor)) {
	case W_image_map: take_image_map(cursor, pigment); return true;
	case W_color_map:
	case W_colour_map: take_color_map(cursor, pigment); return true;
	case W_pigment_map: take_pigment_map(cursor, pigment); return true;
	case W_quick_color:
	case W_quick_colour: take_quick_color(cursor, pigment); return true;
	case W_uv_mapping: cursor_next(cursor); take_uv_mapping(cursor, pigment); return true;
	case W_average:
		cursor_next(cursor);
		pigment->kind = PIGMENT_AVERAGE;
		pigment->pattern.class = NULL;
		return true;
	default:
		break;
	}
	if (build_accept_pattern(cursor, &pigment->pattern)) {
		become_patterned(cursor, pigment);
		return true;
	}
	return build_accept_pattern_modifier(cursor, &pigment->pattern);
}

/* An average without pigments is grey. */
static void check_average(Cursor *cursor, Pigment *pigment)
{
	if (pigment->kind != PIGMENT_AVERAGE || pigment->pigment_count > 0)
		return;
	diag_error(cursor->context->diag, cursor_where(cursor), "average needs a pigment_map");
	pigment->kind = PIGMENT_COLOR;
}

const Pigment *build_pigment_body(Cursor *cursor, const Pigment *base)
{
	const Pigment *named = cursor_accept_item(cursor, VALUE_PIGMENT);
	if (named && cursor_at_end(cursor))
		return named;
	Pigment *pigment = arena_copy(cursor->context->builder->arena, named ? named : base,
				      sizeof *pigment);
	while (!cursor_at_end(cursor))
		if (!take_item(cursor, pigment))
			cursor_unexpected(cursor);
	check_average(cursor, pigment);
	if (cursor->context->quick_colors && pigment->has_quick_color) {
		pigment->kind = PIGMENT_COLOR;
		pigment->color = pigment->quick_color;
	}
	return pigment;
}

const Pigment *build_pigment(Context *context, const Node *block, const Pigment *base)
{
	Cursor cursor = cursor_begin(context, block);
	return build_pigment_body(&cursor, base ? base : context->defaults.pigment);
}
