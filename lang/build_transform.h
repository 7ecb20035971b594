/* Transformations as they stand among an item's words: translate, rotate, scale, matrix and
 * transform. */
#ifndef LANG_BUILD_TRANSFORM_H
#define LANG_BUILD_TRANSFORM_H

#include "base/transform.h"
#include "lang/cursor.h"

/* Takes one transformation if one is next and puts it after what *transform does already; false
 * when none is next. A mistake in it is reported and counts as taken. */
bool build_accept_transform(Cursor *cursor, Transform *transform);
/* True when a transformation is next. */
bool build_peek_transform(const Cursor *cursor);
/* transform { ... }: the whole block. */
Transform build_transform(Context *context, const Node *block);

#endif
