#include "lang/cursor.h"

#include <limits.h>
#include <math.h>
#include <string.h>

Cursor cursor_begin(Context *context, const Node *block)
{
	return (Cursor){.context = context, .at = block->children, .block = block};
}

Cursor cursor_over(Context *context, const Node *first)
{
	return (Cursor){.context = context, .at = first};
}

bool cursor_at_end(const Cursor *cursor) { return !cursor->at; }

Location cursor_where(const Cursor *cursor)
{
	if (cursor->at)
		return cursor->at->where;
	if (cursor->last)
		return cursor->last->where;
	return cursor->block ? cursor->block->where : (Location){0};
}

const Node *cursor_next(Cursor *cursor)
{
	const Node *node = cursor->at;
	if (!node)
		return NULL;
	cursor->at = node->next;
	if (node->kind == NODE_WORD || node->kind == NODE_BLOCK)
		cursor->last = node;
	return node;
}

/* What a node is, for messages; lives in the item arena. */
static const char *describe(const Cursor *cursor)
{
	Arena *arena = cursor->context->items;
	const Node *node = cursor->at;
	if (!node)
		return cursor->block && cursor->block->kind == NODE_ENTRY ? "']'" : "'}'";
	switch (node->kind) {
	case NODE_VALUE:
	case NODE_ITEM:
		return value_describe(node->value);
	case NODE_WORD:
		return arena_printf(arena, "'%s'", word_text(node->word));
	case NODE_BLOCK:
		return arena_printf(arena, "'%s {'", word_text(node->word));
	case NODE_ENTRY:
		return "'['";
	case NODE_PAIR:
		return "'('";
	}
	return "something else";
}

/* " after 'phong'" or " in 'sphere'", or nothing. */
static const char *describe_place(const Cursor *cursor)
{
	Arena *arena = cursor->context->items;
	if (cursor->last)
		return arena_printf(arena, " after '%s'", word_text(cursor->last->word));
	if (cursor->block && cursor->block->kind == NODE_BLOCK)
		return arena_printf(arena, " in '%s'", word_text(cursor->block->word));
	return "";
}

bool cursor_expected(Cursor *cursor, const char *what)
{
	diag_error(cursor->context->diag, cursor_where(cursor), "expected %s%s, found %s", what,
		   describe_place(cursor), describe(cursor));
	while (cursor->at && (cursor->at->kind == NODE_VALUE || cursor->at->kind == NODE_ITEM))
		cursor->at = cursor->at->next;
	return false;
}

static const char *without_article(const char *what)
{
	if (strncmp(what, "a ", 2) == 0)
		return what + 2;
	return strncmp(what, "an ", 3) == 0 ? what + 3 : what;
}

void cursor_unexpected(Cursor *cursor)
{
	if (!cursor->at)
		return;
	const char *what = without_article(describe(cursor));
	if (cursor->block && cursor->block->kind == NODE_BLOCK)
		diag_error(cursor->context->diag, cursor->at->where, "unexpected %s in '%s'", what,
		           word_text(cursor->block->word));
	else
		diag_error(cursor->context->diag, cursor->at->where, "unexpected %s", what);
	cursor->at = cursor->at->next;
	while (cursor->at && (cursor->at->kind == NODE_VALUE || cursor->at->kind == NODE_ITEM))
		cursor->at = cursor->at->next;
}

bool cursor_end(Cursor *cursor)
{
	bool clean = cursor_at_end(cursor);
	while (!cursor_at_end(cursor))
		cursor_unexpected(cursor);
	return clean;
}

Word cursor_peek_word(const Cursor *cursor)
{
	const Node *node = cursor->at;
	return node && (node->kind == NODE_WORD || node->kind == NODE_BLOCK) ? node->word : W_NONE;
}

bool cursor_peek_block(const Cursor *cursor)
{
	return cursor->at && cursor->at->kind == NODE_BLOCK;
}

bool cursor_peek_entry(const Cursor *cursor)
{
	return cursor->at && cursor->at->kind == NODE_ENTRY;
}

static bool peek_value(const Cursor *cursor, ValueKind kind)
{
	return cursor->at && cursor->at->kind == NODE_VALUE && cursor->at->value.kind == kind;
}

bool cursor_peek_numeric(const Cursor *cursor)
{
	return cursor->at && cursor->at->kind == NODE_VALUE && value_is_numeric(cursor->at->value);
}

bool cursor_peek_float(const Cursor *cursor) { return peek_value(cursor, VALUE_FLOAT); }

bool cursor_peek_string(const Cursor *cursor) { return peek_value(cursor, VALUE_STRING); }

bool cursor_peek_item(const Cursor *cursor, ValueKind kind)
{
	return cursor->at && cursor->at->kind == NODE_ITEM && cursor->at->value.kind == kind;
}

bool cursor_accept_word(Cursor *cursor, Word word)
{
	if (!cursor->at || cursor->at->kind != NODE_WORD || cursor->at->word != word)
		return false;
	cursor_next(cursor);
	return true;
}

