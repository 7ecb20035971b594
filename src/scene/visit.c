#include "scene/visit.h"

#include "geom/csg.h"

void shape_visit_surfaces(const Shape *shape, SurfaceVisit *visit, void *data)
{
	if (shape->owner) {
		visit(data, shape->owner);
		return;
	}
	const Csg *csg = shape->data;
	for (int i = 0; i < csg->count; i++)
		shape_visit_surfaces(csg->children[i], visit, data);
}
