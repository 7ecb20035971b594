#include "scene/scene.h"

#include <string.h>

#include "scene/accel.h"
#include "scene/flatten.h"

Settings settings_default(void)
{
	return (Settings){
		.adc_bailout = 1.0 / 255,
		.ambient_light = {1, 1, 1},
		.max_trace_level = 5,
		.max_intersections = 64,
		.number_of_waves = 10,
		.noise_generator = 2,
		.irid_wavelength = {0.70f, 0.52f, 0.48f},
		.mm_per_unit = 10,
		.photons = photon_settings_default(),
		.version = 3.7,
	};
}

/* The array of count pointers with room for one more: its capacity is the next power of two. The
 * arena keeps the old ones. */
static void *grow(Arena *arena, const void *array, int count)
{
	if (count & (count - 1))
		return (void *)array;
	void *larger = ARENA_ARRAY(arena, const void *, count ? 2 * count : 1);
	if (count)
		memcpy(larger, array, (size_t)count * sizeof(void *));
	return larger;
}

void scene_builder_add_object(SceneBuilder *builder, const Object *object)
{
	builder->objects = grow(builder->arena, builder->objects, builder->object_count);
	builder->objects[builder->object_count++] = object;
}

void scene_builder_add_fog(SceneBuilder *builder, const Fog *fog)
{
	builder->fogs = grow(builder->arena, builder->fogs, builder->fog_count);
	builder->fogs[builder->fog_count++] = fog;
}

void scene_builder_add_rainbow(SceneBuilder *builder, const Rainbow *rainbow)
{
	builder->rainbows = grow(builder->arena, builder->rainbows, builder->rainbow_count);
	builder->rainbows[builder->rainbow_count++] = rainbow;
}

Scene *scene_freeze(SceneBuilder *builder)
{
	Arena *arena = builder->arena;
	Scene *scene = ARENA_NEW(arena, Scene);
	FlatScene flat = scene_flatten(arena, builder->objects, builder->object_count);
	*scene = (Scene){
		.arena = arena,
		.settings = builder->settings,
		.camera = builder->camera,
		.background = builder->background,
		.shapes = flat.shapes,
		.shape_count = flat.shape_count,
		.hides_from_image = flat.hides_from_image,
		.hides_from_reflection = flat.hides_from_reflection,
		.lights = flat.lights,
		.light_count = flat.light_count,
		.fogs = builder->fogs,
		.fog_count = builder->fog_count,
		.rainbows = builder->rainbows,
		.rainbow_count = builder->rainbow_count,
		.sky_sphere = builder->sky_sphere,
	};
	builder->arena = NULL;
	scene->accel = accel_create(scene->shapes, scene->shape_count);
	if (!scene->accel) {
		diag_fail(builder->diag, "cannot build the accelerator for %d shapes",
			  scene->shape_count);
		scene_destroy(scene);
		return NULL;
	}
	return scene;
}

void scene_destroy(Scene *scene)
{
	if (!scene)
		return;
	accel_destroy(scene->accel);
	arena_destroy(scene->arena); /* the scene itself lives there */
}
