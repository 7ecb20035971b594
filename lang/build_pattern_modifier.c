/* The words that may follow a pattern: turbulence, waves, warps, transformations, and the
 * parameters of single patterns. */
#include <string.h>

#include "lang/build_pattern.h"
#include "lang/build_transform.h"
#include "surface/pattern_data.h"
#include "surface/pavement_plan.h"
#include "surface/warp.h"

/* Takes what follows the word, which is taken. */
typedef void ModifierTake(Cursor *cursor, Pattern *pattern);

/* ---- turbulence ---- */

static void put_classic(Cursor *cursor, Pattern *pattern, const Turbulence *turbulence)
{
	warp_set_classic(cursor->context->builder->arena, &pattern->warps, turbulence);
}

static void take_turbulence(Cursor *cursor, Pattern *pattern)
{
	Turbulence t = warp_classic(pattern->warps);
	cursor_take_vec3(cursor, &t.amount);
	put_classic(cursor, pattern, &t);
}

static void take_octaves(Cursor *cursor, Pattern *pattern)
{
	Turbulence t = warp_classic(pattern->warps);
	double octaves = t.octaves;
	cursor_take_float(cursor, &octaves);
	t.octaves = turbulence_octaves(octaves);
	put_classic(cursor, pattern, &t);
}

static void take_omega(Cursor *cursor, Pattern *pattern)
{
	Turbulence t = warp_classic(pattern->warps);
	cursor_take_float(cursor, &t.omega);
	put_classic(cursor, pattern, &t);
}

static void take_lambda(Cursor *cursor, Pattern *pattern)
{
	Turbulence t = warp_classic(pattern->warps);
	cursor_take_float(cursor, &t.lambda);
	put_classic(cursor, pattern, &t);
}

/* ---- from value to map ---- */

static void take_frequency(Cursor *cursor, Pattern *pattern)
{
	cursor_take_float(cursor, &pattern->frequency);
}
static void take_phase(Cursor *cursor, Pattern *pattern)
{
	cursor_take_float(cursor, &pattern->phase);
}

static void take_poly_wave(Cursor *cursor, Pattern *pattern)
{
	pattern->wave = WAVE_POLY;
	pattern->exponent = cursor_optional_float(cursor, 1);
}

static void take_ramp_wave(Cursor *cursor, Pattern *pattern)
{
	(void)cursor;
	pattern->wave = WAVE_RAMP;
}
static void take_triangle_wave(Cursor *cursor, Pattern *pattern)
{
	(void)cursor;
	pattern->wave = WAVE_TRIANGLE;
}
static void take_sine_wave(Cursor *cursor, Pattern *pattern)
{
	(void)cursor;
	pattern->wave = WAVE_SINE;
}
static void take_scallop_wave(Cursor *cursor, Pattern *pattern)
{
	(void)cursor;
	pattern->wave = WAVE_SCALLOP;
}
static void take_cubic_wave(Cursor *cursor, Pattern *pattern)
{
	(void)cursor;
	pattern->wave = WAVE_CUBIC;
}

static void take_noise_generator(Cursor *cursor, Pattern *pattern)
{
	int generator = 0;
	if (!cursor_take_int(cursor, &generator))
		return;
	if (generator >= 1 && generator <= 3)
		pattern->noise_generator = generator;
	else
		diag_error(cursor->context->diag, cursor->last->where,
			   "noise_generator takes 1, 2 or 3");
}

/* ---- parameters of single patterns ---- */

/* Whether the pattern is of the class that the word belongs to; reports when not. */
static bool belongs(Cursor *cursor, const Pattern *pattern, const char *class)
{
	const char *name = pattern->class ? pattern->class->name : "";
	size_t length = strlen(class);
	if (strncmp(name, class, length) == 0)
		return true;
	diag_error(cursor->context->diag, cursor->last->where, "'%s' belongs to the pattern '%s'",
	           word_text(cursor->last->word), class);
	while (cursor_peek_numeric(cursor))
		cursor_next(cursor);
	return false;
}

static void take_agate_turb(Cursor *cursor, Pattern *pattern)
{
	if (!belongs(cursor, pattern, "agate"))
		return;
	AgateData *data = build_pattern_data(cursor->context, pattern, &(AgateData){1},
					     sizeof *data);
	cursor_take_float(cursor, &data->turbulence);
}

static QuiltedData *quilted_data(Cursor *cursor, Pattern *pattern)
{
	if (!belongs(cursor, pattern, "quilted"))
		return NULL;
	return build_pattern_data(cursor->context, pattern, &(QuiltedData){1, 1},
				  sizeof(QuiltedData));
}

