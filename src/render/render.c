/*
 * The image is cut into square tiles that threads take in order. Without super-sampling, and with
 * method 2, one pass makes final pixels. Method 1 needs the neighbours' first samples: a first pass
 * gives every pixel one, a second replaces those that differ. Tiles are independent and every
 * sample's random numbers come from its own number: threads change nothing but time.
 */
#include "render/render.h"

#include <stdatomic.h>
#include <stdlib.h>

#include "base/clock.h"
#include "base/parallel.h"
#include "render/antialias.h"

enum { TILE = 32 };

typedef struct Render Render;

typedef struct Worker {
	Tracer tracer;
	CornerGrid *corners; /* method 2 only */
	FilmPixel pixels[TILE * TILE];
} Worker;

/* One way over the image. */
typedef struct Pass {
	FilmRect region;
	void (*pixel)(const Render *render, Worker *worker, int x, int y, FilmPixel *out);
	bool (*needed)(const Render *render, int x, int y);
	double share; /* of the whole work, estimated */
} Pass;

struct Render {
	const RenderOptions *options;
	const RenderCallbacks *callbacks; /* or NULL */
	Film *film;
	Film *first;  /* first samples, when a second pass compares them; else NULL */
	FilmRect region;
	Pass pass;
	bool final;   /* this pass makes final pixels */
	bool first_hit;
	Worker *workers;
	int worker_count;
	double start, share_done;
	atomic_long pixels, tiles;
	atomic_flag reporting;
	double last_report; /* guarded by reporting */
};

RenderOptions render_options_default(void)
{
	return (RenderOptions){
		.quality = 9,
		.sampling_method = 1,
		.threshold = 0.3,
		.depth = 3,
		.jitter = 1,
		.gamma = 2.5,
		.place = {0.5, 0.5},
		.progress_interval = 0.5,
	};
}

static bool is_stopped(const Render *render)
{
	return render->callbacks && render->callbacks->stop && *render->callbacks->stop;
}

/* ---- pixels ---- */

static AntialiasPixel pixel_at(const Render *render, Worker *worker, int x, int y)
{
	return (AntialiasPixel){&worker->tracer,  render->options, render->film, x, y,
				render->first_hit};
}

static void pixel_first(const Render *render, Worker *worker, int x, int y, FilmPixel *out)
{
	AntialiasPixel pixel = pixel_at(render, worker, x, y);
	antialias_first(&pixel, out);
}

static void pixel_recursive(const Render *render, Worker *worker, int x, int y, FilmPixel *out)
{
	AntialiasPixel pixel = pixel_at(render, worker, x, y);
	antialias_recursive(&pixel, worker->corners, out);
}

static bool differs_from(const Render *render, const FilmPixel *own, int x, int y)
{
	if (x < 0 || y < 0 || x >= film_width(render->film) || y >= film_height(render->film))
		return false;
	FilmPixel other;
	film_read(render->first, x, y, &other);
	return antialias_differ(render->options, own, &other);
}

static void pixel_compared(const Render *render, Worker *worker, int x, int y, FilmPixel *out)
{
	FilmPixel own;
	film_read(render->first, x, y, &own);
	*out = own;
	AntialiasPixel pixel = pixel_at(render, worker, x, y);
	if (render->options->threshold <= 0 || differs_from(render, &own, x - 1, y) ||
	    differs_from(render, &own, x + 1, y) || differs_from(render, &own, x, y - 1) ||
	    differs_from(render, &own, x, y + 1))
		antialias_grid(&pixel, &own, out);
}

static bool is_unfinished(const Render *render, int x, int y)
{
	bool inside = x >= render->region.x0 && x < render->region.x1 && y >= render->region.y0 &&
		      y < render->region.y1;
	return inside && !film_is_final(render->film, x, y);
}

/* A first sample is needed for the pixel itself and for its neighbours to compare with. */
static bool is_first_needed(const Render *render, int x, int y)
{
	return is_unfinished(render, x, y) || is_unfinished(render, x - 1, y) ||
	       is_unfinished(render, x + 1, y) || is_unfinished(render, x, y - 1) ||
	       is_unfinished(render, x, y + 1);
}

/* ---- progress ---- */

static int tiles_across(FilmRect region)
{
	return (region.x1 - region.x0 + TILE - 1) / TILE;
}

static int tiles_down(FilmRect region)
{
	return (region.y1 - region.y0 + TILE - 1) / TILE;
}

