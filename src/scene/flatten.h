/*
 * From the object tree to shapes in world space: transforms composed down to the leaves, textures,
 * interiors and flags inherited, unions taken apart so that the accelerator sees each member,
 * lights collected. Inversion is pushed down to the primitives (De Morgan), so a CSG shape is never
 * inverted itself.
 *
 * bounded_by is kept only where the shape would be unbounded without: elsewhere the box does the
 * same work.
 */
#ifndef SCENE_FLATTEN_H
#define SCENE_FLATTEN_H

#include "scene/object.h"

typedef struct FlatScene {
	const Shape *const *shapes; int shape_count; /* primitives and CSG; owners are Surfaces */
	const Light *lights; int light_count;
	bool hides_from_image, hides_from_reflection; /* some surface: no_image, no_reflection */
} FlatScene;

/* Results live in the arena. Objects are the top level, in order. */
FlatScene scene_flatten(Arena *arena, const Object *const *objects, int count);

/* The object tree as one shape (a union when it is several), without owner surfaces: for trace(),
 * inside(), min_extent(), object patterns, containers and clips. Lights have no shape. */
const Shape *object_shape(Arena *arena, const Object *object);

#endif
