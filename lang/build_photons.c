#include "lang/build_photons.h"

#include "lang/build_media.h"
#include "lang/cursor.h"

/* ---- numbers with bounds ---- */

/* How many paths to trace: no int, as memory holds more photons than an int counts. */
static void take_paths(Cursor *cursor, double *out)
{
	static const double most = 1e15; /* more are not traced in a lifetime */
	Location where = cursor_where(cursor);
	double count;
	if (!cursor_take_float(cursor, &count))
		return;
	if (count >= 1 && count <= most)
		*out = floor(count);
	else
		diag_error(cursor->context->diag, where, "this must be from 1 to %g, not %g", most,
			   count);
}

/* A number above 0. */
static bool take_positive(Cursor *cursor, double *out)
{
	Location where = cursor_where(cursor);
	double number;
	if (!cursor_take_float(cursor, &number))
		return false;
	if (number > 0)
		*out = number;
	else
		diag_error(cursor->context->diag, where, "this must be above 0, not %g", number);
	return number > 0;
}

/* ---- estimator ---- */

enum { NEAREST_COUNT = 50 };

static bool take_photons(Cursor *cursor, Estimator *estimator)
{
	return cursor_take_whole(cursor, 1, ESTIMATOR_MOST_PHOTONS, &estimator->count);
}

static bool take_radius(Cursor *cursor, Estimator *estimator)
{
	return take_positive(cursor, &estimator->radius);
}

static bool take_diffusivity(Cursor *cursor, Estimator *estimator)
{
	return take_positive(cursor, &estimator->diffusivity);
}

/* Each place has so many patches over it as the square of their scale: hundreds are no longer
 * looked through for each pixel in any time, and nothing of the caustic is left to see. */
static const double MOST_SCALE = 10;

static bool take_scale(Cursor *cursor, Estimator *estimator)
{
	Location where = cursor_where(cursor);
	double scale;
	if (!take_positive(cursor, &scale))
		return false;
	if (scale <= MOST_SCALE)
		estimator->scale = scale;
	else
		diag_error(cursor->context->diag, where, "this must be at most %g, not %g",
			   MOST_SCALE, scale);
	return scale <= MOST_SCALE;
}

static bool take_kernel(Cursor *cursor, Estimator *estimator)
{
	static const struct {
		Word word;
		EstimatorKernel kernel;
	} rows[] = {
		{W_uniform, KERNEL_UNIFORM},           {W_cone, KERNEL_CONE},
		{W_epanechnikov, KERNEL_EPANECHNIKOV}, {W_gaussian, KERNEL_GAUSSIAN},
	};
	for (size_t i = 0; i < sizeof rows / sizeof *rows; i++)
		if (cursor_accept_word(cursor, rows[i].word)) {
			estimator->kernel = rows[i].kernel;
			return true;
		}
	cursor_expected(cursor, "a kernel");
	if (!cursor_at_end(cursor))
		cursor_next(cursor);
	return false;
}

/* The words of each method; deep and adaptive have theirs when they are built. */
static const struct {
	EstimatorKind kind;
	Word word;
	bool (*take)(Cursor *cursor, Estimator *estimator);
} method_words[] = {
	{ESTIMATOR_NEAREST, W_count, take_photons},
	{ESTIMATOR_NEAREST, W_radius, take_radius},
	{ESTIMATOR_NEAREST, W_kernel, take_kernel},
	{ESTIMATOR_DIFFUSION, W_count, take_photons},
	{ESTIMATOR_DIFFUSION, W_diffusivity, take_diffusivity},
	{ESTIMATOR_FOOTPRINT, W_scale, take_scale},
};

static void read_estimator_item(Cursor *cursor, Estimator *estimator)
{
	for (size_t i = 0; i < sizeof method_words / sizeof *method_words; i++)
		if (method_words[i].kind == estimator->kind &&
		    cursor_accept_word(cursor, method_words[i].word)) {
			method_words[i].take(cursor, estimator);
			return;
		}
	cursor_unexpected(cursor);
}

static bool find_method(Word word, EstimatorKind *kind)
{
	switch (word) {
	case W_nearest: *kind = ESTIMATOR_NEAREST; return true;
	case W_diffusion: *kind = ESTIMATOR_DIFFUSION; return true;
	case W_footprint: *kind = ESTIMATOR_FOOTPRINT; return true;
	case W_deep: *kind = ESTIMATOR_DEEP; return true;
	case W_adaptive: *kind = ESTIMATOR_ADAPTIVE; return true;
	default: return false;
	}
}

static bool is_built(const Estimator *estimator)
{
	return estimator->kind != ESTIMATOR_DEEP && estimator->kind != ESTIMATOR_ADAPTIVE;
}

