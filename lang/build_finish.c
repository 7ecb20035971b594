/* finish { ... } */
#include <math.h>

#include "lang/build_media.h"
#include "lang/build_pattern.h"
#include "lang/build_texture.h"

/* Takes what follows the word, which is taken. */
typedef void FinishTake(Cursor *cursor, Finish *finish);

static void take_number(Cursor *cursor, float *out)
{
	double number = *out;
	if (cursor_take_float(cursor, &number))
		*out = (float)number;
}

static void take_amount(Cursor *cursor, bool *albedo, float *out)
{
	*albedo = cursor_accept_word(cursor, W_albedo);
	take_number(cursor, out);
}

static void take_ambient(Cursor *cursor, Finish *finish)
{
	cursor_take_rgb(cursor, &finish->ambient);
}
static void take_emission(Cursor *cursor, Finish *finish)
{
	cursor_take_rgb(cursor, &finish->emission);
}
static void take_brilliance(Cursor *cursor, Finish *finish)
{
	take_number(cursor, &finish->brilliance);
}
static void take_phong_size(Cursor *cursor, Finish *finish)
{
	take_number(cursor, &finish->phong_size);
}
static void take_crand(Cursor *cursor, Finish *finish) { take_number(cursor, &finish->crand); }

/* diffuse [albedo] FRONT [, BACK] */
static void take_diffuse(Cursor *cursor, Finish *finish)
{
	take_amount(cursor, &finish->diffuse_albedo, &finish->diffuse);
	finish->diffuse_back = (float)cursor_optional_float(cursor, finish->diffuse_back);
}

static void take_phong(Cursor *cursor, Finish *finish)
{
	take_amount(cursor, &finish->phong_albedo, &finish->phong);
}

static void take_specular(Cursor *cursor, Finish *finish)
{
	take_amount(cursor, &finish->specular_albedo, &finish->specular);
}

static void take_roughness(Cursor *cursor, Finish *finish)
{
	take_number(cursor, &finish->roughness);
	if (finish->roughness != 0)
		return;
	diag_error(cursor->context->diag, cursor->last->where, "roughness cannot be 0");
	finish->roughness = finish_default().roughness;
}

static void take_metallic(Cursor *cursor, Finish *finish)
{
	finish->metallic = (float)cursor_optional_float(cursor, 1);
}

static void take_conserve_energy(Cursor *cursor, Finish *finish)
{
	finish->conserve_energy = cursor_optional_bool(cursor);
}

static void take_reflection_exponent(Cursor *cursor, Finish *finish)
{
	take_number(cursor, &finish->reflection.exponent);
}

/* ---- blocks ---- */

/* { [MIN,] MAX [fresnel] [falloff F] [exponent E] [metallic M] } */
static void build_reflection(Context *context, const Node *block, Finish *finish)
{
	Cursor cursor = cursor_begin(context, block);
	finish->reflection.falloff = 1;
	finish->reflection.metallic = 0;
	cursor_take_rgb(&cursor, &finish->reflection.max);
	finish->reflection.min = finish->reflection.max;
	bool single = !cursor_peek_numeric(&cursor);
	if (!single)
		cursor_take_rgb(&cursor, &finish->reflection.max);
	while (!cursor_at_end(&cursor)) {
		if (cursor_accept_word(&cursor, W_fresnel))
			finish->reflection.fresnel = cursor_optional_bool(&cursor);
		else if (cursor_accept_word(&cursor, W_falloff))
			take_number(&cursor, &finish->reflection.falloff);
		else if (cursor_accept_word(&cursor, W_exponent))
			take_number(&cursor, &finish->reflection.exponent);
		else if (cursor_accept_word(&cursor, W_metallic))
			finish->reflection.metallic = (float)cursor_optional_float(&cursor, 1);
		else
			cursor_unexpected(&cursor);
	}
	if (single && finish->reflection.fresnel)
		finish->reflection.min = rgb_all(0);
}

/* irid { AMOUNT [thickness T] [turbulence T] } */
static void build_irid(Context *context, const Node *block, Finish *finish)
{
	Cursor cursor = cursor_begin(context, block);
	take_number(&cursor, &finish->irid.amount);
	while (!cursor_at_end(&cursor)) {
		if (cursor_accept_word(&cursor, W_thickness))
			take_number(&cursor, &finish->irid.thickness);
		else if (cursor_accept_word(&cursor, W_turbulence))
			take_number(&cursor, &finish->irid.turbulence);
		else
			cursor_unexpected(&cursor);
	}
}

