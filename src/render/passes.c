#include "render/passes.h"

#include <math.h>

#include "base/clock.h"
#include "base/random.h"
#include "render/reduction.h"

typedef struct Passes {
	const PassJob *job;
	const PhotonSettings *settings;
	Progressive progressive;
	const ReductionMethod *reduction;
	PassStatistics *statistics;
	RenderOptions render;
	RenderCallbacks callbacks;
	uint64_t seed;       /* the photons'; render.seed is the eye rays' of this pass */
	uint32_t pass;
	double start, share_before, share; /* of the whole work: done, and in this pass */
} Passes;

static bool is_stopped(const Passes *passes)
{
	return passes->callbacks.stop && *passes->callbacks.stop;
}

void pass_statistics_add(PassStatistics *sum, const PassStatistics *part)
{
	render_statistics_add(&sum->render, &part->render);
	photon_statistics_add(&sum->photons, &part->photons);
	relax_statistics_add(&sum->relaxation, &part->relaxation);
	sum->caustics.index += part->caustics.index;
	sum->caustics.estimators += part->caustics.estimators;
	sum->passes += part->passes;
	sum->first_radius = part->first_radius;
	sum->radius = part->radius;
	sum->has_photons = sum->has_photons || part->has_photons;
}

/* ---- photons ---- */

/* NULL: stopped, or refused, reported. */
static PhotonMap *trace_photons(Passes *passes)
{
	PhotonTraceOptions options = {
		.seed = passes->seed,
		.pass = passes->pass,
		.scale = 1,
		.stop = passes->callbacks.stop,
		.diag = passes->job->diag,
	};
	PhotonStatistics statistics;
	PhotonMap *map = photon_trace(passes->job->scene, &options, &statistics);
	if (!map)
		return NULL;
	photon_statistics_add(&passes->statistics->photons, &statistics);
	return map;
}

/* False: stopped. */
static bool relax_photons(Passes *passes, PhotonMap *map)
{
	RelaxStatistics statistics;
	if (!map->relaxed && photon_relax_scene(map, passes->job->scene, passes->callbacks.stop,
						&statistics))
		relax_statistics_add(&passes->statistics->relaxation, &statistics);
	return !is_stopped(passes);
}

/* False on failure, reported. */
static bool save_photons(const Passes *passes, const PhotonMap *map, const char *path)
{
	return !path || photon_map_write(map, path, passes->job->diag);
}

/* False, reported, when photons are asked for as they landed and are there only as relaxed. */
static bool can_tell_landed(const Passes *passes, const PhotonMap *map, const char *load)
{
	if (!passes->job->options->landed_file || !map->relaxed)
		return true;
	diag_fail(passes->job->diag, "the photons in '%s' are no longer where they landed", load);
	return false;
}

/* Of a pass without photons. */
static RenderStatus status_of_none(const Passes *passes)
{
	return is_stopped(passes) ? RENDER_STOPPED : RENDER_FAILED;
}

/* From a file or from the lights; NULL with *status set. */
static PhotonMap *get_photons(Passes *passes, RenderStatus *status)
{
	const PassOptions *options = passes->job->options;
	const char *load = options->load_file ? options->load_file : passes->settings->load_file;
	const char *save = options->save_file ? options->save_file : passes->settings->save_file;
	PhotonMap *map = load ? photon_map_read(load, passes->job->diag) : trace_photons(passes);
	*status = map ? RENDER_DONE : load ? RENDER_FAILED : status_of_none(passes);
	if (map && load)
		passes->statistics->photons.stored = map->count;
	if (!map)
		return NULL;
	if (can_tell_landed(passes, map, load) &&
	    save_photons(passes, map, options->landed_file) && relax_photons(passes, map) &&
	    save_photons(passes, map, save))
		return map;
	photon_map_destroy(map);
	*status = status_of_none(passes);
	return NULL;
}

/* ---- one pass ---- */

