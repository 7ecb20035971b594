/* The surfaces of shapes: of a primitive its owner, of a CSG its children's. */
#ifndef SCENE_VISIT_H
#define SCENE_VISIT_H

#include "scene/object.h"

typedef void SurfaceVisit(void *data, const Surface *surface);

void shape_visit_surfaces(const Shape *shape, SurfaceVisit *visit, void *data);

#endif