static void report(Render *render)
{
	double seconds = clock_wall() - render->start;
	double tiles = (double)tiles_across(render->pass.region) * tiles_down(render->pass.region);
	double share = render->share_done + render->pass.share * (double)render->tiles / tiles;
	RenderProgress progress = {
		.share = share, .pixels = render->pixels, .seconds = seconds,
		.rate = seconds > 0 ? (double)render->pixels / seconds : 0,
		.remaining = share > 0 ? seconds / share * (1 - share) : -1,
	};
	render->callbacks->progress(render->callbacks->data, &progress);
	render->last_report = clock_wall();
}

static void maybe_report(Render *render)
{
	if (!render->callbacks || !render->callbacks->progress ||
	    atomic_flag_test_and_set(&render->reporting))
		return;
	if (clock_wall() - render->last_report >= render->options->progress_interval)
		report(render);
	atomic_flag_clear(&render->reporting);
}

/* ---- tiles ---- */

/* Puts the runs of a row's pixels that are wanted into a film; the others stay as they are. row[0]
 * is the pixel at x0. */
static void commit_runs(const Render *render, Film *film, FilmRect span, const FilmPixel *row,
                        bool (*wanted)(const Render *render, int x, int y))
{
	for (int x = span.x0; x < span.x1;) {
		int end = x;
		while (end < span.x1 && wanted(render, end, span.y0))
			end++;
		if (end > x)
			film_commit(film, (FilmRect){x, span.y0, end, span.y1}, row + (x - span.x0),
				    render->final);
		x = end + 1;
	}
}

static void commit_row(const Render *render, FilmRect span, const FilmPixel *row)
{
	if (render->first && !render->final)
		commit_runs(render, render->first, span, row, is_first_needed);
	commit_runs(render, render->film, span, row, is_unfinished);
}

static bool render_rows(Render *render, Worker *worker, FilmRect tile)
{
	for (int y = tile.y0; y < tile.y1; y++) {
		FilmPixel *row = worker->pixels + (y - tile.y0) * TILE;
		if (is_stopped(render))
			return false;
		for (int x = tile.x0; x < tile.x1; x++) {
			if (!render->pass.needed(render, x, y))
				continue;
			render->pass.pixel(render, worker, x, y, &row[x - tile.x0]);
		}
	}
	return true;
}

static void render_tile(void *data, long item, int thread)
{
	Render *render = data;
	Worker *worker = &render->workers[thread];
	FilmRect region = render->pass.region;
	int across = tiles_across(region);
	int x0 = region.x0 + (int)(item % across) * TILE,
	    y0 = region.y0 + (int)(item / across) * TILE;
	FilmRect tile = {x0, y0, x0 + TILE < region.x1 ? x0 + TILE : region.x1,
	                 y0 + TILE < region.y1 ? y0 + TILE : region.y1};
	if (worker->corners)
		corner_grid_start_tile(worker->corners, x0, y0);
	if (is_stopped(render) || !render_rows(render, worker, tile))
		return;
	for (int y = tile.y0; y < tile.y1; y++)
		commit_row(render, (FilmRect){tile.x0, y, tile.x1, y + 1},
			   worker->pixels + (y - tile.y0) * TILE);
	atomic_fetch_add(&render->tiles, 1);
	if (!render->first || !render->final)
		atomic_fetch_add(&render->pixels, (long)(tile.x1 - tile.x0) * (tile.y1 - tile.y0));
	maybe_report(render);
}

static bool run_pass(Render *render, const Pass *pass, bool final)
{
	render->pass = *pass;
	render->final = final;
	render->tiles = 0;
	parallel_for((long)tiles_across(pass->region) * tiles_down(pass->region), 1, render_tile,
		     render);
	render->share_done += pass->share;
	return !is_stopped(render);
}

/* ---- the whole ---- */

static bool run_passes(Render *render)
{
	const RenderOptions *options = render->options;
	FilmRect region = render->region;
	if (options->antialias && options->sampling_method == 1) {
		FilmRect around = {region.x0 - (region.x0 > 0), region.y0 - (region.y0 > 0),
		                   region.x1 + (region.x1 < film_width(render->film)),
		                   region.y1 + (region.y1 < film_height(render->film))};
		Pass first = {around, pixel_first, is_first_needed, 0.4};
		Pass second = {region, pixel_compared, is_unfinished, 0.6};
		return run_pass(render, &first, false) && run_pass(render, &second, true);
	}
	Pass only = {region, options->antialias ? pixel_recursive : pixel_first, is_unfinished, 1};
	return run_pass(render, &only, true);
}