static void take_control0(Cursor *cursor, Pattern *pattern)
{
	QuiltedData *data = quilted_data(cursor, pattern);
	if (data)
		cursor_take_float(cursor, &data->control0);
}

static void take_control1(Cursor *cursor, Pattern *pattern)
{
	QuiltedData *data = quilted_data(cursor, pattern);
	if (data)
		cursor_take_float(cursor, &data->control1);
}

static BrickData *brick_data(Cursor *cursor, Pattern *pattern)
{
	if (!belongs(cursor, pattern, "brick"))
		return NULL;
	return build_pattern_data(cursor->context, pattern, &(BrickData){{8, 3, 4.5}, 0.5},
				  sizeof(BrickData));
}

static void take_brick_size(Cursor *cursor, Pattern *pattern)
{
	BrickData *data = brick_data(cursor, pattern);
	if (data)
		cursor_take_vec3(cursor, &data->size);
}

static void take_mortar(Cursor *cursor, Pattern *pattern)
{
	BrickData *data = brick_data(cursor, pattern);
	if (data)
		cursor_take_float(cursor, &data->mortar);
}

/* coords S and size S of facets. */
static void take_facets_size(Cursor *cursor, Pattern *pattern)
{
	if (!belongs(cursor, pattern, "facets"))
		return;
	FacetsData *data = build_pattern_data(cursor->context, pattern, &(FacetsData){0, 0.1},
					      sizeof *data);
	bool coords = cursor->last->word == W_coords;
	cursor_take_float(cursor, coords ? &data->coords : &data->size);
}

static CrackleData *crackle_data(Cursor *cursor, Pattern *pattern)
{
	static const CrackleData initial = {.form = {-1, 1, 0}, .metric = 2};
	return belongs(cursor, pattern, "crackle")
		       ? build_pattern_data(cursor->context, pattern, &initial, sizeof(CrackleData))
		       : NULL;
}

static void take_metric(Cursor *cursor, Pattern *pattern)
{
	CrackleData *data = crackle_data(cursor, pattern);
	if (data)
		cursor_take_float(cursor, &data->metric);
}

static void take_offset(Cursor *cursor, Pattern *pattern)
{
	CrackleData *data = crackle_data(cursor, pattern);
	if (data)
		cursor_take_float(cursor, &data->offset);
}

static void take_solid(Cursor *cursor, Pattern *pattern)
{
	CrackleData *data = crackle_data(cursor, pattern);
	if (data)
		data->solid = cursor_optional_bool(cursor);
}

/* The number that stands behind the word; NULL for a word that is no pavement's. */
static int *pavement_number(PavementData *data, Word word)
{
	switch (word) {
	case W_number_of_sides: return &data->sides;
	case W_number_of_tiles: return &data->tiles;
	case W_pattern: return &data->pattern;
	case W_form: return &data->form;
	case W_exterior: return &data->exterior;
	case W_interior: return &data->interior;
	default: return NULL;
	}
}

/* What stands together is judged together: the words come in any order. */
static void take_pavement(Cursor *cursor, Pattern *pattern)
{
	if (!belongs(cursor, pattern, "pavement"))
		return;
	PavementData *data = build_pattern_data(cursor->context, pattern, pattern->data,
						sizeof *data);
	int *number = pavement_number(data, cursor->last->word);
	while (number) {
		cursor_take_int(cursor, number);
		number = pavement_number(data, cursor_peek_word(cursor));
		if (number)
			cursor_next(cursor);
	}
	const PavementPlan *plan = pavement_plan_find(data->sides, data->tiles, data->pattern);
	int count = pavement_plan_count(data->sides, data->tiles);
	if (plan)
		data->plan = plan;
	else if (count > 0)
		diag_error(cursor->context->diag, cursor->last->where,
			   "tiles of %d polygons with %d sides have the patterns 1 to %d",
			   data->tiles, data->sides, count);
	else
		diag_error(cursor->context->diag, cursor->last->where,
			   "pavement has tiles of 1 to 6 polygons with 3 or 4 sides, or of 1 to 5 "
			   "with 6 sides");
}

static bool is_class(const Pattern *pattern, const char *name)
{
	return pattern->class && strcmp(pattern->class->name, name) == 0;
}

