/* Which patterns there are and what stands behind their names. */
#include "lang/build_pattern.h"

#include <stdio.h>

#include "lang/build.h"
#include "lang/build_image.h"
#include "lang/build_texture.h"
#include "scene/flatten.h"
#include "scene/object.h"
#include "surface/pattern_data.h"
#include "surface/pavement_plan.h"
#include "surface/warp.h"

bool build_version_before(const Context *context, double version)
{
	return (context->version > 0 ? context->version : 3.62) < version - 1e-6;
}

Pattern build_pattern_none(void)
{
	return (Pattern){.frequency = 1, .exponent = 1};
}

/* Scenes of versions before 3.5 that say nothing have the noise of their time. */
static int scene_noise(const Context *context)
{
	int generator = context->builder->settings.noise_generator;
	bool unsaid = generator == settings_default().noise_generator;
	return unsaid && build_version_before(context, 3.5) ? 1 : generator;
}

void *build_pattern_data(Context *context, Pattern *pattern, const void *defaults, size_t size)
{
	void *data = arena_copy(context->builder->arena, pattern->data ? pattern->data : defaults,
				size);
	pattern->data = data;
	return data;
}

void build_pattern_transform(Context *context, Pattern *pattern, const Transform *transform)
{
	warp_add_transform(context->builder->arena, &pattern->warps, transform);
}

/* ---- parameters behind the name ---- */

static void *new_data(Cursor *cursor, Pattern *pattern, size_t size)
{
	void *data = arena_alloc(cursor->context->builder->arena, size);
	pattern->data = data;
	return data;
}

static void take_gradient(Cursor *cursor, Pattern *pattern)
{
	GradientData *data = new_data(cursor, pattern, sizeof *data);
	data->direction = vec3(1, 0, 0);
	cursor_take_vec3(cursor, &data->direction);
}

static void take_spiral(Cursor *cursor, Pattern *pattern)
{
	SpiralData *data = new_data(cursor, pattern, sizeof *data);
	data->arms = 1;
	cursor_take_int(cursor, &data->arms);
}

static void take_tiling(Cursor *cursor, Pattern *pattern)
{
	TilingData *data = new_data(cursor, pattern, sizeof *data);
	int kind = 1;
	cursor_take_int(cursor, &kind);
	if (kind < 1 || kind > 27)
		diag_error(cursor->context->diag, cursor->last->where,
			   "tiling takes a number from 1 to 27");
	else if (kind > TILING_KINDS)
		diag_error(cursor->context->diag, cursor->last->where,
			   "the tilings beyond %d, which never repeat, are not supported",
			   TILING_KINDS);
	else
		data->tiling = tiling_create(cursor->context->builder->arena, kind);
	if (!data->tiling)
		pattern->class = NULL;
}

static void take_pavement(Cursor *cursor, Pattern *pattern)
{
	PavementData *data = new_data(cursor, pattern, sizeof *data);
	*data = (PavementData){.sides = 3, .tiles = 1, .pattern = 1};
	data->plan = pavement_plan_find(data->sides, data->tiles, data->pattern);
}

static FractalData *new_fractal(Cursor *cursor, Pattern *pattern)
{
	FractalData *data = new_data(cursor, pattern, sizeof *data);
	*data = (FractalData){.iterations = 1,
			      .exponent = 2,
			      .exterior = 1,
			      .exterior_factor = 1,
			      .interior_factor = 1};
	return data;
}

static void take_iterations(Cursor *cursor, FractalData *data)
{
	if (cursor_take_int(cursor, &data->iterations) && data->iterations < 1) {
		diag_error(cursor->context->diag, cursor->last->where,
			   "at least one iteration is needed");
		data->iterations = 1;
	}
}

static void take_mandel(Cursor *cursor, Pattern *pattern)
{
	take_iterations(cursor, new_fractal(cursor, pattern));
}

static void take_julia(Cursor *cursor, Pattern *pattern)
{
	FractalData *data = new_fractal(cursor, pattern);
	Vec2 c = {0, 0};
	if (cursor_take_vec2(cursor, &c)) {
		data->real = c.u;
		data->imaginary = c.v;
		take_iterations(cursor, data);
	}
}

/* magnet 1 mandel N, magnet 2 julia <c>, N */
static void take_magnet(Cursor *cursor, Pattern *pattern)
{
	int type = 1;
	char name[16];
	if (!cursor_take_int(cursor, &type))
		return;
	if (type != 1 && type != 2) {
		diag_error(cursor->context->diag, cursor->last->where, "magnet takes 1 or 2");
		type = 1;
	}
	bool julia = cursor_peek_word(cursor) == W_julia;
	if (!cursor_accept_word(cursor, W_julia) && !cursor_accept_word(cursor, W_mandel)) {
		cursor_expected(cursor, "'mandel' or 'julia'");
		return;
	}
	snprintf(name, sizeof name, "magnet%d%c", type, julia ? 'j' : 'm');
	pattern->class = pattern_find(name);
	(julia ? take_julia : take_mandel)(cursor, pattern);
}

