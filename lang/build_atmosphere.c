#include "lang/build_atmosphere.h"

#include "lang/build_map.h"
#include "lang/build_texture.h"
#include "lang/build_transform.h"
#include "lang/cursor.h"
#include "surface/pattern_data.h"

void build_background(Context *context, const Node *block)
{
	Cursor cursor = cursor_begin(context, block);
	Rgbft color = {0, 0, 0, 0, 0};
	if (cursor_take_color(&cursor, &color)) {
		context->builder->background = color;
		context->builder->has_background = true;
	}
	cursor_end(&cursor);
}

/* ---- fog ---- */

static Fog fog_default(void)
{
	return (Fog){
		.kind = FOG_CONSTANT,
		.up = {0, 1, 0},
		.turbulence = turbulence_default(),
		.turb_depth = 0.5,
	};
}

static void read_fog_type(Cursor *cursor, Fog *fog)
{
	int type = FOG_CONSTANT;
	if (!cursor_take_int(cursor, &type))
		return;
	if (type == FOG_CONSTANT || type == FOG_GROUND)
		fog->kind = (FogKind)type;
	else
		diag_error(cursor->context->diag, cursor->last->where, "fog_type must be 1 or 2");
}

static void take_octaves(Cursor *cursor, Turbulence *turbulence)
{
	double octaves;
	if (cursor_take_float(cursor, &octaves))
		turbulence->octaves = turbulence_octaves(octaves);
}

static bool accept_fog_number(Cursor *cursor, Fog *fog)
{
	if (cursor_accept_word(cursor, W_distance))
		cursor_take_float(cursor, &fog->distance);
	else if (cursor_accept_word(cursor, W_fog_type))
		read_fog_type(cursor, fog);
	else if (cursor_accept_word(cursor, W_fog_offset))
		cursor_take_float(cursor, &fog->offset);
	else if (cursor_accept_word(cursor, W_fog_alt))
		cursor_take_float(cursor, &fog->alt);
	else if (cursor_accept_word(cursor, W_up))
		cursor_take_vec3(cursor, &fog->up);
	else if (cursor_accept_word(cursor, W_turbulence))
		cursor_take_vec3(cursor, &fog->turbulence.amount);
	else if (cursor_accept_word(cursor, W_turb_depth))
		cursor_take_float(cursor, &fog->turb_depth);
	else if (cursor_accept_word(cursor, W_octaves))
		take_octaves(cursor, &fog->turbulence);
	else if (cursor_accept_word(cursor, W_omega))
		cursor_take_float(cursor, &fog->turbulence.omega);
	else if (cursor_accept_word(cursor, W_lambda))
		cursor_take_float(cursor, &fog->turbulence.lambda);
	else if (cursor_peek_numeric(cursor))
		cursor_take_color(cursor, &fog->color);
	else
		return false;
	return true;
}

const Fog *build_fog(Context *context, const Node *block)
{
	Fog fog = fog_default();
	Cursor cursor = cursor_begin(context, block);
	const Fog *named = cursor_accept_item(&cursor, VALUE_FOG);
	if (named)
		fog = *named;
	while (!cursor_at_end(&cursor)) {
		Transform transform = transform_identity();
		if (build_accept_transform(&cursor, &transform))
			fog.up = transform_vector(&transform, fog.up);
		else if (!accept_fog_number(&cursor, &fog))
			cursor_unexpected(&cursor);
	}
	fog.up = vec3_normalize(fog.up);
	return arena_copy(context->builder->arena, &fog, sizeof fog);
}

/* ---- rainbow ---- */

/* A pigment whose colours run along x, as the rainbow looks them up. */
static const Pigment *gradient_pigment(Context *context, const ColorMap *map)
{
	Pigment *pigment = ARENA_NEW(context->builder->arena, Pigment);
	GradientData *along_x = ARENA_NEW(context->builder->arena, GradientData);
	along_x->direction = vec3(1, 0, 0);
	pigment->kind = PIGMENT_COLOR_MAP;
	pigment->pattern.class = pattern_find("gradient");
	pigment->pattern.data = along_x;
	pigment->pattern.frequency = 1;
	pigment->colors = map->entries;
	pigment->color_count = map->count;
	return pigment;
}

