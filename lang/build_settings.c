#include "lang/build_settings.h"

#include "lang/build_media.h"
#include "lang/build_photons.h"
#include "lang/cursor.h"

/* assumed_gamma number or assumed_gamma srgb. The first one stays, as colours were read by it. */
static void read_gamma(Cursor *cursor, Settings *settings)
{
	double gamma = 0;
	if (cursor_accept_word(cursor, W_srgb))
		gamma = -1;
	else
		cursor_take_float(cursor, &gamma);
	if (settings->assumed_gamma == 0)
		settings->assumed_gamma = gamma;
	else if (gamma != settings->assumed_gamma)
		diag_warning(cursor->context->diag, cursor->last->where,
			     "assumed_gamma is set already; this one has no effect");
}

/* charset only says how the file's bytes are meant; texts are UTF-8 here whatever it says. */
static void read_charset(Cursor *cursor)
{
	if (!cursor_accept_word(cursor, W_ascii) && !cursor_accept_word(cursor, W_utf8) &&
	    !cursor_accept_word(cursor, W_sys))
		cursor_expected(cursor, "ascii, utf8 or sys");
}

/* Numbers and colours; false when none of these words is next. */
static bool accept_number(Cursor *cursor, Settings *settings)
{
	if (cursor_accept_word(cursor, W_adc_bailout))
		cursor_take_float(cursor, &settings->adc_bailout);
	else if (cursor_accept_word(cursor, W_ambient_light))
		cursor_take_rgb(cursor, &settings->ambient_light);
	else if (cursor_accept_word(cursor, W_irid_wavelength))
		cursor_take_rgb(cursor, &settings->irid_wavelength);
	else if (cursor_accept_word(cursor, W_max_trace_level))
		cursor_take_int(cursor, &settings->max_trace_level);
	else if (cursor_accept_word(cursor, W_max_intersections))
		cursor_take_int(cursor, &settings->max_intersections);
	else if (cursor_accept_word(cursor, W_number_of_waves))
		cursor_take_int(cursor, &settings->number_of_waves);
	else if (cursor_accept_word(cursor, W_noise_generator))
		cursor_take_int(cursor, &settings->noise_generator);
	else if (cursor_accept_word(cursor, W_mm_per_unit))
		cursor_take_float(cursor, &settings->mm_per_unit);
	else
		return false;
	return true;
}

/* radiosity { } and subsurface { }: words with numbers; one or two, or on and off. */
static void read_numbers(Context *context, const Node *block, const Word *words, size_t count)
{
	Cursor cursor = cursor_begin(context, block);
	while (!cursor_at_end(&cursor)) {
		size_t i = 0;
		while (i < count && !cursor_accept_word(&cursor, words[i]))
			i++;
		if (i == count)
			cursor_unexpected(&cursor);
		while (cursor_peek_numeric(&cursor) || cursor_peek_string(&cursor))
			cursor_next(&cursor);
	}
}

static void read_radiosity(Context *context, const Node *block)
{
	static const Word words[] = {
		W_adc_bailout, W_always_sample,  W_brightness,       W_count,
		W_error_bound, W_gray_threshold, W_low_error_factor, W_max_sample,
		W_media,       W_maximum_reuse,  W_minimum_reuse,    W_nearest_count,
		W_normal,      W_pretrace_start, W_pretrace_end,     W_recursion_limit,
		W_subsurface,  W_save_file,      W_load_file,
	};
	read_numbers(context, block, words, sizeof words / sizeof *words);
	context->builder->settings.has_radiosity = true;
	build_unsupported(context, UNSUPPORTED_RADIOSITY, block->where);
}

static void read_subsurface(Context *context, const Node *block)
{
	static const Word words[] = {W_radiosity, W_samples};
	read_numbers(context, block, words, sizeof words / sizeof *words);
	build_unsupported(context, UNSUPPORTED_SUBSURFACE, block->where);
}

static bool accept_block(Cursor *cursor)
{
	Context *context = cursor->context;
	const Node *block;
	if ((block = cursor_accept_block(cursor, W_radiosity)))
		read_radiosity(context, block);
	else if ((block = cursor_accept_block(cursor, W_subsurface)))
		read_subsurface(context, block);
	else if ((block = cursor_accept_block(cursor, W_photons)))
		build_photons_global(context, block, &context->builder->settings.photons);
	else
		return false;
	return true;
}

static void read_setting(Cursor *cursor)
{
	Settings *settings = &cursor->context->builder->settings;
	if (accept_number(cursor, settings) || accept_block(cursor))
		return;
	if (cursor_accept_word(cursor, W_assumed_gamma)) {
		read_gamma(cursor, settings);
	} else if (cursor_accept_word(cursor, W_charset)) {
		read_charset(cursor);
	} else if (cursor_accept_word(cursor, W_hf_gray_16)) {
		diag_warning(cursor->context->diag, cursor->last->where,
			     "hf_gray_16 has no effect");
		cursor_optional_bool(cursor);
	} else {
		cursor_unexpected(cursor);
	}
}

void build_global_settings(Context *context, const Node *block)
{
	Cursor cursor = cursor_begin(context, block);
	while (!cursor_at_end(&cursor))
		read_setting(&cursor);
}

bool build_old_setting(Context *context, const Node **at)
{
	Cursor cursor = cursor_over(context, *at);
	if (!accept_number(&cursor, &context->builder->settings)) {
		if (!cursor_accept_word(&cursor, W_assumed_gamma))
			return false;
		read_gamma(&cursor, &context->builder->settings);
	}
	*at = cursor.at;
	return true;
}
