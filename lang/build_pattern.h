/*
 * Patterns: the words that pigments, normals, textures and `pattern { }` share, from the pattern's name with its parameters
 * to its modifiers. A table has a row for each.
 */
#ifndef LANG_BUILD_PATTERN_H
#define LANG_BUILD_PATTERN_H

#include "lang/context.h"
#include "lang/node.h"
#include "surface/pattern.h"

/* pattern { ... } of functions. In the scene arena; NULL after a reported error. */
const Pattern *build_pattern_block(Context *context, const Node *block);

#endif
