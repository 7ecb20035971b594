/* The animation loop: which frames, their clock values and the digits of their file names, as
 * POV-Ray counts them. */
#ifndef CLI_ANIMATION_H
#define CLI_ANIMATION_H

#include "cli/options.h"

typedef struct Animation {
	bool active;                      /* false: a single picture, all frame numbers 0 */
	int initial_frame,
		final_frame; /* as the scene sees them: a cyclic animation has one more */
	int first, last, step;            /* to render; the first always is */
	int digits;                       /* of the frame number in file names */
	double initial_clock, final_clock, clock_delta;
} Animation;

Animation animation_plan(const Options *options);

/* The clock of a frame; without an animation the value said, or 0. */
double animation_clock(const Animation *animation, const Options *options, int frame);

#endif
