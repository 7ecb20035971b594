/* One frame: reads the scene, freezes it, renders and writes it. */
#ifndef CLI_FRAME_H
#define CLI_FRAME_H

#include "cli/animation.h"
#include "cli/statistics.h"
#include "cli/status.h"

typedef struct FrameJob {
	const Options *options;
	const Animation *animation;
	int frame;
	const char *switches; /* the command line, for files' headers */
	FilmRect region;
	Diag *diag;
} FrameJob;

/* The pixels that +SC +EC +SR +ER ask for; false, reported, when they lie outside the picture. */
bool frame_region(const Options *options, FilmRect *out, Diag *diag);

/* Adds to the sum what the frame cost. */
Status frame_render(const FrameJob *job, FrameStatistics *sum);

#endif
