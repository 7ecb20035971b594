#include "cli/frame.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "base/clock.h"
#include "cli/interrupt.h"
#include "cli/library.h"
#include "cli/output.h"
#include "cli/progress.h"

/* Up to 1 a share of the size, else counted from 1: the first pixel or row. */
static int region_start(double said, int size)
{
	return said < 0 ? 0 : said < 1 ? (int)floor(said * size) : (int)fmin(said - 1, size);
}

/* One past the last. */
static int region_end(double said, int size)
{
	return said < 0 ? size : said <= 1 ? (int)floor(said * size) : (int)fmin(said, size + 1.0);
}

bool frame_region(const Options *options, FilmRect *out, Diag *diag)
{
	int width = options->width, height = options->height;
	out->x0 = region_start(options->start_column, width);
	out->x1 = region_end(options->end_column, width);
	out->y0 = region_start(options->start_row, height);
	out->y1 = region_end(options->end_row, height);
	if (width <= 0 || height <= 0) {
		diag_fail(diag, "a picture of %d x %d pixels cannot be rendered", width, height);
		return false;
	}
	if (out->x0 >= width || out->x1 > width || out->x1 < 1 || out->y0 >= height ||
	    out->y1 > height || out->y1 < 1) {
		diag_fail(diag, "the columns or rows to render lie outside the %d x %d pixels",
			  width, height);
		return false;
	}
	return true;
}

/* What one frame works with from its beginning to its end. */
typedef struct FrameWork {
	const FrameJob *job;
	const char *path, *state_path;
	uint64_t key;
	Scene *scene;
	Film *film;
	OutputOrigin origin;
	ProgressLine line;
	double last_update; /* seconds since the render began */
	FrameStatistics statistics;
} FrameWork;

static uint64_t hash_text(uint64_t hash, const char *text, size_t length)
{
	for (size_t i = 0; i < length; i++)
		hash = (hash ^ (unsigned char)text[i]) * 0x100000001b3u; /* FNV-1a */
	return hash;
}

static uint64_t hash_file(uint64_t hash, const char *path)
{
	char block[4096];
	size_t got;
	FILE *file = strcmp(path, "-") == 0 ? NULL : fopen(path, "rb");
	if (!file)
		return hash;
	while ((got = fread(block, 1, sizeof block, file)) > 0)
		hash = hash_text(hash, block, got);
	fclose(file);
	return hash;
}

/* Of all that must be equal for going on with an unfinished frame. */
static uint64_t resume_key(const FrameJob *job)
{
	const Options *o = job->options;
	char text[512];
	int length = snprintf(text, sizeof text, "%d %d %d %d %d %g %d %d %g %g %d %d %llu %g",
			      o->width, o->height, o->quality, o->antialias, o->sampling_method,
			      o->threshold, o->depth, o->jitter, o->jitter_amount,
			      o->antialias_gamma, o->alpha, job->frame, (unsigned long long)o->seed,
			      animation_clock(job->animation, o, job->frame));
	uint64_t hash = hash_file(hash_text(0xcbf29ce484222325u, text, (size_t)length), o->input);
	for (int i = 0; i < o->constant_count; i++) {
		hash = hash_text(hash, o->constants[i].name, strlen(o->constants[i].name) + 1);
		hash = hash_text(hash, o->constants[i].text, strlen(o->constants[i].text) + 1);
	}
	return hash;
}

static ReaderOptions reader_options(const FrameJob *job, const LibraryPaths *library)
{
	const Options *o = job->options;
	const Animation *a = job->animation;
	return (ReaderOptions){
		.path = o->input,
		.library_paths = library->paths,
		.library_path_count = library->count,
		.header_include = o->include_header,
		.constants = o->constants,
		.constant_count = o->constant_count,
		.version = o->version,
		.clock = animation_clock(a, o, job->frame),
		.clock_delta = a->clock_delta,
		.initial_clock = a->initial_clock,
		.final_clock = a->final_clock,
		.frame_number = job->frame,
		.initial_frame = a->initial_frame,
		.final_frame = a->final_frame,
		.clock_on = a->active || o->clock_said,
		.image_width = o->width,
		.image_height = o->height,
		.quick_colors = o->quality <= 5,
		.allow_write_anywhere = o->allow_write,
	};
}