static RenderStatus render_with(Passes *passes, PhotonMap *map, double radius, Film *film)
{
	CausticOptions options = {passes->job->options->estimator, radius,
				  passes->callbacks.stop};
	Caustics *caustics = caustics_create(passes->job->scene, map, &options,
					     &passes->statistics->caustics, passes->job->diag);
	RenderStatistics statistics;
	if (!caustics)
		return status_of_none(passes);
	passes->render.caustics = caustics;
	RenderStatus status = render_image(passes->job->scene, &passes->render, film,
					   &passes->callbacks, &statistics);
	passes->render.caustics = NULL;
	caustics_destroy(caustics);
	render_statistics_add(&passes->statistics->render, &statistics);
	return status;
}

static RenderStatus render_once(Passes *passes)
{
	RenderStatus status;
	PhotonMap *map = get_photons(passes, &status);
	if (!map)
		return status;
	passes->statistics->passes = 1;
	film_add_photons(passes->job->film, map->count);
	return render_with(passes, map, 0, passes->job->film);
}

/* ---- progressive ---- */

/* Wide enough for this many photons of the first pass at their median density. */
static const double FIRST_PASS_PHOTONS = 50;

static double first_radius(Passes *passes, PhotonMap *map)
{
	if (passes->progressive.radius > 0)
		return passes->progressive.radius;
	if (map->spacing == 0)
		photon_map_index(map, 0);
	return map->spacing * sqrt(FIRST_PASS_PHOTONS / M_PI);
}

/* A resumed render has lost its first pass' photons: they are traced again for their spacing. */
static RenderStatus settle_radius(Passes *passes)
{
	PassStatistics *statistics = passes->statistics;
	uint32_t pass = passes->pass;
	if (passes->progressive.radius <= 0) {
		passes->pass = 0;
		PhotonStatistics kept = statistics->photons;
		PhotonMap *map = trace_photons(passes);
		statistics->photons = kept;
		passes->pass = pass;
		if (!map)
			return status_of_none(passes);
		passes->progressive.radius = first_radius(passes, map);
		photon_map_destroy(map);
	}
	statistics->first_radius = passes->progressive.radius;
	return RENDER_DONE;
}

/* A fresh pass of its own random numbers, for the eye's rays as well. */
static uint64_t seed_of_pass(uint64_t seed, uint32_t pass)
{
	return pass == 0 ? seed : random_bits(seed, pass, 0);
}

/*
 * Each pass looks through another place in the pixels, so that the mean is over them and not over
 * their middles only: of a fold, light along a line, that would be no picture. The first pass looks
 * through the middle, the others where an additive recurrence over the plastic number leads, which
 * fills a square evenly (Roberts 2018). +J scales it as it does antialiasing.
 */
static void settle_place(Passes *passes)
{
	static const double step[2] = {0.7548776662466927, 0.5698402909980532};
	for (int axis = 0; axis < 2; axis++) {
		double place = fmod(0.5 + passes->pass * step[axis], 1);
		passes->render.place[axis] = 0.5 + (place - 0.5) * passes->job->render->jitter;
	}
}

static double radius_of_pass(const Passes *passes, uint32_t pass)
{
	return passes->reduction->radius(passes->progressive.radius, pass);
}

static RenderStatus render_pass(Passes *passes, Film *film)
{
	passes->render.seed = seed_of_pass(passes->seed, passes->pass);
	settle_place(passes);
	PhotonMap *map = trace_photons(passes);
	if (!map || !relax_photons(passes, map)) {
		photon_map_destroy(map);
		return status_of_none(passes);
	}
	film_add_photons(film, map->count);
	double radius = radius_of_pass(passes, passes->pass);
	RenderStatus status = render_with(passes, map, radius, film);
	if (status == RENDER_DONE)
		passes->statistics->radius = radius;
	return status;
}

static bool wants_more(const Passes *passes)
{
	const Progressive *p = &passes->progressive;
	bool in_time = p->seconds <= 0 || clock_wall() - passes->start < p->seconds;
	return (p->passes <= 0 || passes->pass < (uint32_t)p->passes) && in_time;
}

static void forward_progress(void *data, const RenderProgress *progress)
{
	Passes *passes = data;
	RenderProgress all = *progress;
	all.seconds = clock_wall() - passes->start;
	all.share = passes->share_before + passes->share * progress->share;
	all.remaining = all.share > 0 ? all.seconds / all.share * (1 - all.share) : -1;
	passes->job->callbacks->progress(passes->job->callbacks->data, &all);
}

