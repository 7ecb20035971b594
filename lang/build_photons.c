#include "lang/build_photons.h"

#include "lang/build_media.h"
#include "lang/cursor.h"

/* ---- numbers with bounds ---- */

/* A whole number of at least 1. */
static bool take_count(Cursor *cursor, int *out)
{
	Location where = cursor_where(cursor);
	int count;
	if (!cursor_take_int(cursor, &count))
		return false;
	if (count >= 1)
		*out = count;
	else
		diag_error(cursor->context->diag, where, "this must be at least 1, not %d", count);
	return count >= 1;
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

static bool read_kernel(Cursor *cursor, Estimator *estimator)
{
	static const struct {
		Word word;
		EstimatorKernel kernel;
	} rows[] = {
		{W_uniform, KERNEL_UNIFORM},           {W_cone, KERNEL_CONE},
		{W_epanechnikov, KERNEL_EPANECHNIKOV}, {W_gaussian, KERNEL_GAUSSIAN},
		{W_isotropic, KERNEL_ISOTROPIC},
	};
	for (size_t i = 0; i < sizeof rows / sizeof *rows; i++)
		if (cursor_accept_word(cursor, rows[i].word)) {
			estimator->kernel = rows[i].kernel;
			return true;
		}
	return cursor_expected(cursor, "a kernel");
}

static bool read_estimator_item(Cursor *cursor, Estimator *estimator)
{
	if (cursor_accept_word(cursor, W_count))
		return take_count(cursor, &estimator->count);
	if (cursor_accept_word(cursor, W_radius))
		return take_positive(cursor, &estimator->radius);
	if (cursor_accept_word(cursor, W_diffusivity))
		return take_positive(cursor, &estimator->diffusivity);
	if (cursor_accept_word(cursor, W_scale))
		return take_positive(cursor, &estimator->scale);
	if (cursor_accept_word(cursor, W_network))
		return cursor_take_string(cursor, &estimator->network);
	if (cursor_accept_word(cursor, W_grid))
		return take_count(cursor, &estimator->grid);
	if (cursor_accept_word(cursor, W_updates))
		return take_count(cursor, &estimator->updates);
	if (cursor_accept_word(cursor, W_kernel))
		return read_kernel(cursor, estimator);
	cursor_unexpected(cursor);
	return false;
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

/* nearest { ... }, or the word alone. */
static bool read_method(Cursor *cursor, Estimator *estimator, Arena *arena)
{
	if (!find_method(cursor_peek_word(cursor), &estimator->kind))
		return cursor_expected(cursor, "an estimator's method");
	bool braces = cursor_peek_block(cursor);
	const Node *method = cursor_next(cursor);
	estimator->kernel = estimator->kind == ESTIMATOR_ADAPTIVE ? KERNEL_GAUSSIAN
								  : KERNEL_EPANECHNIKOV;
	if (!braces)
		return true;
	Cursor inside = cursor_begin(cursor->context, method);
	while (!cursor_at_end(&inside))
		read_estimator_item(&inside, estimator);
	if (estimator->network)
		estimator->network = arena_strdup(arena, estimator->network);
	return true;
}

const Estimator *build_estimator(Context *context, const Node *block)
{
	Cursor cursor = cursor_begin(context, block);
	const Estimator *named = cursor_accept_item(&cursor, VALUE_ESTIMATOR);
	Estimator estimator = {0};
	if (!named && !read_method(&cursor, &estimator, context->builder->arena))
		return NULL;
	cursor_end(&cursor);
	return named ? named : arena_copy(context->builder->arena, &estimator, sizeof estimator);
}

/* ---- relaxation and progressive ---- */

static void read_relaxation_item(Cursor *cursor, Relaxation *relaxation)
{
	if (cursor_accept_word(cursor, W_constrained)) {
		relaxation->constrained = true;
	} else if (cursor_accept_word(cursor, W_plain)) {
		relaxation->constrained = false;
	} else if (cursor_accept_word(cursor, W_iterations)) {
		double world;
		cursor_take_int(cursor, &relaxation->parameter_iterations);
		relaxation->world_iterations = relaxation->parameter_iterations;
		if (cursor_accept_float(cursor, &world))
			relaxation->world_iterations = (int)world;
	} else if (cursor_accept_word(cursor, W_neighbors)) {
		take_count(cursor, &relaxation->neighbors);
	} else if (cursor_accept_word(cursor, W_repulsion_neighbors)) {
		take_count(cursor, &relaxation->repulsion_neighbors);
	} else if (cursor_accept_word(cursor, W_range)) {
		take_positive(cursor, &relaxation->range);
	} else {
		cursor_unexpected(cursor);
	}
}

static Relaxation read_relaxation(Context *context, const Node *block)
{
	Relaxation relaxation = relaxation_default();
	Cursor cursor = cursor_begin(context, block);
	while (!cursor_at_end(&cursor))
		read_relaxation_item(&cursor, &relaxation);
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
			take_count(&cursor, &progressive.passes);
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

static bool accept_global_number(Cursor *cursor, PhotonSettings *settings)
{
	double number;
	if (cursor_accept_word(cursor, W_spacing)) {
		take_positive(cursor, &settings->spacing);
	} else if (cursor_accept_word(cursor, W_count)) {
		take_count(cursor, &settings->count);
	} else if (cursor_accept_word(cursor, W_gather)) {
		if (cursor_take_int(cursor, &settings->gather_min))
			cursor_take_int(cursor, &settings->gather_max);
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
	} else if ((block = cursor_accept_block(cursor, W_progressive))) {
		settings->progressive = read_progressive(cursor->context, block);
	} else if ((block = cursor_accept_block(cursor, W_estimator))) {
		const Estimator *estimator = build_estimator(cursor->context, block);
		if (estimator)
			settings->estimator = *estimator;
	} else {
		return false;
	}
	return true;
}

void build_photons_global(Context *context, const Node *block, PhotonSettings *settings)
{
	Cursor cursor = cursor_begin(context, block);
	settings->on = true;
	while (!cursor_at_end(&cursor))
		if (!accept_global_number(&cursor, settings) &&
		    !accept_global_other(&cursor, settings))
			cursor_unexpected(&cursor);
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
		else if ((inner = cursor_accept_block(&cursor, W_estimator)))
			object->estimator = build_estimator(context, inner);
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