/* nearest { ... }, or the word alone. */
static bool read_method(Cursor *cursor, Estimator *estimator)
{
	Location where = cursor_where(cursor);
	if (!find_method(cursor_peek_word(cursor), &estimator->kind))
		return cursor_expected(cursor, "an estimator's method");
	bool braces = cursor_peek_block(cursor);
	const Node *method = cursor_next(cursor);
	if (!is_built(estimator)) {
		diag_error(cursor->context->diag, where, "this estimator is not built yet");
		return true;
	}
	estimator->kernel = KERNEL_EPANECHNIKOV;
	Cursor inside = cursor_begin(cursor->context, method);
	while (braces && !cursor_at_end(&inside))
		read_estimator_item(&inside, estimator);
	if (estimator->kind == ESTIMATOR_NEAREST && !(estimator->radius > 0) &&
	    estimator->count == 0)
		estimator->count = NEAREST_COUNT;
	return true;
}

const Estimator *build_estimator(Context *context, const Node *block)
{
	Cursor cursor = cursor_begin(context, block);
	const Estimator *named = cursor_accept_item(&cursor, VALUE_ESTIMATOR);
	Estimator estimator = {.where = block->where};
	if (!named && !read_method(&cursor, &estimator))
		return NULL;
	cursor_end(&cursor);
	return named ? named : arena_copy(context->builder->arena, &estimator, sizeof estimator);
}

/* Reports a block's word without its braces, and passes over the method that follows, so that it is
 * no second error. */
static void skip_unbraced(Cursor *cursor)
{
	EstimatorKind kind;
	Word word = cursor_peek_word(cursor);
	cursor_expected(cursor, "'{'");
	if (find_method(word, &kind) || word == W_constrained || word == W_plain)
		cursor_next(cursor);
}

/* ---- relaxation and progressive ---- */

/* In parameter space, then in world space; one number stands for both. */
static void take_iterations(Cursor *cursor, Relaxation *relaxation)
{
	enum { MOST = 1000 };
	if (!cursor_take_whole(cursor, 0, MOST, &relaxation->parameter_iterations))
		return;
	relaxation->world_iterations = relaxation->parameter_iterations;
	if (cursor_peek_float(cursor))
		cursor_take_whole(cursor, 0, MOST, &relaxation->world_iterations);
}

static void read_relaxation_item(Cursor *cursor, Relaxation *relaxation)
{
	if (cursor_accept_word(cursor, W_constrained)) {
		relaxation->constrained = true;
	} else if (cursor_accept_word(cursor, W_plain)) {
		relaxation->constrained = false;
	} else if (cursor_accept_word(cursor, W_iterations)) {
		take_iterations(cursor, relaxation);
	} else if (cursor_accept_word(cursor, W_neighbors)) {
		cursor_take_whole(cursor, 3, 1000, &relaxation->neighbors);
	} else if (cursor_accept_word(cursor, W_repulsion_neighbors)) {
		cursor_take_whole(cursor, 1, 255, &relaxation->repulsion_neighbors);
	} else if (cursor_accept_word(cursor, W_range)) {
		take_positive(cursor, &relaxation->range);
	} else if (cursor_accept_word(cursor, W_gradient)) {
		relaxation->gradient = cursor_optional_bool(cursor);
	} else if (cursor_accept_word(cursor, W_hues)) {
		relaxation->hues = cursor_optional_bool(cursor);
	} else {
		cursor_unexpected(cursor);
	}
}

static Relaxation read_relaxation(Context *context, const Node *block)
{
	enum { UNSAID = -1 };
	Relaxation relaxation = relaxation_default(), plain = relaxation_plain();
	int iterations = relaxation.parameter_iterations;
	relaxation.parameter_iterations = UNSAID;
	Cursor cursor = cursor_begin(context, block);
	while (!cursor_at_end(&cursor))
		read_relaxation_item(&cursor, &relaxation);
	if (relaxation.parameter_iterations != UNSAID)
		return relaxation;
	relaxation.parameter_iterations =
		relaxation.constrained ? iterations : plain.parameter_iterations;
	if (!relaxation.constrained)
		relaxation.world_iterations = plain.world_iterations;
	return relaxation;
}

static void read_reduction(Cursor *cursor, Progressive *progressive)
{
	static const struct {
		Word word;
		Reduction reduction;
	} rows[] = {
		{W_apa, REDUCTION_APA},           {W_ppm, REDUCTION_PPM},
		{W_appm, REDUCTION_APPM},         {W_cppm, REDUCTION_CPPM},
		{W_schedule, REDUCTION_SCHEDULE},
	};
	Location where = cursor_where(cursor);
	for (size_t i = 0; i < sizeof rows / sizeof *rows; i++)
		if (cursor_accept_word(cursor, rows[i].word)) {
			progressive->reduction = rows[i].reduction;
			if (rows[i].reduction != REDUCTION_APA)
				diag_error(cursor->context->diag, where,
					   "this reduction is not built yet; apa is");
			return;
		}
	cursor_expected(cursor, "a reduction");
}

