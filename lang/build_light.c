/* light_source { }. */
#include <math.h>
#include <stdlib.h>

#include "lang/build_object.h"
#include "lang/build_photons.h"
#include "lang/build_transform.h"

/* A light being read: everything stands in the space around it, and is moved at each
 * transformation. Angles wait until the kind is known: they are degrees for a spotlight, lengths
 * for a cylinder. */
typedef struct LightReading {
	Light light;
	Object *looks_like, *projected_through;
	double radius, falloff;
	bool has_radius, has_falloff;
} LightReading;

static void move_light(Arena *arena, LightReading *reading, const Transform *transform)
{
	Light *light = &reading->light;
	light->position = transform_point(transform, light->position);
	light->point_at = transform_point(transform, light->point_at);
	light->axis1 = transform_vector(transform, light->axis1);
	light->axis2 = transform_vector(transform, light->axis2);
	if (reading->looks_like)
		object_transform(arena, reading->looks_like, transform);
	if (reading->projected_through)
		object_transform(arena, reading->projected_through, transform);
}

/* The one object of looks_like { } or projected_through { }: a copy that may be moved, or NULL. */
static Object *read_one_object(Cursor *cursor, const Node *block)
{
	ObjectList list = {0};
	Cursor inside = cursor_begin(cursor->context, block);
	build_object_list(&inside, &list);
	cursor_end(&inside);
	if (list.count == 1)
		return arena_copy(cursor->context->builder->arena, list.items[0], sizeof(Object));
	diag_error(cursor->context->diag, block->where, "'%s' needs one object",
		   word_text(block->word));
	return NULL;
}

static void read_looks_like(Cursor *cursor, LightReading *reading, const Node *block)
{
	Transform move = transform_translate(reading->light.position);
	reading->looks_like = read_one_object(cursor, block);
	if (reading->looks_like)
		object_transform(cursor->context->builder->arena, reading->looks_like, &move);
}

static bool read_area(Cursor *cursor, Light *light)
{
	enum { MOST_LIGHTS = 1 << 24 };
	light->area = true;
	if (!cursor_take_vec3(cursor, &light->axis1) || !cursor_take_vec3(cursor, &light->axis2))
		return false;
	Location where = cursor_where(cursor);
	bool whole = cursor_take_int(cursor, &light->size1);
	whole &= cursor_take_int(cursor, &light->size2);
	double lights = (double)light->size1 * light->size2;
	bool good = whole && lights >= 1 && lights <= MOST_LIGHTS;
	if (whole && !good)
		diag_error(cursor->context->diag, where,
			   "an area light is of 1 to %d lights, not %.0f", MOST_LIGHTS, lights);
	light->size1 = good ? abs(light->size1) : 1; /* two negative ones pass in POV-Ray */
	light->size2 = good ? abs(light->size2) : 1;
	return good;
}

/* Words with numbers; false when none of them is next. */
static bool accept_number(Cursor *cursor, LightReading *reading)
{
	Light *light = &reading->light;
	if (cursor_accept_word(cursor, W_radius))
		reading->has_radius |= cursor_take_float(cursor, &reading->radius);
	else if (cursor_accept_word(cursor, W_falloff))
		reading->has_falloff |= cursor_take_float(cursor, &reading->falloff);
	else if (cursor_accept_word(cursor, W_tightness))
		cursor_take_float(cursor, &light->tightness);
	else if (cursor_accept_word(cursor, W_point_at))
		cursor_take_vec3(cursor, &light->point_at);
	else if (cursor_accept_word(cursor, W_fade_distance))
		cursor_take_float(cursor, &light->fade_distance);
	else if (cursor_accept_word(cursor, W_fade_power))
		cursor_take_float(cursor, &light->fade_power);
	else if (cursor_accept_word(cursor, W_area_light))
		read_area(cursor, light);
	else if (cursor_accept_word(cursor, W_adaptive))
		cursor_take_int(cursor, &light->adaptive);
	else
		return false;
	return true;
}

