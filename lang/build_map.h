/*
 * Maps and lists: what stands in the square brackets of color_map, pigment_map, normal_map,
 * slope_map, texture_map, and the items behind a list pattern (checker, brick...). Their values
 * (VALUE_COLOR_MAP...) point to the structs below.
 */
#ifndef LANG_BUILD_MAP_H
#define LANG_BUILD_MAP_H

#include "lang/context.h"
#include "lang/cursor.h"
#include "surface/texture.h"

typedef struct ColorMap { const ColorEntry *entries; int count; } ColorMap;
typedef struct PigmentMap { const PigmentEntry *entries; int count; } PigmentMap;
typedef struct NormalMap { const NormalEntry *entries; int count; } NormalMap;
typedef struct SlopeMap { const SlopeEntry *entries; int count; } SlopeMap;
typedef struct TextureMap { const TextureEntry *entries; int count; } TextureMap;

/* The block's inside: an identifier or entries. Weights are the keys of an average, 1 when an entry
 * gives none. Empty (count 0) after a reported error. */
const ColorMap *build_color_map(Context *context, const Node *block);
const SlopeMap *build_slope_map(Context *context, const Node *block);
const PigmentMap *build_pigment_map(Context *context, const Node *block);
const NormalMap *build_normal_map(Context *context, const Node *block);
const TextureMap *build_texture_map(Context *context, const Node *block);

/* What stands inside the braces of the blocks, from the cursor to its end; for map entries and
 * uv_mapping, which have no braces. */
const Pigment *build_pigment_body(Cursor *cursor, const Pigment *base);
const Normal *build_normal_body(Cursor *cursor, const Normal *base);
const Texture *build_texture_body(Cursor *cursor);

/* Blocks of items behind a list pattern of `most` entries: pigment { }, normal { }, texture { };
 * entries keyed 0, 1, 2... They fill *entries (room for most) and give how many were taken. */
int build_pigment_list(Cursor *cursor, PigmentEntry *entries, int most);
int build_normal_list(Cursor *cursor, NormalEntry *entries, int most);
int build_texture_list(Cursor *cursor, TextureEntry *entries, int most);

#endif