/* The grammar has made a function of `function { ... }`, with or without the block round it. */
static const Function *take_function(Cursor *cursor)
{
	const Node *block = cursor_accept_block(cursor, W_function);
	if (!block) {
		cursor_accept_word(cursor, W_function);
		return cursor_take_item(cursor, VALUE_FUNCTION, "a function");
	}
	Cursor inside = cursor_begin(cursor->context, block);
	const Function *function = cursor_take_item(&inside, VALUE_FUNCTION, "a function");
	cursor_end(&inside);
	return function;
}

static void take_function_pattern(Cursor *cursor, Pattern *pattern)
{
	FunctionData *data = new_data(cursor, pattern, sizeof *data);
	data->function = take_function(cursor);
	if (!data->function)
		pattern->class = NULL;
	else if (function_arity(data->function) != 3) {
		diag_error(cursor->context->diag, cursor_where(cursor),
			   "a function for a pattern takes x, y and z");
		pattern->class = NULL;
	}
}

static void take_pigment_pattern(Cursor *cursor, Pattern *pattern)
{
	PigmentData *data = new_data(cursor, pattern, sizeof *data);
	data->pigment = build_pigment(cursor->context, cursor_next(cursor),
				      cursor->context->defaults.pigment);
}

static void take_image_pattern(Cursor *cursor, Pattern *pattern)
{
	ImageData *data = new_data(cursor, pattern, sizeof *data);
	double bump_size = 0;
	Cursor inside = cursor_begin(cursor->context, cursor_next(cursor));
	data->image = build_image(&inside, W_image_pattern, &bump_size);
	cursor_end(&inside);
	if (!data->image)
		pattern->class = NULL;
}

static bool inside_shape(const void *shape, Vec3 p) { return shape_inside(shape, p); }

/* One node: a name or an object's block. */
static const Object *inner_object(Cursor *cursor, const Node *block)
{
	Node *first = block->children;
	if (!first) {
		Cursor inside = cursor_begin(cursor->context, block);
		cursor_expected(&inside, "an object");
		return NULL;
	}
	if (first->kind == NODE_ITEM && first->value.kind == VALUE_OBJECT)
		return first->value.item;
	Node alone = *first;
	alone.next = NULL;
	Value value = build_value(cursor->context, &alone);
	if (value.kind == VALUE_OBJECT)
		return value.item;
	if (value.kind != VALUE_NONE)
		diag_error(cursor->context->diag, first->where, "expected an object, found %s",
			   value_describe(value));
	return NULL;
}

/* object { Name A, B }: the object, then what outside and inside look like, which the caller takes.
 */
static void take_object_pattern(Cursor *cursor, Pattern *pattern)
{
	Context *context = cursor->context;
	const Node *block = cursor_accept_block(cursor, W_object);
	const Object *object = NULL;
	if (block)
		object = inner_object(cursor, block);
	else
		cursor_unexpected(cursor);
	if (!object) {
		pattern->class = NULL;
		return;
	}
	ObjectData *data = new_data(cursor, pattern, sizeof *data);
	data->inside = inside_shape;
	data->shape = object_shape(context->builder->arena, object);
}

bool build_pattern_inner_list(const Cursor *cursor, Cursor *list)
{
	const Node *last = cursor->last;
	if (!last || last->kind != NODE_BLOCK || last->word != W_object || !last->children)
		return false;
	*list = cursor_begin(cursor->context, last);
	list->at = last->children->next;
	return true;
}

/* A first number without a second one has 0 for that. */
static void take_slope_range(Cursor *cursor, double *lo, double *hi)
{
	if (!cursor_accept_float(cursor, lo))
		return;
	*hi = 0;
	cursor_accept_float(cursor, hi);
}

/* slope { <direction> lo hi altitude <direction> lo hi }, slope { point_at <point> lo hi }, slope
 * <direction> */
static void take_slope(Cursor *cursor, Pattern *pattern)
{
	SlopeData *data = new_data(cursor, pattern, sizeof *data);
	*data = (SlopeData){.direction = {0, 1, 0}, .hi_slope = 1, .hi_alt = 1};
	const Node *block = cursor_next(cursor);
	bool braces = block->kind == NODE_BLOCK;
	Cursor inside = braces ? cursor_begin(cursor->context, block) : *cursor;
	data->point_at = cursor_accept_word(&inside, W_point_at);
	if (cursor_take_vec3(&inside, &data->direction))
		take_slope_range(&inside, &data->lo_slope, &data->hi_slope);
	if (!data->point_at && cursor_accept_word(&inside, W_altitude) &&
	    cursor_take_vec3(&inside, &data->altitude))
		take_slope_range(&inside, &data->lo_alt, &data->hi_alt);
	if (braces)
		cursor_end(&inside);
	else
		*cursor = inside;
}

static void take_density_file(Cursor *cursor, Pattern *pattern)
{
	cursor_next(cursor);
	if (!cursor_accept_word(cursor, W_df3)) {
		cursor_expected(cursor, "'df3'");
		pattern->class = NULL;
		return;
	}
	pattern->data = build_density_file(cursor);
	if (!pattern->data)
		pattern->class = NULL;
}

