/* photons { } in global_settings, objects and lights, and the extension's estimator { }. */
#ifndef LANG_BUILD_PHOTONS_H
#define LANG_BUILD_PHOTONS_H

#include "lang/context.h"
#include "lang/node.h"
#include "scene/object.h"

void build_photons_global(Context *context, const Node *block, PhotonSettings *settings);
void build_photons_object(Context *context, const Node *block, Object *object);
void build_photons_light(Context *context, const Node *block, Light *light);
/* In the scene arena; NULL after a reported error. */
const Estimator *build_estimator(Context *context, const Node *block);

#endif
