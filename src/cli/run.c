#include "cli/run.h"

#include <stdio.h>
#include <string.h>

#include "cli/frame.h"
#include "cli/interrupt.h"
#include "cli/output.h"
#include "cli/shell.h"

typedef struct Run {
	const Options *options;
	Animation animation;
	FrameJob job;
	FrameStatistics statistics;
} Run;

/* How a run goes on after a shell command. */
typedef enum Course { COURSE_ON, COURSE_SKIP, COURSE_END, COURSE_STOPPED, COURSE_FAILED } Course;

static Course shell_course(const Run *run, ShellMoment moment, int frame, bool in_loop)
{
	const Options *options = run->options;
	if (!options->shell_command[moment])
		return COURSE_ON;
	Animation outside = {.step = 1};
	ShellFrame about = {
		.output = output_path(options, in_loop ? &run->animation : &outside, frame),
		.scene = output_scene_name(options), .frame = frame,
		.clock = animation_clock(&run->animation, options, frame),
	};
	switch (shell_run(options, moment, &about, run->job.diag)) {
	case SHELL_GO_ON: return COURSE_ON;
	case SHELL_SKIP: return COURSE_SKIP;
	case SHELL_SKIP_ALL:
	case SHELL_QUIT: return COURSE_END;
	case SHELL_USER_STOP: return COURSE_STOPPED;
	case SHELL_FAIL: return COURSE_FAILED;
	}
	return COURSE_ON;
}

static Course course_of(Status status)
{
	return status == STATUS_DONE      ? COURSE_ON
	       : status == STATUS_STOPPED ? COURSE_STOPPED
					  : COURSE_FAILED;
}

static Course run_frame(Run *run, int frame)
{
	Course course = shell_course(run, SHELL_PRE_FRAME, frame, true);
	if (course != COURSE_ON)
		return course;
	run->job.frame = frame;
	if (run->animation.active)
		diag_note(run->job.diag, "frame %d of %d", frame, run->animation.last);
	course = course_of(frame_render(&run->job, &run->statistics));
	return course == COURSE_ON ? shell_course(run, SHELL_POST_FRAME, frame, true) : course;
}

/* The first frame is always rendered, as in POV-Ray. */
static Course run_frames(Run *run)
{
	const Animation *a = &run->animation;
	Course course;
	int frame = a->first;
	do {
		course = run_frame(run, frame);
		frame += a->step;
	} while (course <= COURSE_SKIP && frame <= a->last);
	return course;
}

static bool write_created_ini(const Options *options, Diag *diag)
{
	if (!options->create_ini)
		return true;
	const char *path = options->create_ini;
	if (!*path)
		path = arena_printf(options->arena, "%s.ini", output_scene_name(options));
	return options_write_ini(options, path, diag);
}

static bool report(const Run *run, Status status)
{
	static const char *const names[] = {"done", "failed", "stopped"};
	const Options *options = run->options;
	if (status == STATUS_DONE && options->show_statistics &&
	    (!options->verbose_said || options->verbose))
		statistics_print(stderr, &run->statistics);
	if (options->statistics_file) {
		FILE *file = fopen(options->statistics_file, "w");
		if (file) {
			statistics_print(file, &run->statistics);
			fclose(file);
		}
	}
	return !options->stats ||
	       statistics_write_json(&run->statistics, options->input, names[status],
				     options->stats, run->job.diag);
}

static Status run_around(Run *run)
{
	Course course = shell_course(run, SHELL_PRE_SCENE, 0, false);
	if (course == COURSE_ON)
		course = run_frames(run);
	if (course <= COURSE_END)
		course = shell_course(run, SHELL_POST_SCENE, 0, false) == COURSE_FAILED
				 ? COURSE_FAILED
				 : COURSE_ON;
	if (course == COURSE_STOPPED) {
		shell_course(run, SHELL_USER_ABORT, run->job.frame, run->animation.active);
		return STATUS_STOPPED;
	}
	if (course == COURSE_FAILED) {
		shell_course(run, SHELL_FATAL_ERROR, run->job.frame, run->animation.active);
		return STATUS_FAILED;
	}
	return STATUS_DONE;
}

Status run_scene(const Options *options, const char *switches, Diag *diag)
{
	Run run = {.options = options, .animation = animation_plan(options)};
	run.job = (FrameJob){.options = options,
			     .animation = &run.animation,
			     .switches = switches,
			     .diag = diag};
	if (!frame_region(options, &run.job.region, diag) || !write_created_ini(options, diag))
		return STATUS_FAILED;
	interrupt_install();
	Status status = run_around(&run);
	return report(&run, status) ? status : STATUS_FAILED;
}