static bool accept_color_map(Cursor *cursor, const ColorMap **map)
{
	const Node *block = cursor_accept_block(cursor, W_color_map);
	if (!block)
		block = cursor_accept_block(cursor, W_colour_map);
	if (block)
		*map = build_color_map(cursor->context, block);
	return block;
}

static bool accept_rainbow_number(Cursor *cursor, Rainbow *rainbow)
{
	if (cursor_accept_word(cursor, W_direction))
		cursor_take_vec3(cursor, &rainbow->direction);
	else if (cursor_accept_word(cursor, W_up))
		cursor_take_vec3(cursor, &rainbow->up);
	else if (cursor_accept_word(cursor, W_angle))
		cursor_take_float(cursor, &rainbow->angle);
	else if (cursor_accept_word(cursor, W_width))
		cursor_take_float(cursor, &rainbow->width);
	else if (cursor_accept_word(cursor, W_distance))
		cursor_take_float(cursor, &rainbow->distance);
	else if (cursor_accept_word(cursor, W_jitter))
		cursor_take_float(cursor, &rainbow->jitter);
	else if (cursor_accept_word(cursor, W_arc_angle))
		cursor_take_float(cursor, &rainbow->arc_angle);
	else if (cursor_accept_word(cursor, W_falloff_angle))
		cursor_take_float(cursor, &rainbow->falloff_angle);
	else
		return false;
	return true;
}

const Rainbow *build_rainbow(Context *context, const Node *block)
{
	Rainbow rainbow = {
		.up = {0, 1, 0}, .distance = 1e7, .arc_angle = 360, .falloff_angle = 360};
	const ColorMap *map = NULL;
	Cursor cursor = cursor_begin(context, block);
	const Rainbow *named = cursor_accept_item(&cursor, VALUE_RAINBOW);
	if (named)
		rainbow = *named;
	while (!cursor_at_end(&cursor))
		if (!accept_rainbow_number(&cursor, &rainbow) && !accept_color_map(&cursor, &map))
			cursor_unexpected(&cursor);
	if (map)
		rainbow.pigment = gradient_pigment(context, map);
	rainbow.antisolar = vec3_normalize(rainbow.direction);
	if (vec3_length2(rainbow.direction) == 0 || !rainbow.pigment || rainbow.width == 0)
		diag_error(context->diag, block->where,
			   "a rainbow needs a direction, a width and a color_map");
	return arena_copy(context->builder->arena, &rainbow, sizeof rainbow);
}

/* ---- sky_sphere ---- */

/* One more pigment on top. */
static void add_sky_pigment(Context *context, SkySphere *sky, const Pigment *pigment)
{
	const Pigment **all = ARENA_ARRAY(context->builder->arena, const Pigment *, sky->count + 1);
	for (int i = 0; i < sky->count; i++)
		all[i] = sky->pigments[i];
	all[sky->count++] = pigment;
	sky->pigments = all;
}

const SkySphere *build_sky_sphere(Context *context, const Node *block)
{
	SkySphere sky = {.transform = transform_identity(), .emission = {1, 1, 1}};
	Cursor cursor = cursor_begin(context, block);
	const SkySphere *named = cursor_accept_item(&cursor, VALUE_SKY_SPHERE);
	if (named)
		sky = *named;
	while (!cursor_at_end(&cursor)) {
		const Node *inner = cursor_accept_block(&cursor, W_pigment);
		if (inner)
			add_sky_pigment(context, &sky,
					build_pigment(context, inner, context->defaults.pigment));
		else if (cursor_accept_word(&cursor, W_emission))
			cursor_take_rgb(&cursor, &sky.emission);
		else if (!build_accept_transform(&cursor, &sky.transform))
			cursor_unexpected(&cursor);
	}
	return arena_copy(context->builder->arena, &sky, sizeof sky);
}
