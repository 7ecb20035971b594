/*
 * camera { }. The order of its words does not count: angle sets the length of direction from the
 * final right vector, then look_at turns the frame, then transformations move it. (Measured on
 * POV-Ray 3.7.)
 */
#ifndef LANG_BUILD_CAMERA_H
#define LANG_BUILD_CAMERA_H

#include "lang/context.h"
#include "lang/node.h"
#include "scene/camera.h"

/* In the scene arena; never NULL. base: what an empty block means. */
const Camera *build_camera(Context *context, const Node *block, const Camera *base);

#endif
