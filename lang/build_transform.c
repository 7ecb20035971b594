#include "lang/build_transform.h"

bool build_peek_transform(const Cursor *cursor)
{
	switch (cursor_peek_word(cursor)) {
	case W_translate:
	case W_rotate:
	case W_scale:
	case W_matrix:
	case W_transform:
		return true;
	default:
		return false;
	}
}

/* A factor of 0 counts as 1, with a warning, as in POV-Ray. */
static Transform scale_by(Cursor *cursor, Vec3 by)
{
	if (by.x == 0 || by.y == 0 || by.z == 0)
		diag_warning(cursor->context->diag, cursor->last->where,
			     "scale by 0 taken as scale by 1");
	return transform_scale(by);
}

/* A column of nothing but 0, which would make all things flat, gets a 1, as in POV-Ray. */
static void fill_columns(Cursor *cursor, double rows[12])
{
	for (int k = 0; k < 3; k++) {
		if (rows[k] != 0 || rows[3 + k] != 0 || rows[6 + k] != 0)
			continue;
		rows[4 * k] = 1;
		diag_warning(cursor->context->diag, cursor->last->where,
			     "scale by 0 taken as scale by 1");
	}
}

static Transform take_matrix(Cursor *cursor)
{
	double rows[12];
	Transform matrix = transform_identity();
	if (!cursor_take_floats(cursor, rows, 12))
		return matrix;
	fill_columns(cursor, rows);
	if (!transform_matrix(rows, &matrix))
		diag_error(cursor->context->diag, cursor->last->where,
			   "this matrix cannot be inverted");
	return matrix;
}

/* transform { ... } or transform Name. */
static Transform take_transform(Cursor *cursor)
{
	const Node *block = cursor_accept_block(cursor, W_transform);
	if (block)
		return build_transform(cursor->context, block);
	cursor_accept_word(cursor, W_transform);
	const Transform *named = cursor_take_item(cursor, VALUE_TRANSFORM, "a transform");
	return named ? *named : transform_identity();
}

static Transform take_one(Cursor *cursor)
{
	Vec3 by = {0, 0, 0};
	if (cursor_peek_word(cursor) == W_transform)
		return take_transform(cursor);
	Word word = cursor_next(cursor)->word;
	if (word == W_matrix)
		return take_matrix(cursor);
	if (!cursor_take_vec3(cursor, &by))
		return transform_identity();
	if (word == W_translate)
		return transform_translate(by);
	return word == W_rotate ? transform_rotate(by) : scale_by(cursor, by);
}

bool build_accept_transform(Cursor *cursor, Transform *transform)
{
	if (!build_peek_transform(cursor))
		return false;
	Transform next = take_one(cursor);
	*transform = transform_compose(transform, &next);
	return true;
}

Transform build_transform(Context *context, const Node *block)
{
	Cursor cursor = cursor_begin(context, block);
	Transform sum = transform_identity();
	bool inverse = false;
	while (!cursor_at_end(&cursor)) {
		const Transform *named = cursor_accept_item(&cursor, VALUE_TRANSFORM);
		if (named)
			sum = transform_compose(&sum, named);
		else if (cursor_accept_word(&cursor, W_inverse))
			inverse = true;
		else if (!build_accept_transform(&cursor, &sum))
			cursor_unexpected(&cursor);
	}
	return inverse ? transform_inverse(&sum) : sum;
}
