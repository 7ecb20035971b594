/*
 * Patterns: the words that pigments, normals, textures and `pattern { }` share, from the pattern's
 * name with its parameters to its modifiers. Two tables have a row for each; a new pattern is one
 * row here and one class in the surface room.
 */
#ifndef LANG_BUILD_PATTERN_H
#define LANG_BUILD_PATTERN_H

#include "lang/context.h"
#include "lang/cursor.h"
#include "lang/node.h"
#include "surface/pattern.h"

/* No class and no warps. */
Pattern build_pattern_none(void);
/* Takes a pattern's word and its parameters if one is next: *pattern becomes of that class and
 * keeps its warps. False when none is next; a reported mistake counts as taken. */
bool build_accept_pattern(Cursor *cursor, Pattern *pattern);
/* After build_accept_pattern: true for an object pattern, whose list of colours or such stands
 * inside its braces, where *list then stands. */
bool build_pattern_inner_list(const Cursor *cursor, Cursor *list);
/* Takes one modifier (turbulence, frequency, warp, a transformation, a class' own...) if one is
 * next. */
bool build_accept_pattern_modifier(Cursor *cursor, Pattern *pattern);
/* warp { ... } put behind what *pattern has. */
void build_warp(Context *context, const Node *block, Pattern *pattern);
void build_pattern_transform(Context *context, Pattern *pattern, const Transform *transform);

/* The parameters of a pattern's class, copied so that they may be changed; defaults (of size bytes)
 * when there are none. */
void *build_pattern_data(Context *context, Pattern *pattern, const void *defaults, size_t size);

/* pattern { ... } of functions. In the scene arena; NULL after a reported error. */
const Pattern *build_pattern_block(Context *context, const Node *block);

/* Words of `#version` below this one mean what they meant then; a scene that gives no version
 * counts as 3.62. */
bool build_version_before(const Context *context, double version);

#endif