/* A vector for crackle, a number for pavement. */
static void take_form(Cursor *cursor, Pattern *pattern)
{
	if (is_class(pattern, "pavement")) {
		take_pavement(cursor, pattern);
		return;
	}
	CrackleData *data = crackle_data(cursor, pattern);
	if (data)
		cursor_take_vec3(cursor, &data->form);
}

/* The fractals' own numbers; NULL and a report for other patterns. */
static FractalData *fractal_data(Cursor *cursor, Pattern *pattern)
{
	const char *const names[] = {"mandel", "julia", "magnet"};
	const char *name = pattern->class ? pattern->class->name : "";
	for (int i = 0; i < 3; i++)
		if (strncmp(name, names[i], strlen(names[i])) == 0)
			return build_pattern_data(cursor->context, pattern, pattern->data,
						  sizeof(FractalData));
	belongs(cursor, pattern, "mandel");
	return NULL;
}

static void take_exponent(Cursor *cursor, Pattern *pattern)
{
	FractalData *data = fractal_data(cursor, pattern);
	if (!data || !cursor_take_int(cursor, &data->exponent))
		return;
	if (data->exponent < 2 || data->exponent > 33) {
		diag_error(cursor->context->diag, cursor->last->where,
			   "an exponent is from 2 to 33");
		data->exponent = 2;
	}
}

/* exterior TYPE, FACTOR and interior TYPE, FACTOR of fractals; exterior N and interior N of
 * pavements. */
static void take_coloring(Cursor *cursor, Pattern *pattern)
{
	bool exterior = cursor->last->word == W_exterior;
	if (is_class(pattern, "pavement")) {
		take_pavement(cursor, pattern);
		return;
	}
	FractalData *data = fractal_data(cursor, pattern);
	if (data && cursor_take_int(cursor, exterior ? &data->exterior : &data->interior))
		cursor_take_float(cursor,
				  exterior ? &data->exterior_factor : &data->interior_factor);
}

static void take_interpolate(Cursor *cursor, Pattern *pattern)
{
	if (!belongs(cursor, pattern, "density_file"))
		return;
	DensityData *data = build_pattern_data(cursor->context, pattern, pattern->data,
					       sizeof *data);
	cursor_take_int(cursor, &data->interpolate);
}

typedef struct ModifierRow {
	Word word;
	ModifierTake *take;
} ModifierRow;

static const ModifierRow MODIFIERS[] = {
	{W_turbulence, take_turbulence},
	{W_octaves, take_octaves},
	{W_omega, take_omega},
	{W_lambda, take_lambda},
	{W_frequency, take_frequency},
	{W_phase, take_phase},
	{W_ramp_wave, take_ramp_wave},
	{W_triangle_wave, take_triangle_wave},
	{W_sine_wave, take_sine_wave},
	{W_scallop_wave, take_scallop_wave},
	{W_cubic_wave, take_cubic_wave},
	{W_poly_wave, take_poly_wave},
	{W_noise_generator, take_noise_generator},
	{W_agate_turb, take_agate_turb},
	{W_control0, take_control0},
	{W_control1, take_control1},
	{W_brick_size, take_brick_size},
	{W_mortar, take_mortar},
	{W_coords, take_facets_size},
	{W_size, take_facets_size},
	{W_form, take_form},
	{W_metric, take_metric},
	{W_offset, take_offset},
	{W_solid, take_solid},
	{W_exponent, take_exponent},
	{W_exterior, take_coloring},
	{W_interior, take_coloring},
	{W_interpolate, take_interpolate},
	{W_number_of_sides, take_pavement},
	{W_number_of_tiles, take_pavement},
	{W_pattern, take_pavement},
};

static const ModifierRow *find_row(Word word)
{
	for (size_t i = 0; i < sizeof MODIFIERS / sizeof MODIFIERS[0]; i++)
		if (MODIFIERS[i].word == word)
			return &MODIFIERS[i];
	return NULL;
}

bool build_accept_pattern_modifier(Cursor *cursor, Pattern *pattern)
{
	Transform transform = transform_identity();
	if (build_accept_transform(cursor, &transform)) {
		build_pattern_transform(cursor->context, pattern, &transform);
		return true;
	}
	const Node *block = cursor_accept_block(cursor, W_warp);
	if (block) {
		build_warp(cursor->context, block, pattern);
		return true;
	}
	if (cursor_peek_block(cursor))
		return false;
	const ModifierRow *row = find_row(cursor_peek_word(cursor));
	if (!row)
		return false;
	cursor_next(cursor);
	row->take(cursor, pattern);
	return true;
}
