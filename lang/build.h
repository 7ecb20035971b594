/*
 * What items mean: builders turn nodes into renderer data. One builder a kind of item; tables say
 * what each word takes.
 */
#ifndef LANG_BUILD_H
#define LANG_BUILD_H

#include "lang/context.h"
#include "lang/node.h"

/* A top-level item: an object, light_source, camera, global_settings, background, fog, sky_sphere,
 * ... goes to the scene builder. Reports and returns false for what cannot stand there. */
bool build_scene_item(Context *context, const Node *item);

/* The value of an item for #declare, #local, array elements and macro arguments: texture {...},
 * object {...}, camera {...}. VALUE_NONE after an error (reported). items is the whole sequence:
 * layered textures are several blocks. */
Value build_value(Context *context, const Node *items);

/* #default { ... }: the nodes between the braces. */
void build_defaults(Context *context, const Node *items);

/* Sets up what plain POV-Ray starts with. */
void build_init(Context *context);

#endif