static void take_facets(Cursor *cursor, Pattern *pattern)
{
	FacetsData *data = new_data(cursor, pattern, sizeof *data);
	*data = (FacetsData){.coords = 0, .size = 0.1};
}

/* Waves spread from as many sources as global_settings says. */
static void take_waves(Cursor *cursor, Pattern *pattern)
{
	const SceneBuilder *builder = cursor->context->builder;
	if (builder->settings.number_of_waves > 0)
		pattern->data = wave_sources_create(builder->arena,
						    builder->settings.number_of_waves);
}

/* Takes the parameters behind the word, which is taken already unless own_word. */
typedef void PatternParameters(Cursor *cursor, Pattern *pattern);

typedef struct PatternRow {
	Word word;
	PatternParameters *parameters; /* NULL: none */
	bool own_word; /* the parameters begin with the word itself: it may have braces */
} PatternRow;

/* The class is the one of the word's name. */
static const PatternRow PATTERNS[] = {
	{W_agate, NULL, false},
	{W_aoi, NULL, false},
	{W_boxed, NULL, false},
	{W_bozo, NULL, false},
	{W_brick, NULL, false},
	{W_bumps, NULL, false},
	{W_cells, NULL, false},
	{W_checker, NULL, false},
	{W_crackle, NULL, false},
	{W_cubic, NULL, false},
	{W_cylindrical, NULL, false},
	{W_density_file, take_density_file, true},
	{W_dents, NULL, false},
	{W_facets, take_facets, false},
	{W_function, take_function_pattern, true},
	{W_gradient, take_gradient, false},
	{W_granite, NULL, false},
	{W_hexagon, NULL, false},
	{W_image_pattern, take_image_pattern, true},
	{W_julia, take_julia, false},
	{W_leopard, NULL, false},
	{W_magnet, take_magnet, false},
	{W_mandel, take_mandel, false},
	{W_marble, NULL, false},
	{W_object, take_object_pattern, true},
	{W_onion, NULL, false},
	{W_pavement, take_pavement, false},
	{W_pigment_pattern, take_pigment_pattern, true},
	{W_planar, NULL, false},
	{W_quilted, NULL, false},
	{W_radial, NULL, false},
	{W_ripples, take_waves, false},
	{W_slope, take_slope, true},
	{W_spherical, NULL, false},
	{W_spiral1, take_spiral, false},
	{W_spiral2, take_spiral, false},
	{W_spotted, NULL, false},
	{W_square, NULL, false},
	{W_tiling, take_tiling, false},
	{W_triangular, NULL, false},
	{W_waves, take_waves, false},
	{W_wood, NULL, false},
	{W_wrinkles, NULL, false},
};

static const PatternRow *find_row(Word word)
{
	for (size_t i = 0; i < sizeof PATTERNS / sizeof PATTERNS[0]; i++)
		if (PATTERNS[i].word == word)
			return &PATTERNS[i];
	return NULL;
}

/* A function may stand without the word: an identifier, or what the grammar made of function { }.
 */
static const PatternRow *peek_row(const Cursor *cursor)
{
	Word word = cursor_peek_item(cursor, VALUE_FUNCTION) ? W_function
							     : cursor_peek_word(cursor);
	return word == W_NONE ? NULL : find_row(word);
}

static const PatternClass *find_class(Context *context, Word word, Location where)
{
	const PatternClass *class = pattern_find(word == W_magnet ? "magnet1m" : word_text(word));
	if (!class)
		diag_error(context->diag, where, "the pattern '%s' is not supported",
			   word_text(word));
	return class;
}

/* Only the class changes and what it insists on: an identifier's waves and warps stay. */
static void become(const Context *context, Pattern *pattern, const PatternClass *class)
{
	Pattern old = *pattern;
	pattern_init(pattern, class);
	pattern->warps = old.warps;
	pattern->noise_generator = old.noise_generator ? old.noise_generator : scene_noise(context);
	pattern->phase = old.phase;
	pattern->exponent = old.exponent;
	if (pattern->frequency != 0)
		pattern->frequency = old.frequency;
	if (!(class->flags & PATTERN_TRIANGLE))
		pattern->wave = old.wave;
}

bool build_accept_pattern(Cursor *cursor, Pattern *pattern)
{
	const PatternRow *row = peek_row(cursor);
	if (!row)
		return false;
	const PatternClass *class = find_class(cursor->context, row->word, cursor_where(cursor));
	if (!class) {
		cursor_next(cursor);
		return true;
	}
	become(cursor->context, pattern, class);
	if (!row->own_word)
		cursor_next(cursor);
	if (row->parameters)
		row->parameters(cursor, pattern);
	return true;
}

const Pattern *build_pattern_block(Context *context, const Node *block)
{
	Cursor cursor = cursor_begin(context, block);
	Pattern *pattern = ARENA_NEW(context->builder->arena, Pattern);
	*pattern = build_pattern_none();
	if (!build_accept_pattern(&cursor, pattern))
		cursor_expected(&cursor, "a pattern");
	while (!cursor_at_end(&cursor))
		if (!build_accept_pattern_modifier(&cursor, pattern))
			cursor_unexpected(&cursor);
	return pattern->class ? pattern : NULL;
}
