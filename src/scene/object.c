#include "scene/object.h"

Object object_default(ObjectKind kind)
{
	Object object = {.kind = kind,
			 .transform = transform_identity(),
			 .texture_transform = transform_identity()};
	object.flags = (ObjectFlags){
		.hollow = UNSET,
		.no_shadow = UNSET,
		.no_image = UNSET,
		.no_reflection = UNSET,
		.no_radiosity = UNSET,
		.double_illuminate = UNSET,
		.uv_mapping = UNSET,
		.cutaway_textures = UNSET,
		.split_union = UNSET,
		.global_lights = UNSET,
		.photons_target = UNSET,
		.photons_refraction = UNSET,
		.photons_reflection = UNSET,
		.photons_collect = UNSET,
		.photons_pass_through = UNSET,
		.relaxation = UNSET,
	};
	return object;
}

/* Copies of the objects with the transformation. */
static const Object *const *transform_all(Arena *arena, const Object *const *objects, int count,
                                          const Transform *transform)
{
	const Object **moved = ARENA_ARRAY(arena, const Object *, count);
	for (int i = 0; i < count; i++) {
		Object *copy = arena_copy(arena, objects[i], sizeof *copy);
		object_transform(arena, copy, transform);
		moved[i] = copy;
	}
	return moved;
}

void object_transform(Arena *arena, Object *object, const Transform *transform)
{
	object->transform = transform_compose(&object->transform, transform);
	object->texture_transform = transform_compose(&object->texture_transform, transform);
	if (object->clip_count)
		object->clip = transform_all(arena, object->clip, object->clip_count, transform);
	if (object->bound_count)
		object->bound = transform_all(arena, object->bound, object->bound_count, transform);
	if (object->projected_through)
		object->projected_through = transform_all(arena, &object->projected_through, 1,
							  transform)[0];
}
