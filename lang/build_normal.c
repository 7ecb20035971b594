/* normal { ... } */
#include "lang/build_image.h"
#include "lang/build_map.h"
#include "lang/build_pattern.h"
#include "lang/build_texture.h"

static const double DEFAULT_AMOUNT = 0.5;
static const double DEFAULT_ACCURACY = 0.02;

static Normal normal_initial(void)
{
	return (Normal){.kind = NORMAL_PATTERN,
			.pattern = build_pattern_none(),
			.amount = DEFAULT_AMOUNT,
			.bump_size = 1,
			.accuracy = DEFAULT_ACCURACY};
}

/* Items that the scene leaves out of a list bend nothing. */
static void take_list(Cursor *cursor, Normal *normal)
{
	Arena *arena = cursor->context->builder->arena;
	int most = normal->pattern.class->list;
	Cursor inner;
	bool braces = build_pattern_inner_list(cursor, &inner);
	Cursor *list = braces ? &inner : cursor;
	if (cursor_peek_word(list) == W_normal) {
		NormalEntry *entries = ARENA_ARRAY(arena, NormalEntry, most);
		int count = build_normal_list(list, entries, most);
		Normal *none = ARENA_NEW(arena, Normal);
		*none = normal_initial();
		for (int i = count; i < most; i++)
			entries[i] = (NormalEntry){i, none};
		normal->kind = NORMAL_LIST;
		normal->normals = entries;
		normal->normal_count = most;
	}
	if (braces)
		cursor_end(&inner);
}

static void take_bump_map(Cursor *cursor, Normal *normal)
{
	Cursor inside = cursor_begin(cursor->context, cursor_next(cursor));
	const ImageMap *image = build_image(&inside, W_bump_map, &normal->amount);
	cursor_end(&inside);
	cursor_accept_float(cursor, &normal->amount);
	if (image) {
		normal->kind = NORMAL_BUMP_MAP;
		normal->image = image;
	}
}

/* The rest of the block is the normal at (u, v, 0). */
static void take_uv_mapping(Cursor *cursor, Normal *normal)
{
	Arena *arena = cursor->context->builder->arena;
	NormalEntry *entry = ARENA_NEW(arena, NormalEntry);
	const Normal *base = arena_copy(arena, normal, sizeof *base);
	*entry = (NormalEntry){0, build_normal_body(cursor, base)};
	normal->kind = NORMAL_UV;
	normal->normals = entry;
	normal->normal_count = 1;
}

static void take_normal_map(Cursor *cursor, Normal *normal)
{
	const NormalMap *map = build_normal_map(cursor->context, cursor_next(cursor));
	if (map->count == 0)
		return;
	if (normal->kind != NORMAL_AVERAGE && normal->pattern.class)
		normal->kind = NORMAL_NORMAL_MAP;
	normal->normals = map->entries;
	normal->normal_count = map->count;
}

static void take_slope_map(Cursor *cursor, Normal *normal)
{
	const SlopeMap *map = build_slope_map(cursor->context, cursor_next(cursor));
	if (map->count == 0)
		return;
	normal->kind = NORMAL_SLOPE_MAP;
	normal->slopes = map->entries;
	normal->slope_count = map->count;
}

static void take_accuracy(Cursor *cursor, Normal *normal)
{
	double accuracy = 0;
	if (!cursor_take_float(cursor, &accuracy))
		return;
	if (accuracy == 0)
		diag_error(cursor->context->diag, cursor->last->where, "accuracy cannot be 0");
	else
		normal->accuracy = accuracy;
}

/* A new pattern forgets which items were in the list of an old one, but keeps a slope map. */
static void take_pattern(Cursor *cursor, Normal *normal)
{
	if (normal->kind != NORMAL_SLOPE_MAP && normal->kind != NORMAL_NORMAL_MAP)
		normal->kind = NORMAL_PATTERN;
	cursor_accept_float(cursor, &normal->amount);
	if (normal->pattern.class && normal->pattern.class->list > 0)
		take_list(cursor, normal);
}

/* The kind of normal or one modifier; false when none is next. */
static bool take_item(Cursor *cursor, Normal *normal)
{
	switch (cursor_peek_word(cursor)) {
	case W_bump_map: take_bump_map(cursor, normal); return true;
	case W_normal_map: take_normal_map(cursor, normal); return true;
	case W_slope_map: take_slope_map(cursor, normal); return true;
	case W_uv_mapping: cursor_next(cursor); take_uv_mapping(cursor, normal); return true;
	case W_bump_size:
		cursor_next(cursor);
		cursor_take_float(cursor, &normal->amount);
		return true;
	case W_accuracy: cursor_next(cursor); take_accuracy(cursor, normal); return true;
	case W_no_bump_scale:
		cursor_next(cursor);
		normal->no_bump_scale = cursor_optional_bool(cursor);
		return true;
	case W_average:
		cursor_next(cursor);
		cursor_accept_float(cursor, &normal->amount);
		normal->kind = NORMAL_AVERAGE;
		normal->pattern.class = NULL;
		return true;
	default:
		break;
	}
	if (build_accept_pattern(cursor, &normal->pattern)) {
		take_pattern(cursor, normal);
		return true;
	}
	return build_accept_pattern_modifier(cursor, &normal->pattern);
}

const Normal *build_normal_body(Cursor *cursor, const Normal *base)
{
	Arena *arena = cursor->context->builder->arena;
	const Normal *named = cursor_accept_item(cursor, VALUE_NORMAL);
	if (named && cursor_at_end(cursor))
		return named;
	Normal *normal = ARENA_NEW(arena, Normal);
	*normal = named ? *named : base ? *base : normal_initial();
	while (!cursor_at_end(cursor))
		if (!take_item(cursor, normal))
			cursor_unexpected(cursor);
	return normal;
}

const Normal *build_normal(Context *context, const Node *block, const Normal *base)
{
	Cursor cursor = cursor_begin(context, block);
	return build_normal_body(&cursor, base);
}
