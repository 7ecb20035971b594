/* What lies around the objects: background, fog, rainbow, sky_sphere. Results live in the scene
 * arena and are never NULL. */
#ifndef LANG_BUILD_ATMOSPHERE_H
#define LANG_BUILD_ATMOSPHERE_H

#include "lang/context.h"
#include "lang/node.h"

void build_background(Context *context, const Node *block);
const Fog *build_fog(Context *context, const Node *block);
const Rainbow *build_rainbow(Context *context, const Node *block);
const SkySphere *build_sky_sphere(Context *context, const Node *block);

#endif
