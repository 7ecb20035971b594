#include "lang/build_media.h"

#include "lang/cursor.h"

void build_unsupported(Context *context, Unsupported feature, Location where)
{
	static const char *const names[] = {
		[UNSUPPORTED_MEDIA] = "media",
		[UNSUPPORTED_RADIOSITY] = "radiosity",
		[UNSUPPORTED_SUBSURFACE] = "subsurface light",
		[UNSUPPORTED_PHOTONS] = "photons in media",
	};
	if (context->unsupported & 1u << feature)
		return;
	context->unsupported |= 1u << feature;
	diag_warning(context->diag, where, "%s: not rendered yet", names[feature]);
}

/* Words of a media block, and how many numbers may follow each: colours count as one. */
static const struct {
	Word word;
	int least, most;
} media_rows[] = {
	{W_method, 1, 1},       {W_intervals, 1, 1},     {W_samples, 1, 2},
	{W_confidence, 1, 1},   {W_variance, 1, 1},      {W_ratio, 1, 1},
	{W_absorption, 1, 1},   {W_emission, 1, 1},      {W_aa_threshold, 1, 1},
	{W_aa_level, 1, 1},     {W_jitter, 0, 1},        {W_collect, 0, 1},
	{W_translate, 1, 1},    {W_rotate, 1, 1},        {W_scale, 1, 1},
	{W_turbulence, 1, 1},   {W_octaves, 1, 1},       {W_omega, 1, 1},
	{W_lambda, 1, 1},       {W_phase, 1, 1},         {W_frequency, 1, 1},
	{W_ramp_wave, 0, 0},    {W_triangle_wave, 0, 0}, {W_sine_wave, 0, 0},
	{W_scallop_wave, 0, 0}, {W_cubic_wave, 0, 0},    {W_poly_wave, 0, 1},
	{W_eccentricity, 1, 1}, {W_extinction, 1, 1},    {W_matrix, 12, 12},
};

static bool accept_media_word(Cursor *cursor)
{
	for (size_t i = 0; i < sizeof media_rows / sizeof *media_rows; i++) {
		if (!cursor_accept_word(cursor, media_rows[i].word))
			continue;
		int taken = 0;
		for (; taken < media_rows[i].most && cursor_peek_numeric(cursor); taken++)
			cursor_next(cursor);
		if (taken < media_rows[i].least)
			cursor_expected(cursor, "a number");
		return true;
	}
	return false;
}

/* scattering { type, color eccentricity e extinction e } */
static void read_scattering(Context *context, const Node *block)
{
	Cursor cursor = cursor_begin(context, block);
	double type;
	Rgbft color;
	if (cursor_take_float(&cursor, &type))
		cursor_take_color(&cursor, &color);
	while (!cursor_at_end(&cursor))
		if (!accept_media_word(&cursor))
			cursor_unexpected(&cursor);
}

static void read_media(Context *context, const Node *block)
{
	Cursor cursor = cursor_begin(context, block);
	while (!cursor_at_end(&cursor)) {
		const Node *inner = cursor_accept_block(&cursor, W_scattering);
		if (inner) {
			read_scattering(context, inner);
		} else if (cursor_peek_block(&cursor)) {
			inner = cursor_next(&cursor);
			if (inner->word == W_media)
				read_media(context, inner);
		} else if (!cursor_accept_item(&cursor, VALUE_MEDIA) &&
			   !accept_media_word(&cursor)) {
			cursor_unexpected(&cursor);
		}
	}
}

/* A density holds whatever a pigment does; its patterns get their check when they are rendered. */
const Media *build_media(Context *context, const Node *block)
{
	Media *media = ARENA_NEW(context->builder->arena, Media);
	media->any = block->children != NULL;
	if (block->word == W_media)
		read_media(context, block);
	build_unsupported(context, UNSUPPORTED_MEDIA, block->where);
	return media;
}
