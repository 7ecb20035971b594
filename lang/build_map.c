#include "lang/build_map.h"

#include "lang/build_texture.h"

enum { MAP_MAX_ENTRIES = 4096 };

/* A growing array of entries in the item arena, copied to the scene's at the end. */
typedef struct Entries {
	Context *context;
	size_t size; /* of one entry */
	char *data;
	int count, capacity;
} Entries;

static Entries entries_create(Context *context, size_t size)
{
	return (Entries){context, size, NULL, 0, 0};
}

/* The address of a new, zeroed entry. */
static void *entries_add(Entries *entries)
{
	if (entries->count == entries->capacity) {
		int capacity = entries->capacity ? 2 * entries->capacity : 16;
		char *data = arena_alloc(entries->context->items, entries->size * (size_t)capacity);
		for (size_t i = 0; i < entries->size * (size_t)entries->count; i++)
			data[i] = entries->data[i];
		entries->data = data;
		entries->capacity = capacity;
	}
	return entries->data + entries->size * (size_t)entries->count++;
}

static const void *entries_finish(const Entries *entries)
{
	return arena_copy(entries->context->builder->arena, entries->data,
			  entries->size * (size_t)entries->count);
}

/* The next [ ... ] of the map's block; NULL at its end, with anything else reported. */
static const Node *next_entry(Cursor *cursor, const Entries *entries)
{
	while (!cursor_at_end(cursor)) {
		const Node *entry = cursor_accept_entry(cursor);
		if (entry && entries->count < MAP_MAX_ENTRIES)
			return entry;
		if (!entry)
			cursor_unexpected(cursor);
	}
	if (entries->count == 0)
		cursor_expected(cursor, "'[' and an entry of the map");
	return NULL;
}

/* ---- colours ---- */

/* [key color] or the old [key key color color]. */
static void add_color(Cursor *inside, Entries *entries)
{
	double key = 0, second = 0;
	Rgbft color = {0, 0, 0, 0, 0};
	if (!cursor_take_float(inside, &key))
		return;
	/* Two floats: a grey, unless colours follow the second one. */
	bool is_double = cursor_peek_float(inside) && inside->at->next;
	if (is_double)
		cursor_take_float(inside, &second);
	if (!cursor_take_color(inside, &color))
		return;
	*(ColorEntry *)entries_add(entries) = (ColorEntry){key, color};
	if (!is_double)
		return;
	if (cursor_take_color(inside, &color))
		*(ColorEntry *)entries_add(entries) = (ColorEntry){second, color};
}

const ColorMap *build_color_map(Context *context, const Node *block)
{
	Cursor cursor = cursor_begin(context, block);
	const ColorMap *named = cursor_accept_item(&cursor, VALUE_COLOR_MAP);
	if (named && cursor_end(&cursor))
		return named;
	Entries entries = entries_create(context, sizeof(ColorEntry));
	for (const Node *entry; (entry = next_entry(&cursor, &entries));) {
		Cursor inside = cursor_begin(context, entry);
		add_color(&inside, &entries);
		cursor_end(&inside);
	}
	ColorMap *map = ARENA_NEW(context->builder->arena, ColorMap);
	*map = (ColorMap){entries_finish(&entries), entries.count};
	return map;
}

/* ---- slopes ---- */

/* [key, <height, slope>] or [key height] */
static void add_slope(Cursor *inside, Entries *entries)
{
	double key = 0;
	Vec2 value = {0, 0};
	if (!cursor_take_float(inside, &key))
		return;
	if (cursor_peek_float(inside))
		cursor_take_float(inside, &value.u);
	else if (!cursor_take_vec2(inside, &value))
		return;
	*(SlopeEntry *)entries_add(entries) = (SlopeEntry){key, value.u, value.v};
}

const SlopeMap *build_slope_map(Context *context, const Node *block)
{
	Cursor cursor = cursor_begin(context, block);
	const SlopeMap *named = cursor_accept_item(&cursor, VALUE_SLOPE_MAP);
	if (named && cursor_end(&cursor))
		return named;
	Entries entries = entries_create(context, sizeof(SlopeEntry));
	for (const Node *entry; (entry = next_entry(&cursor, &entries));) {
		Cursor inside = cursor_begin(context, entry);
		add_slope(&inside, &entries);
		cursor_end(&inside);
	}
	SlopeMap *map = ARENA_NEW(context->builder->arena, SlopeMap);
	*map = (SlopeMap){entries_finish(&entries), entries.count};
	return map;
}

/* ---- pigments, normals, textures ---- */

