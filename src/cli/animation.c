#include "cli/animation.h"

#include <math.h>
#include <stdio.h>

/* Below 1 a share of the final frame's number, else a frame; not said: fallback. */
static int first_frame(double said, int final_frame, int initial_frame)
{
	double frame = said < 0   ? initial_frame
		       : said < 1 ? floor(said * final_frame)
				  : floor(said);
	return (int)fmin(fmax(frame, initial_frame), OPTIONS_MOST_WHOLE);
}

static int last_frame(double said, int final_frame, int fallback)
{
	return said < 0   ? fallback
	       : said < 1 ? (int)floor(said * final_frame + 0.5)
			  : (int)fmin(said, OPTIONS_MOST_WHOLE);
}

Animation animation_plan(const Options *options)
{
	int initial = options->initial_frame, final = options->final_frame;
	if (initial < 0)
		initial = final > 0 ? 1 : 0;
	if (final < initial)
		final = initial;
	if (final == 0)
		return (Animation){.step = 1};
	Animation a = {
		.active = true, .initial_frame = initial, .final_frame = final + options->cyclic};
	a.first = first_frame(options->subset_start, a.final_frame, initial);
	a.last = last_frame(options->subset_end, a.final_frame, final);
	a.step = options->frame_step;
	a.digits = snprintf(NULL, 0, "%d", a.final_frame);
	a.initial_clock = options->initial_clock;
	a.final_clock = options->final_clock;
	if (a.final_frame > initial) /* POV-Ray divides by 0 here for a single frame */
		a.clock_delta = (a.final_clock - a.initial_clock) / (a.final_frame - initial);
	return a;
}

double animation_clock(const Animation *a, const Options *options, int frame)
{
	if (!a->active)
		return options->clock;
	return a->initial_clock + (frame - a->initial_frame) * a->clock_delta;
}