static Progressive read_progressive(Context *context, const Node *block)
{
	Progressive progressive = {.on = true};
	Cursor cursor = cursor_begin(context, block);
	while (!cursor_at_end(&cursor)) {
		if (cursor_accept_word(&cursor, W_passes))
			cursor_take_whole(&cursor, 1, PROGRESSIVE_MOST_PASSES, &progressive.passes);
		else if (cursor_accept_word(&cursor, W_time))
			take_positive(&cursor, &progressive.seconds);
		else if (cursor_accept_word(&cursor, W_radius))
			take_positive(&cursor, &progressive.radius);
		else if (cursor_accept_word(&cursor, W_reduction))
			read_reduction(&cursor, &progressive);
		else
			cursor_unexpected(&cursor);
	}
	return progressive;
}

/* ---- global_settings { photons { } } ---- */

/* radius surface, factor, media, factor: each may be missing. */
static void read_radii(Cursor *cursor, PhotonSettings *settings)
{
	for (int i = 0; i < PHOTON_RADII; i++) {
		settings->radii[i].radius = cursor_optional_float(cursor, 0);
		settings->radii[i].factor = cursor_optional_float(cursor, 1);
	}
}

static const char *take_path(Cursor *cursor)
{
	const char *path = NULL;
	return cursor_take_string(cursor, &path)
		       ? arena_strdup(cursor->context->builder->arena, path)
		       : NULL;
}

/* POV-Ray takes any maximum; here a warning tells what is gathered instead. */
static void read_gather(Cursor *cursor, PhotonSettings *settings)
{
	if (!cursor_take_int(cursor, &settings->gather_min))
		return;
	Location where = cursor_where(cursor);
	if (!cursor_take_int(cursor, &settings->gather_max) ||
	    settings->gather_max <= ESTIMATOR_MOST_PHOTONS)
		return;
	settings->gather_max = ESTIMATOR_MOST_PHOTONS;
	diag_warning(cursor->context->diag, where, "at most %d photons are gathered",
		     ESTIMATOR_MOST_PHOTONS);
}

static bool accept_global_number(Cursor *cursor, PhotonSettings *settings)
{
	double number;
	Location where = cursor_where(cursor);
	if (cursor_accept_word(cursor, W_spacing)) {
		settings->where = where;
		take_positive(cursor, &settings->spacing);
	} else if (cursor_accept_word(cursor, W_count)) {
		settings->where = where;
		take_paths(cursor, &settings->count);
	} else if (cursor_accept_word(cursor, W_gather)) {
		read_gather(cursor, settings);
	} else if (cursor_accept_word(cursor, W_radius)) {
		read_radii(cursor, settings);
	} else if (cursor_accept_word(cursor, W_jitter)) {
		cursor_take_float(cursor, &settings->jitter);
	} else if (cursor_accept_word(cursor, W_autostop)) {
		cursor_take_float(cursor, &settings->autostop);
	} else if (cursor_accept_word(cursor, W_max_trace_level)) {
		cursor_take_int(cursor, &settings->max_trace_level);
	} else if (cursor_accept_word(cursor, W_adc_bailout)) {
		cursor_take_float(cursor, &settings->adc_bailout);
	} else if (cursor_accept_word(cursor, W_expand_thresholds)) {
		if (cursor_take_float(cursor, &settings->expand_increase))
			cursor_take_int(cursor, &settings->expand_min);
	} else if (cursor_accept_word(cursor, W_media)) {
		if (cursor_take_int(cursor, &settings->media_steps) &&
		    cursor_accept_float(cursor, &number))
			settings->media_factor = number;
	} else {
		return false;
	}
	return true;
}

static bool accept_global_other(Cursor *cursor, PhotonSettings *settings)
{
	const Node *block;
	if (cursor_accept_word(cursor, W_save_file)) {
		settings->save_file = take_path(cursor);
	} else if (cursor_accept_word(cursor, W_load_file)) {
		settings->load_file = take_path(cursor);
	} else if (cursor_accept_word(cursor, W_emitter_coordinates)) {
		settings->emitter_coordinates = cursor_optional_bool(cursor);
	} else if ((block = cursor_accept_block(cursor, W_relaxation))) {
		settings->relaxation = read_relaxation(cursor->context, block);
	} else if (cursor_accept_word(cursor, W_relaxation)) {
		settings->relaxation = relaxation_default();
		if (cursor_peek_word(cursor) == W_constrained ||
		    cursor_peek_word(cursor) == W_plain)
			skip_unbraced(cursor);
		else
			settings->relaxation.on = cursor_optional_bool(cursor);
	} else if ((block = cursor_accept_block(cursor, W_progressive))) {
		settings->progressive = read_progressive(cursor->context, block);
	} else if ((block = cursor_accept_block(cursor, W_estimator))) {
		const Estimator *estimator = build_estimator(cursor->context, block);
		if (estimator)
			settings->estimator = *estimator;
	} else if (cursor_accept_word(cursor, W_estimator) ||
		   cursor_accept_word(cursor, W_progressive)) {
		skip_unbraced(cursor);
	} else {
		return false;
	}
	return true;
}