static void build_subsurface(Context *context, const Node *block, Finish *finish)
{
	Cursor cursor = cursor_begin(context, block);
	finish->use_subsurface = true;
	while (!cursor_at_end(&cursor)) {
		if (cursor_accept_word(&cursor, W_translucency))
			cursor_take_rgb(&cursor, &finish->subsurface_translucency);
		else
			cursor_unexpected(&cursor);
	}
}

static bool build_block(Context *context, const Node *block, Finish *finish)
{
	switch (block->word) {
	case W_reflection: build_reflection(context, block, finish); return true;
	case W_irid: build_irid(context, block, finish); return true;
	case W_subsurface: build_subsurface(context, block, finish); return true;
	default: return false;
	}
}

/* The old form: one colour for all angles. */
static void take_reflection(Cursor *cursor, Finish *finish)
{
	if (cursor_take_rgb(cursor, &finish->reflection.max))
		finish->reflection.min = finish->reflection.max;
}

/* ---- words that moved to the interior ---- */

static Interior *own_interior(Cursor *cursor, Finish *finish)
{
	Context *context = cursor->context;
	Interior *interior = ARENA_NEW(context->builder->arena, Interior);
	*interior = finish->interior ? *finish->interior : interior_default();
	finish->interior = interior;
	if (!build_version_before(context, 3.1))
		diag_warning(context->diag, cursor->last->where, "'%s' belongs into an interior",
		             word_text(cursor->last->word));
	return interior;
}

static void take_ior(Cursor *cursor, Finish *finish)
{
	take_number(cursor, &own_interior(cursor, finish)->ior);
}
static void take_caustics(Cursor *cursor, Finish *finish)
{
	take_number(cursor, &own_interior(cursor, finish)->caustics);
}

static void take_fade_distance(Cursor *cursor, Finish *finish)
{
	take_number(cursor, &own_interior(cursor, finish)->fade_distance);
}

static void take_fade_power(Cursor *cursor, Finish *finish)
{
	take_number(cursor, &own_interior(cursor, finish)->fade_power);
}

/* Filter and transmit alone say how much light passes. */
static void take_refraction(Cursor *cursor, Finish *finish)
{
	own_interior(cursor, finish);
	cursor_optional_float(cursor, 1);
}

typedef struct FinishRow {
	Word word;
	FinishTake *take;
} FinishRow;

static const FinishRow FINISH_WORDS[] = {
	{W_ambient, take_ambient},
	{W_emission, take_emission},
	{W_diffuse, take_diffuse},
	{W_brilliance, take_brilliance},
	{W_phong, take_phong},
	{W_phong_size, take_phong_size},
	{W_specular, take_specular},
	{W_roughness, take_roughness},
	{W_metallic, take_metallic},
	{W_crand, take_crand},
	{W_conserve_energy, take_conserve_energy},
	{W_reflection, take_reflection},
	{W_reflection_exponent, take_reflection_exponent},
	{W_ior, take_ior},
	{W_refraction, take_refraction},
	{W_caustics, take_caustics},
	{W_fade_distance, take_fade_distance},
	{W_fade_power, take_fade_power},
};

static bool take_item(Cursor *cursor, Finish *finish)
{
	if (cursor_peek_block(cursor)) {
		if (!build_block(cursor->context, cursor->at, finish))
			return false;
		cursor_next(cursor);
		return true;
	}
	Word word = cursor_peek_word(cursor);
	for (size_t i = 0; i < sizeof FINISH_WORDS / sizeof FINISH_WORDS[0]; i++) {
		if (FINISH_WORDS[i].word != word)
			continue;
		cursor_next(cursor);
		FINISH_WORDS[i].take(cursor, finish);
		return true;
	}
	return false;
}

const Finish *build_finish(Context *context, const Node *block, const Finish *base)
{
	Cursor cursor = cursor_begin(context, block);
	const Finish *named = cursor_accept_item(&cursor, VALUE_FINISH);
	if (named && cursor_at_end(&cursor))
		return named;
	Finish *finish = ARENA_NEW(context->builder->arena, Finish);
	*finish = named ? *named : base ? *base : *context->defaults.finish;
	while (!cursor_at_end(&cursor))
		if (cursor_peek_word(&cursor) == W_NONE || !take_item(&cursor, finish))
			cursor_unexpected(&cursor);
	return finish;
}