const Node *cursor_accept_block(Cursor *cursor, Word word)
{
	if (!cursor_peek_block(cursor) || cursor->at->word != word)
		return NULL;
	return cursor_next(cursor);
}

const Node *cursor_accept_entry(Cursor *cursor)
{
	return cursor_peek_entry(cursor) ? cursor_next(cursor) : NULL;
}

const Node *cursor_accept_pair(Cursor *cursor)
{
	return cursor->at && cursor->at->kind == NODE_PAIR ? cursor_next(cursor) : NULL;
}

bool cursor_accept_float(Cursor *cursor, double *out)
{
	return cursor_peek_float(cursor) && cursor_take_float(cursor, out);
}

bool cursor_accept_vec3(Cursor *cursor, Vec3 *out)
{
	return cursor_peek_numeric(cursor) && cursor_take_vec3(cursor, out);
}

const void *cursor_accept_item(Cursor *cursor, ValueKind kind)
{
	return cursor_peek_item(cursor, kind) ? cursor_next(cursor)->value.item : NULL;
}

bool cursor_take_float(Cursor *cursor, double *out)
{
	if (!cursor_peek_float(cursor))
		return cursor_expected(cursor, "a float");
	*out = cursor_next(cursor)->value.number;
	return true;
}

static bool to_int(Cursor *cursor, Location where, double number, int *out)
{
	bool fits = number > INT_MIN - 1.0 && number < INT_MAX + 1.0;
	if (fits)
		*out = (int)number;
	else
		diag_error(cursor->context->diag, where,
			   "a whole number is from %d to %d here, not %g", INT_MIN, INT_MAX,
			   number);
	return fits;
}

bool cursor_take_int(Cursor *cursor, int *out)
{
	Location where = cursor_where(cursor);
	double number;
	return cursor_take_float(cursor, &number) && to_int(cursor, where, number, out);
}

bool cursor_take_ints(Cursor *cursor, int out[3])
{
	Location where = cursor_where(cursor);
	Vec3 v;
	return cursor_take_vec3(cursor, &v) && to_int(cursor, where, v.x, &out[0]) &&
	       to_int(cursor, where, v.y, &out[1]) && to_int(cursor, where, v.z, &out[2]);
}

bool cursor_take_whole(Cursor *cursor, int least, int most, int *out)
{
	Location where = cursor_where(cursor);
	int number;
	if (!cursor_take_int(cursor, &number))
		return false;
	bool fits = number >= least && number <= most;
	if (fits)
		*out = number;
	else
		diag_error(cursor->context->diag, where, "this must be from %d to %d, not %d",
			   least, most, number);
	return fits;
}

bool cursor_take_vec2(Cursor *cursor, Vec2 *out)
{
	if (!cursor_peek_numeric(cursor))
		return cursor_expected(cursor, "a vector");
	*out = value_to_vec2(cursor_next(cursor)->value);
	return true;
}

bool cursor_take_vec3(Cursor *cursor, Vec3 *out)
{
	if (!cursor_peek_numeric(cursor))
		return cursor_expected(cursor, "a vector");
	*out = value_to_vec3(cursor_next(cursor)->value);
	return true;
}

bool cursor_take_color(Cursor *cursor, Rgbft *out)
{
	if (!cursor_peek_numeric(cursor))
		return cursor_expected(cursor, "a colour");
	Value value = cursor_next(cursor)->value;
	*out = value_to_rgbft(value);
	if (value.kind == VALUE_FLOAT)
		out->filter = out->transmit = 0;
	return true;
}

bool cursor_take_rgb(Cursor *cursor, Rgb *out)
{
	Rgbft color;
	if (!cursor_take_color(cursor, &color))
		return false;
	*out = rgbft_rgb(color);
	return true;
}

bool cursor_take_floats(Cursor *cursor, double *out, int count)
{
	int filled = 0;
	while (filled < count) {
		if (!cursor_peek_numeric(cursor))
			return cursor_expected(
				cursor, arena_printf(cursor->context->items, "%d floats", count));
		Value value = cursor_next(cursor)->value;
		if (value.kind == VALUE_FLOAT)
			out[filled++] = value.number;
		for (int i = 0; value.kind != VALUE_FLOAT && i < value.size && filled < count; i++)
			out[filled++] = value.v[i];
	}
	return true;
}

bool cursor_take_string(Cursor *cursor, const char **out)
{
	if (!cursor_peek_string(cursor))
		return cursor_expected(cursor, "a string");
	*out = cursor_next(cursor)->value.string;
	return true;
}

const void *cursor_take_item(Cursor *cursor, ValueKind kind, const char *what)
{
	const void *item = cursor_accept_item(cursor, kind);
	if (!item)
		cursor_expected(cursor, what);
	return item;
}

bool cursor_optional_bool(Cursor *cursor)
{
	return cursor_optional_float(cursor, 1) != 0;
}

double cursor_optional_float(Cursor *cursor, double otherwise)
{
	double number = otherwise;
	cursor_accept_float(cursor, &number);
	return number;
}