/* Some methods need to know where photons left their light. */
static void check_coordinates(Context *context, const Node *block, const PhotonSettings *settings)
{
	if (settings->emitter_coordinates)
		return;
	if (settings->relaxation.on && settings->relaxation.constrained)
		diag_error(context->diag, block->where,
			   "constrained relaxation needs emitter_coordinates");
	if (settings->estimator.kind == ESTIMATOR_FOOTPRINT)
		diag_error(context->diag, settings->estimator.where,
			   "the estimator footprint needs emitter_coordinates");
}

void build_photons_global(Context *context, const Node *block, PhotonSettings *settings)
{
	Cursor cursor = cursor_begin(context, block);
	settings->on = true;
	settings->where = block->where;
	while (!cursor_at_end(&cursor))
		if (!accept_global_number(&cursor, settings) &&
		    !accept_global_other(&cursor, settings))
			cursor_unexpected(&cursor);
	check_coordinates(context, block, settings);
	if (settings->media_steps > 0)
		build_unsupported(context, UNSUPPORTED_PHOTONS, block->where);
}

/* ---- objects and lights ---- */

static Tristate take_switch(Cursor *cursor) { return cursor_optional_bool(cursor) ? ON : OFF; }

/* target's number multiplies the spacing; 0 turns the target off. */
static void read_target(Cursor *cursor, Object *object)
{
	double spacing = cursor_optional_float(cursor, 1);
	object->flags.photons_target = spacing > 0 ? ON : OFF;
	object->photon_spacing = spacing;
}

void build_photons_object(Context *context, const Node *block, Object *object)
{
	Cursor cursor = cursor_begin(context, block);
	const Node *inner;
	while (!cursor_at_end(&cursor)) {
		if (cursor_accept_word(&cursor, W_target))
			read_target(&cursor, object);
		else if (cursor_accept_word(&cursor, W_refraction))
			object->flags.photons_refraction = take_switch(&cursor);
		else if (cursor_accept_word(&cursor, W_reflection))
			object->flags.photons_reflection = take_switch(&cursor);
		else if (cursor_accept_word(&cursor, W_collect))
			object->flags.photons_collect = take_switch(&cursor);
		else if (cursor_accept_word(&cursor, W_pass_through))
			object->flags.photons_pass_through = take_switch(&cursor);
		else if (cursor_accept_word(&cursor, W_relaxation))
			object->flags.relaxation = take_switch(&cursor);
		else if ((inner = cursor_accept_block(&cursor, W_relaxation)))
			diag_error(context->diag, inner->where,
				   "an object's relaxation is on or off; global_settings { photons "
				   "{ } } says how");
		else if ((inner = cursor_accept_block(&cursor, W_estimator)))
			object->estimator = build_estimator(context, inner);
		else if (cursor_accept_word(&cursor, W_estimator))
			skip_unbraced(&cursor);
		else
			cursor_unexpected(&cursor);
	}
}

/* How many paths the light sends beside the others; 0 none. */
static void take_share(Context *context, Cursor *cursor, const Node *block, Light *light)
{
	double share;
	if (!cursor_take_float(cursor, &share))
		return;
	if (share >= 0)
		light->photons_share = share;
	else
		diag_error(context->diag, block->where,
			   "a light's share of photons cannot be negative");
}

void build_photons_light(Context *context, const Node *block, Light *light)
{
	Cursor cursor = cursor_begin(context, block);
	while (!cursor_at_end(&cursor)) {
		if (cursor_accept_word(&cursor, W_refraction))
			light->photons_refraction = cursor_optional_bool(&cursor);
		else if (cursor_accept_word(&cursor, W_reflection))
			light->photons_reflection = cursor_optional_bool(&cursor);
		else if (cursor_accept_word(&cursor, W_area_light))
			light->photons_area = cursor_optional_bool(&cursor);
		else if (cursor_accept_word(&cursor, W_share))
			take_share(context, &cursor, block, light);
		else
			cursor_unexpected(&cursor);
	}
}