/* Text to scene. */
static bool build_scene(FrameWork *work)
{
	const FrameJob *job = work->job;
	LibraryPaths library = library_paths(job->options);
	ReaderOptions options = reader_options(job, &library);
	SceneBuilder builder = {
		.arena = arena_create(), .diag = job->diag, .settings = settings_default()};
	builder.camera = camera_default((double)job->options->width / job->options->height);
	double start = clock_wall();
	interrupt_end_at_once(true);
	bool good = reader_read(&options, &builder, job->diag);
	double parsed = clock_wall();
	work->statistics.parse_seconds = parsed - start;
	work->scene = good ? scene_freeze(&builder) : NULL;
	interrupt_end_at_once(false);
	work->statistics.build_seconds = clock_wall() - parsed;
	arena_destroy(builder.arena);
	return work->scene != NULL;
}

static RenderOptions render_options(const FrameWork *work)
{
	const Options *o = work->job->options;
	RenderOptions r = render_options_default();
	r.region = work->job->region;
	r.quality = o->quality;
	r.antialias = o->antialias;
	r.sampling_method = o->sampling_method;
	r.threshold = o->threshold;
	r.depth = o->depth;
	r.jitter = o->jitter ? o->jitter_amount : 0;
	r.gamma = o->antialias_gamma;
	r.alpha = o->alpha;
	r.seed = o->seed;
	r.progress_interval = o->update > 0 && o->update < 0.25 ? o->update : 0.25;
	return r;
}

/* The state first: a run killed in between must not leave a picture that looks finished. */
static void write_so_far(FrameWork *work)
{
	Film *film = film_snapshot(work->film);
	work->origin.passes = work->statistics.passes;
	if (work->job->options->resume)
		film_save(film, work->state_path, work->key, work->job->diag);
	output_write(work->job->options, film, &work->origin, work->path, work->job->diag);
	film_destroy(film);
}

static void on_progress(void *data, const RenderProgress *progress)
{
	FrameWork *work = data;
	const Options *options = work->job->options;
	progress_show(&work->line, progress);
	if (options->update > 0 && options->to_file &&
	    progress->seconds - work->last_update >= options->update &&
	    strcmp(work->path, "-") != 0) {
		write_so_far(work);
		work->last_update = progress->seconds;
	}
}

/* Progressive passes keep their state when all that were asked for are done, for more of them
 * later. */
static bool keeps_state(const FrameWork *work)
{
	return work->job->options->resume && film_passes(work->film) > 0;
}

/* Writes the finished picture; what is left of an earlier, unfinished run goes. */
static Status finish(FrameWork *work)
{
	double start = clock_wall();
	if (!work->job->options->to_file)
		return STATUS_DONE;
	bool named = strcmp(work->path, "-") != 0, keeps = keeps_state(work) && named;
	bool good = !keeps || film_save(work->film, work->state_path, work->key, work->job->diag);
	good = good && output_write(work->job->options, work->film, &work->origin, work->path,
				    work->job->diag);
	work->statistics.write_seconds = clock_wall() - start;
	if (good && named && !keeps)
		unlink(work->state_path);
	return good ? STATUS_DONE : STATUS_FAILED;
}

/* With +C the picture so far and the state to go on from, else nothing. */
static Status stop(FrameWork *work)
{
	const Options *options = work->job->options;
	if (options->to_file && options->resume && strcmp(work->path, "-") != 0)
		write_so_far(work);
	else if (options->to_file && options->update > 0 && work->last_update > 0)
		unlink(work->path); /* the picture so far, which nobody asked to keep */
	diag_note(work->job->diag, "stopped");
	return STATUS_STOPPED;
}

/* NULL, reported, for a picture that memory cannot hold. */
static Film *new_film(const FrameWork *work)
{
	static const double giga = 1e9;
	const Options *options = work->job->options;
	unsigned layers = output_layers(options, work->scene->settings.photons.on ||
							 options->load_photons_file);
	double bytes = film_bytes(options->width, options->height, layers);
	if (bytes <= memory_most())
		return film_create(options->width, options->height, layers);
	diag_fail(work->job->diag,
		  "a picture of %d x %d pixels takes %.0f GB of memory; here are %.1f GB",
		  options->width, options->height, bytes / giga, memory_most() / giga);
	return NULL;
}

