/*
 * Builders of what a surface looks like and of what fills a body. A block is the node with the
 * braces; base is what the block modifies when it begins with no identifier of its own kind (the
 * object's present pigment, the default finish). Results live in the scene's arena and never
 * change. After a reported error they still return something usable.
 */
#ifndef LANG_BUILD_TEXTURE_H
#define LANG_BUILD_TEXTURE_H

#include "lang/context.h"
#include "lang/cursor.h"
#include "lang/node.h"

/* material { }: any of the three may be NULL. */
typedef struct Material {
	const Texture *texture, *interior_texture;
	const Interior *interior;
} Material;

/* texture { } or interior_texture { }: the bottom of the list of layers that the one block stands
 * for (an identifier may hold several). */
const Texture *build_texture(Context *context, const Node *block);
/* bottom's layers with top's above them: copies of the structs of bottom's list, top shared. bottom
 * may be NULL. */
const Texture *build_texture_stack(Context *context, const Texture *bottom, const Texture *top);
/* Every layer of the list with a further transformation; copies. */
const Texture *build_texture_transform(Context *context, const Texture *texture,
				       const Transform *transform);

const Pigment *build_pigment(Context *context, const Node *block, const Pigment *base);
const Normal *build_normal(Context *context, const Node *block,
			   const Normal *base); /* base may be NULL */
const Finish *build_finish(Context *context, const Node *block, const Finish *base);
const Interior *build_interior(Context *context, const Node *block,
			       const Interior *base); /* base may be NULL */
const Material *build_material(Context *context, const Node *block);

/* color_map { }, colour_map, pigment_map, normal_map, slope_map, texture_map: a value of the
 * matching kind, VALUE_NONE after an error. */
Value build_map(Context *context, const Node *block);

/* Fills context->defaults' texture, pigment, normal and finish with what plain POV-Ray starts with.
 */
void build_texture_init(Context *context);
/* One block of #default { }: texture, pigment, normal or finish; false when it is none of these. */
bool build_texture_default(Context *context, const Node *block);

#endif
