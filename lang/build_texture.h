/*
 * Builders of what a surface and the space behind it look like: texture, pigment, normal, finish, interior, material and
 * their maps. Each takes the BLOCK node and gives an immutable thing in the scene arena; mistakes are reported and what was
 * read so far, or the default, stands, so none returns NULL.
 */
#ifndef LANG_BUILD_TEXTURE_H
#define LANG_BUILD_TEXTURE_H

#include "lang/context.h"
#include "lang/node.h"
#include "surface/texture.h"

/* What VALUE_MATERIAL points to. Any of them may be NULL. */
typedef struct Material {
	const Texture *texture, *interior_texture;
	const Interior *interior;
} Material;

const Texture *build_texture(Context *context, const Node *block); /* texture or interior_texture { }; several layers from an identifier */
const Pigment *build_pigment(Context *context, const Node *block);
const Normal *build_normal(Context *context, const Node *block);
const Finish *build_finish(Context *context, const Node *block);
const Interior *build_interior(Context *context, const Interior *base, const Node *block); /* base or NULL: what it modifies */
const Material *build_material(Context *context, const Node *block);
/* color_map, pigment_map, normal_map, slope_map, texture_map, density_map { }; VALUE_NONE after a reported error. */
Value build_map(Context *context, const Node *block);

/* above on top of below (either may be NULL): the order of texture blocks. Patterned textures cannot be layered: reported. */
const Texture *build_texture_layer(Context *context, const Texture *below, const Texture *above, Location where);
/* A texture, pigment, normal or finish block standing in an object: layers on, or changes part of, *texture (NULL: none
 * yet). False for any other block. */
bool build_texture_part(Context *context, const Node *block, const Texture **texture);

/* One block of #default: texture, pigment, normal or finish. False for any other. */
bool build_texture_default(Context *context, const Node *block);
/* Fills the texture, pigment, normal and finish of context->defaults with POV-Ray's initial ones. */
void build_texture_init(Context *context);

#endif