static Film *open_film(const FrameWork *work)
{
	const Options *options = work->job->options;
	if (options->resume && access(work->state_path, F_OK) == 0) {
		Film *film = film_load(work->state_path, work->key, work->job->diag);
		if (film)
			diag_note(work->job->diag, "going on with %s", work->path);
		return film;
	}
	return new_film(work);
}

static PassOptions pass_options(const Options *options)
{
	return (PassOptions){
		.save_file = options->photons_file,
		.load_file = options->load_photons_file,
		.landed_file = options->photons_landed_file,
		.estimator = options->estimator_said ? &options->estimator : NULL,
		.passes = options->passes,
	};
}

static Status trace(FrameWork *work)
{
	RenderOptions options = render_options(work);
	RenderCallbacks callbacks = {
		.progress = on_progress, .data = work, .stop = interrupt_flag()};
	double start = clock_wall();
	work->film = open_film(work);
	if (!work->film)
		return STATUS_FAILED;
	PassOptions passes = pass_options(work->job->options);
	PassJob job = {work->scene, &options, &passes, &callbacks, work->film, work->job->diag};
	RenderStatus status = passes_render(&job, &work->statistics.passes);
	work->statistics.trace_seconds = clock_wall() - start;
	work->origin.passes = work->statistics.passes;
	progress_clear(&work->line);
	return status == RENDER_DONE      ? finish(work)
	       : status == RENDER_STOPPED ? stop(work)
					  : STATUS_FAILED;
}

/* Better told before hours of rendering than after. */
static bool can_write(const FrameWork *work)
{
	const char *slash = strrchr(work->path, '/');
	char *folder = slash ? strndup(work->path, (size_t)(slash - work->path + 1)) : strdup(".");
	bool good = strcmp(work->path, "-") == 0 || access(folder, W_OK) == 0;
	if (!good)
		diag_fail(work->job->diag,
			  "%s: cannot be written: no such folder, or no right to write there",
			  work->path);
	free(folder);
	return good;
}

/* +C leaves alone what an earlier run has finished. */
static bool is_finished(const FrameWork *work)
{
	return work->job->options->resume && work->job->options->to_file &&
	       strcmp(work->path, "-") != 0 && access(work->path, F_OK) == 0 &&
	       access(work->state_path, F_OK) != 0;
}

static Status run_work(FrameWork *work)
{
	const Options *options = work->job->options;
	if (is_finished(work)) {
		diag_note(work->job->diag, "%s is there already", work->path);
		return STATUS_DONE;
	}
	if (options->to_file && !can_write(work))
		return STATUS_FAILED;
	if (!build_scene(work))
		return STATUS_FAILED;
	work->statistics.shapes = work->scene->shape_count;
	work->statistics.lights = work->scene->light_count;
	work->origin.settings = &work->scene->settings;
	return trace(work);
}

/* Of a picture that is not rendered whole; else all zero. */
static ImageRegion named_region(const FrameJob *job)
{
	const FilmRect *r = &job->region;
	bool whole = r->x0 <= 0 && r->y0 <= 0 && r->x1 == job->options->width &&
		     r->y1 == job->options->height;
	return whole ? (ImageRegion){0}
		     : (ImageRegion){r->x0, r->y0, r->x1 > r->x0 ? r->x1 : r->x0,
				     r->y1 > r->y0 ? r->y1 : r->y0};
}

Status frame_render(const FrameJob *job, FrameStatistics *sum)
{
	const Options *options = job->options;
	double start = clock_cpu();
	FrameWork work = {.job = job, .path = output_path(options, job->animation, job->frame)};
	work.state_path = arena_printf(options->arena, "%s.state", work.path);
	work.key = resume_key(job);
	work.line = progress_line(!options->verbose_said || options->verbose);
	work.origin = (OutputOrigin){.scene = options->input,
				     .switches = job->switches,
				     .seed = options->seed,
				     .region = named_region(job)};
	Status status = run_work(&work);
	film_destroy(work.film);
	scene_destroy(work.scene);
	work.statistics.frames = 1;
	work.statistics.cpu_seconds = clock_cpu() - start;
	statistics_add(sum, &work.statistics);
	return status;
}
