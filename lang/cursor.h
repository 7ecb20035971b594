/*
 * Walking the nodes of an item: builders ask for what may come next. Three kinds of questions:
 *
 *     peek    looks only;
 *     accept  takes the next node when it is of that sort, and says whether it did;
 *     take    must be there: reports what was expected, after which word, and what was found
 * instead, and returns false.
 *
 * After a report the cursor stands at the next word, block or entry, so that the walk goes on
 * without echoes. A builder's loop ends with cursor_unexpected for a node that it has no use for,
 * which reports and skips it.
 */
#ifndef LANG_CURSOR_H
#define LANG_CURSOR_H

#include "lang/context.h"
#include "lang/node.h"

typedef struct Cursor {
	Context *context;
	const Node *at;    /* next node; NULL at the end */
	const Node *block; /* the block or entry walked; NULL for a bare sequence */
	const Node *last;  /* the last WORD or BLOCK taken, for messages; NULL before one */
} Cursor;

/* The inside of a block, an entry or a pair. */
Cursor cursor_begin(Context *context, const Node *block);
/* A bare sequence from first on. */
Cursor cursor_over(Context *context, const Node *first);

bool cursor_at_end(const Cursor *cursor);
/* Where the next node stands, or at the end where the block began. */
Location cursor_where(const Cursor *cursor);
/* Reports what is left as unexpected; true when nothing was. */
bool cursor_end(Cursor *cursor);
/* Takes the next node whatever it is; NULL at the end. */
const Node *cursor_next(Cursor *cursor);
/* Reports the next node as unexpected and skips it. */
void cursor_unexpected(Cursor *cursor);
/* Reports `expected WHAT after 'WORD', found ...` at the next node, and skips values up to the next
 * word. Always false. */
bool cursor_expected(Cursor *cursor, const char *what);

/* The word of the next node when it is a word or a block; W_NONE otherwise. */
Word cursor_peek_word(const Cursor *cursor);
bool cursor_peek_block(const Cursor *cursor);    /* a word with braces */
bool cursor_peek_entry(const Cursor *cursor);    /* [ ... ] */
bool cursor_peek_numeric(const Cursor *cursor);  /* a float, vector or colour */
bool cursor_peek_float(const Cursor *cursor);
bool cursor_peek_string(const Cursor *cursor);
bool cursor_peek_item(const Cursor *cursor, ValueKind kind);

/* A word without braces. */
bool cursor_accept_word(Cursor *cursor, Word word);
/* A word with braces; NULL when something else is next. */
const Node *cursor_accept_block(Cursor *cursor, Word word);
/* NULL when something else is next. */
const Node *cursor_accept_entry(Cursor *cursor);
/* ( a, b ); NULL when something else is next. */
const Node *cursor_accept_pair(Cursor *cursor);
bool cursor_accept_float(Cursor *cursor, double *out);
/* A vector or float; a float stands for equal components. */
bool cursor_accept_vec3(Cursor *cursor, Vec3 *out);
/* What an identifier of that kind holds; NULL when something else is next. */
const void *cursor_accept_item(Cursor *cursor, ValueKind kind);

/* These leave *out alone on failure. */
bool cursor_take_float(Cursor *cursor, double *out);
/* Cut towards 0; what an int does not hold is reported. */
bool cursor_take_int(Cursor *cursor, int *out);
/* A vector's components. */
bool cursor_take_ints(Cursor *cursor, int out[3]);
bool cursor_take_whole(Cursor *cursor, int least, int most, int *out);
bool cursor_take_vec2(Cursor *cursor, Vec2 *out);
bool cursor_take_vec3(Cursor *cursor, Vec3 *out);
/* Any numeric value; a float f is <f, f, f, 0, 0>. */
bool cursor_take_color(Cursor *cursor, Rgbft *out);
bool cursor_take_rgb(Cursor *cursor, Rgb *out);
/* count numbers, as floats or as vectors' components in a row. */
bool cursor_take_floats(Cursor *cursor, double *out, int count);
bool cursor_take_string(Cursor *cursor, const char **out);
const void *cursor_take_item(Cursor *cursor, ValueKind kind, const char *what);
/* on, off or a number; nothing stands for on. */
bool cursor_optional_bool(Cursor *cursor);
/* The number that follows, if one does. */
double cursor_optional_float(Cursor *cursor, double otherwise);

#endif