/* Words that turn something on. */
static bool accept_switch(Cursor *cursor, Light *light)
{
	if (cursor_accept_word(cursor, W_spotlight))
		light->kind = LIGHT_SPOT;
	else if (cursor_accept_word(cursor, W_cylinder))
		light->kind = LIGHT_CYLINDER;
	else if (cursor_accept_word(cursor, W_parallel))
		light->parallel = true;
	else if (cursor_accept_word(cursor, W_shadowless))
		light->shadowless = true;
	else if (cursor_accept_word(cursor, W_jitter))
		light->jitter = true;
	else if (cursor_accept_word(cursor, W_circular))
		light->circular = true;
	else if (cursor_accept_word(cursor, W_orient))
		light->orient = true;
	else if (cursor_accept_word(cursor, W_area_illumination))
		light->area_illumination = cursor_optional_bool(cursor);
	else if (cursor_accept_word(cursor, W_media_interaction))
		light->media_interaction = cursor_optional_bool(cursor);
	else if (cursor_accept_word(cursor, W_media_attenuation))
		light->media_attenuation = cursor_optional_bool(cursor);
	else
		return false;
	return true;
}

static bool accept_block(Cursor *cursor, LightReading *reading)
{
	const Node *block;
	if ((block = cursor_accept_block(cursor, W_looks_like)))
		read_looks_like(cursor, reading, block);
	else if ((block = cursor_accept_block(cursor, W_projected_through)))
		reading->projected_through = read_one_object(cursor, block);
	else if ((block = cursor_accept_block(cursor, W_photons)))
		build_photons_light(cursor->context, block, &reading->light);
	else
		return false;
	return true;
}

static bool read_item(Cursor *cursor, LightReading *reading)
{
	Transform transform = transform_identity();
	if (build_accept_transform(cursor, &transform)) {
		move_light(cursor->context->builder->arena, reading, &transform);
		return true;
	}
	return accept_number(cursor, reading) || accept_switch(cursor, &reading->light) ||
	       accept_block(cursor, reading);
}

/* A spotlight's angles become cosines, a cylinder's radii stay lengths; each kind has its defaults
 * (measured on POV-Ray 3.7). A parallel spotlight is a parallel light. */
static void finish_cone(LightReading *reading)
{
	Light *light = &reading->light;
	double degree = acos(-1) / 180;
	double radius = light->kind == LIGHT_CYLINDER ? 0.75 : 30;
	double falloff = light->kind == LIGHT_CYLINDER ? 1 : 45;
	if (reading->has_radius)
		radius = reading->radius;
	if (reading->has_falloff)
		falloff = reading->falloff;
	light->radius = light->kind == LIGHT_CYLINDER ? radius : cos(radius * degree);
	light->falloff = light->kind == LIGHT_CYLINDER ? falloff : cos(falloff * degree);
	if (light->parallel && light->kind == LIGHT_SPOT)
		light->kind = LIGHT_POINT;
}

/* A light without a colour is dark. */
static void take_color(Cursor *cursor, Rgb *color)
{
	if (cursor_peek_numeric(cursor)) {
		cursor_take_rgb(cursor, color);
		return;
	}
	*color = (Rgb){0};
	diag_warning(cursor->context->diag, cursor_where(cursor),
		     "a light without a colour gives no light");
}

bool build_light_source(Cursor *cursor, Object *object)
{
	LightReading reading = {.light = light_default()};
	object->kind = OBJECT_LIGHT;
	if (!cursor_take_vec3(cursor, &reading.light.position))
		return false;
	take_color(cursor, &reading.light.color);
	while (!cursor_at_end(cursor))
		if (!read_item(cursor, &reading))
			cursor_unexpected(cursor);
	finish_cone(&reading);
	if (!(reading.light.size1 > 1 || reading.light.size2 > 1))
		reading.light.area = false;
	if (reading.looks_like) {
		const Object **child = ARENA_NEW(cursor->context->builder->arena, const Object *);
		ObjectList list = {child, 1, 1};
		*child = reading.looks_like;
		build_object_adopt(cursor, object, &list);
	}
	object->projected_through = reading.projected_through;
	object->light = arena_copy(cursor->context->builder->arena, &reading.light,
				   sizeof reading.light);
	return true;
}