const PigmentMap *build_pigment_map(Context *context, const Node *block)
{
	Cursor cursor = cursor_begin(context, block);
	const PigmentMap *named = cursor_accept_item(&cursor, VALUE_PIGMENT_MAP);
	if (named && cursor_end(&cursor))
		return named;
	Entries entries = entries_create(context, sizeof(PigmentEntry));
	for (const Node *entry; (entry = next_entry(&cursor, &entries));) {
		Cursor inside = cursor_begin(context, entry);
		double key = cursor_optional_float(&inside, 1);
		const Pigment *pigment = build_pigment_body(&inside, context->defaults.pigment);
		*(PigmentEntry *)entries_add(&entries) = (PigmentEntry){key, pigment};
	}
	PigmentMap *map = ARENA_NEW(context->builder->arena, PigmentMap);
	*map = (PigmentMap){entries_finish(&entries), entries.count};
	return map;
}

const NormalMap *build_normal_map(Context *context, const Node *block)
{
	Cursor cursor = cursor_begin(context, block);
	const NormalMap *named = cursor_accept_item(&cursor, VALUE_NORMAL_MAP);
	if (named && cursor_end(&cursor))
		return named;
	Entries entries = entries_create(context, sizeof(NormalEntry));
	for (const Node *entry; (entry = next_entry(&cursor, &entries));) {
		Cursor inside = cursor_begin(context, entry);
		double key = cursor_optional_float(&inside, 1);
		const Normal *normal = build_normal_body(&inside, context->defaults.normal);
		*(NormalEntry *)entries_add(&entries) = (NormalEntry){key, normal};
	}
	NormalMap *map = ARENA_NEW(context->builder->arena, NormalMap);
	*map = (NormalMap){entries_finish(&entries), entries.count};
	return map;
}

const TextureMap *build_texture_map(Context *context, const Node *block)
{
	Cursor cursor = cursor_begin(context, block);
	const TextureMap *named = cursor_accept_item(&cursor, VALUE_TEXTURE_MAP);
	if (named && cursor_end(&cursor))
		return named;
	Entries entries = entries_create(context, sizeof(TextureEntry));
	for (const Node *entry; (entry = next_entry(&cursor, &entries));) {
		Cursor inside = cursor_begin(context, entry);
		double key = cursor_optional_float(&inside, 1);
		const Texture *texture = build_texture_body(&inside);
		*(TextureEntry *)entries_add(&entries) = (TextureEntry){key, texture};
	}
	TextureMap *map = ARENA_NEW(context->builder->arena, TextureMap);
	*map = (TextureMap){entries_finish(&entries), entries.count};
	return map;
}

Value build_map(Context *context, const Node *block)
{
	switch (block->word) {
	case W_color_map:
	case W_colour_map: return value_item(VALUE_COLOR_MAP, build_color_map(context, block));
	case W_pigment_map: return value_item(VALUE_PIGMENT_MAP, build_pigment_map(context, block));
	case W_normal_map: return value_item(VALUE_NORMAL_MAP, build_normal_map(context, block));
	case W_slope_map: return value_item(VALUE_SLOPE_MAP, build_slope_map(context, block));
	case W_texture_map: return value_item(VALUE_TEXTURE_MAP, build_texture_map(context, block));
	default:
		diag_error(context->diag, block->where, "'%s' is no map", word_text(block->word));
		return value_none();
	}
}

/* ---- lists ---- */

int build_pigment_list(Cursor *cursor, PigmentEntry *entries, int most)
{
	int count = 0;
	const Node *block;
	while (count < most && (block = cursor_accept_block(cursor, W_pigment))) {
		const Pigment *pigment = build_pigment(cursor->context, block,
						       cursor->context->defaults.pigment);
		entries[count] = (PigmentEntry){count, pigment};
		count++;
	}
	return count;
}

int build_normal_list(Cursor *cursor, NormalEntry *entries, int most)
{
	int count = 0;
	const Node *block;
	while (count < most && (block = cursor_accept_block(cursor, W_normal))) {
		const Normal *normal = build_normal(cursor->context, block,
						    cursor->context->defaults.normal);
		entries[count] = (NormalEntry){count, normal};
		count++;
	}
	return count;
}

int build_texture_list(Cursor *cursor, TextureEntry *entries, int most)
{
	int count = 0;
	const Node *block;
	while (count < most && (block = cursor_accept_block(cursor, W_texture))) {
		entries[count] = (TextureEntry){count, build_texture(cursor->context, block)};
		count++;
	}
	return count;
}