static void settle_shares(Passes *passes)
{
	const Progressive *p = &passes->progressive;
	double elapsed = clock_wall() - passes->start;
	double done = p->passes > 0 ? (double)passes->pass / p->passes : 0;
	if (p->seconds > 0)
		done = fmax(done, fmin(elapsed / p->seconds, 1));
	passes->share_before = done;
	passes->share = p->passes > 0 ? 1.0 / p->passes : 0;
}

static RenderStatus render_progressive(Passes *passes)
{
	Film *film = passes->job->film;
	passes->pass = film_passes(film);
	RenderStatus status = settle_radius(passes);
	if (passes->pass > 0)
		passes->statistics->radius = radius_of_pass(passes, passes->pass - 1);
	while (status == RENDER_DONE && wants_more(passes)) {
		Film *one = film_create_like(film);
		settle_shares(passes);
		status = render_pass(passes, one);
		if (status == RENDER_DONE) {
			film_average(film, one);
			film_add_photons(film, film_photons(one));
			passes->pass++;
		}
		film_destroy(one);
	}
	passes->statistics->passes = passes->pass;
	return is_stopped(passes) ? RENDER_STOPPED : status;
}

/* ---- the whole ---- */

/* Without a photons { } the switches ask for nothing either. */
static bool wants_photons(const Passes *passes)
{
	return passes->settings->on || passes->job->options->load_file;
}

static void settle_progressive(Passes *passes)
{
	passes->progressive = passes->settings->progressive;
	if (passes->job->options->passes > 0) {
		passes->progressive.on = true;
		passes->progressive.passes = passes->job->options->passes;
	}
	passes->reduction = reduction_find(passes->progressive.reduction);
	if (passes->progressive.passes <= 0 && passes->progressive.seconds <= 0)
		passes->progressive.passes = 1;
}

/* False, reported, when switches name files of photons that this render cannot have. What the scene
 * itself names is left alone by progressive passes. */
static bool check_files(const Passes *passes)
{
	const PassOptions *options = passes->job->options;
	bool writes = options->save_file || options->landed_file;
	if (writes && !wants_photons(passes)) {
		diag_fail(passes->job->diag,
			  "the scene asks for no photons: there are none to write");
		return false;
	}
	if (passes->progressive.on && (writes || options->load_file)) {
		diag_fail(passes->job->diag,
			  "progressive passes have photons of their own: none are read or written");
		return false;
	}
	if (passes->progressive.on && (passes->settings->save_file || passes->settings->load_file))
		diag_note(passes->job->diag,
			  "progressive passes leave save_file and load_file alone");
	return true;
}

static RenderStatus run(Passes *passes)
{
	const PassJob *job = passes->job;
	settle_progressive(passes);
	if (!check_files(passes))
		return RENDER_FAILED;
	if (!wants_photons(passes))
		return render_image(job->scene, &passes->render, job->film, &passes->callbacks,
				    &passes->statistics->render);
	if (!caustics_check(job->scene, job->options->estimator, job->diag))
		return RENDER_FAILED;
	passes->statistics->has_photons = true;
	if (!passes->progressive.on)
		return render_once(passes);
	if (!passes->reduction) {
		diag_fail(job->diag, "progressive: this reduction is not built yet");
		return RENDER_FAILED;
	}
	return render_progressive(passes);
}

RenderStatus passes_render(const PassJob *job, PassStatistics *statistics)
{
	double cpu = clock_cpu();
	Passes passes = {
		.job = job,
		.settings = &job->scene->settings.photons,
		.statistics = statistics,
		.render = *job->render,
		.seed = job->render->seed,
		.start = clock_wall(),
		.share = 1,
	};
	*statistics = (PassStatistics){.passes = 0};
	if (job->callbacks) {
		passes.callbacks = (RenderCallbacks){.stop = job->callbacks->stop, .data = &passes};
		if (job->callbacks->progress)
			passes.callbacks.progress = forward_progress;
	}
	RenderStatus status = run(&passes);
	statistics->render.seconds = clock_wall() - passes.start;
	statistics->render.cpu_seconds = clock_cpu() - cpu;
	return status;
}