void render_statistics_add(RenderStatistics *sum, const RenderStatistics *part)
{
	sum->pixels += part->pixels;
	sum->samples += part->samples;
	sum->eye_rays += part->eye_rays;
	sum->shadow_rays += part->shadow_rays;
	sum->reflected_rays += part->reflected_rays;
	sum->refracted_rays += part->refracted_rays;
	sum->transmitted_rays += part->transmitted_rays;
	sum->bailouts += part->bailouts;
	if (part->deepest > sum->deepest)
		sum->deepest = part->deepest;
}

/* From two neighbouring rays in the middle of the picture; antialiased, a sample stands for less
 * than a pixel. */
static void set_sample_size(const Render *render, Tracer *tracer)
{
	int width = film_width(render->film), height = film_height(render->film);
	int finer = render->options->antialias && render->options->depth > 0
			    ? render->options->depth
			    : 1;
	const Camera *camera = &tracer->scene->camera;
	Ray a, b;
	Vec2 pinhole = {0.5, 0.5};
	if (!camera_ray(camera, 0.5 * width, 0.5 * height, width, height, pinhole, &a) ||
	    !camera_ray(camera, 0.5 * width + 1, 0.5 * height, width, height, pinhole, &b))
		return;
	tracer->sample_width = vec3_distance(a.origin, b.origin) / finer;
	tracer->sample_spread = vec3_distance(a.direction, b.direction) / finer;
	tracer->sample_across = vec3_add(vec3_sub(b.origin, a.origin),
					 vec3_sub(b.direction, a.direction));
}

static void create_workers(Render *render, const Scene *scene)
{
	const RenderOptions *options = render->options;
	render->worker_count = parallel_threads();
	render->workers = memory_alloc(sizeof *render->workers * (size_t)render->worker_count);
	for (int i = 0; i < render->worker_count; i++) {
		Worker *worker = &render->workers[i];
		tracer_init(&worker->tracer, scene, options);
		set_sample_size(render, &worker->tracer);
		bool recursive = options->antialias && options->sampling_method == 2;
		worker->corners = recursive ? corner_grid_create(options->depth, TILE) : NULL;
	}
}

static void destroy_workers(Render *render, RenderStatistics *statistics)
{
	for (int i = 0; i < render->worker_count; i++) {
		render_statistics_add(statistics, &render->workers[i].tracer.statistics);
		tracer_free(&render->workers[i].tracer);
		corner_grid_destroy(render->workers[i].corners);
	}
	free(render->workers);
}

static FilmRect clip_region(FilmRect region, const Film *film)
{
	FilmRect whole = {0, 0, film_width(film), film_height(film)};
	if (region.x0 >= region.x1 || region.y0 >= region.y1)
		return whole;
	return (FilmRect){region.x0 > 0 ? region.x0 : 0, region.y0 > 0 ? region.y0 : 0,
			  region.x1 < whole.x1 ? region.x1 : whole.x1,
			  region.y1 < whole.y1 ? region.y1 : whole.y1};
}

static unsigned film_layers(const Film *film)
{
	unsigned layers = 0;
	for (int i = 0; i < FILM_LAYER_COUNT; i++)
		layers |= (unsigned)film_has(film, i) << i;
	return layers;
}

RenderStatus render_image(const Scene *scene, const RenderOptions *options, Film *film,
                          const RenderCallbacks *callbacks, RenderStatistics *statistics)
{
	double cpu = clock_cpu();
	Render render = {
		.options = options,
		.callbacks = callbacks,
		.film = film,
		.region = clip_region(options->region, film),
		.start = clock_wall(),
		.reporting = ATOMIC_FLAG_INIT,
		.first_hit = film_has(film, FILM_ALBEDO) || film_has(film, FILM_NORMAL) ||
			     film_has(film, FILM_DEPTH) || film_has(film, FILM_PHOTON_COUNT),
	};
	RenderStatistics sum = {0};
	if (options->antialias && options->sampling_method == 1)
		render.first = film_create(film_width(film), film_height(film), film_layers(film));
	create_workers(&render, scene);
	bool done = run_passes(&render);
	destroy_workers(&render, &sum);
	film_destroy(render.first);
	sum.pixels = (uint64_t)render.pixels;
	sum.seconds = clock_wall() - render.start;
	sum.cpu_seconds = clock_cpu() - cpu;
	if (statistics)
		*statistics = sum;
	return done ? RENDER_DONE : RENDER_STOPPED;
}
