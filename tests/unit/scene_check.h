/* Small scenes put together by hand, for tests of the renderer. */
#ifndef TESTS_UNIT_SCENE_CHECK_H
#define TESTS_UNIT_SCENE_CHECK_H

#include "geom/box.h"
#include "geom/plane.h"
#include "geom/sphere.h"
#include "render/render.h"
#include "scene/scene.h"

static SceneBuilder scene_start(Diag *diag)
{
	SceneBuilder builder = {
		.arena = arena_create(), .diag = diag, .settings = settings_default()};
	builder.camera = camera_default(1);
	builder.camera.location = vec3(0, 0, -5);
	builder.background = rgbft(0, 0, 0, 0, 0);
	builder.settings.adc_bailout = 1e-7;
	builder.settings.max_trace_level = 40;
	return builder;
}

static const Texture *scene_texture(SceneBuilder *builder, Rgbft color, Finish finish)
{
	Pigment *pigment = ARENA_NEW(builder->arena, Pigment);
	pigment->kind = PIGMENT_COLOR;
	pigment->color = color;
	Texture *texture = ARENA_NEW(builder->arena, Texture);
	texture->kind = TEXTURE_PLAIN;
	texture->pigment = pigment;
	texture->finish = arena_copy(builder->arena, &finish, sizeof finish);
	return texture;
}

/* A finish that does nothing by itself. */
static Finish scene_finish(void)
{
	Finish finish = finish_default();
	finish.ambient = finish.emission = rgb_all(0);
	finish.diffuse = 0;
	return finish;
}

static Object *scene_add(SceneBuilder *builder, const ShapeClass *class, const void *data,
			 const Texture *texture)
{
	Object *object = ARENA_NEW(builder->arena, Object);
	*object = object_default(OBJECT_PRIMITIVE);
	object->class = class;
	object->data = data;
	object->texture = texture;
	scene_builder_add_object(builder, object);
	return object;
}

static Object *scene_add_light(SceneBuilder *builder, const Light *light)
{
	Object *object = ARENA_NEW(builder->arena, Object);
	*object = object_default(OBJECT_LIGHT);
	object->light = arena_copy(builder->arena, light, sizeof *light);
	scene_builder_add_object(builder, object);
	return object;
}

static const void *scene_sphere(SceneBuilder *builder, Vec3 center, double radius)
{
	return sphere_create(builder->arena, center, radius);
}

static const void *scene_box(SceneBuilder *builder, Vec3 lo, Vec3 hi)
{
	return box_create(builder->arena, lo, hi);
}

static const void *scene_plane(SceneBuilder *builder, Vec3 normal, double distance)
{
	const char *error = NULL;
	return plane_create(builder->arena, normal, distance, &error);
}

#endif
