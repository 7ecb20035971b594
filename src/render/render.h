/*
 * Rendering: the scene and the options in, a film out. The same scene, options and seed give the
 * same bits for any number of threads (parallel_set_threads).
 */
#ifndef RENDER_RENDER_H
#define RENDER_RENDER_H

#include <stdbool.h>
#include <stdint.h>

#include "render/film.h"
#include "scene/scene.h"

typedef struct Caustics Caustics; /* render/caustics.h */

typedef struct RenderOptions {
	FilmRect region;     /* what to render: +SC +SR +EC +ER; empty: all of the film */
	int quality;         /* +Q: 0..11 */
	bool antialias;      /* +A */
	int sampling_method; /* +AM: 1 or 2 */
	double threshold;    /* +An */
	int depth;           /* +R: 1..9 */
	double jitter;       /* +J: 0 (off) .. 1 */
	double gamma;        /* +AG */
	bool alpha;          /* +UA: keep what is seen of the background transparent */
	double place[2];     /* of a pixel's first sample, 0..1 from its left, upper corner */
	uint64_t seed;
	const Caustics *caustics; /* what photons brought; NULL: none */
	double progress_interval; /* seconds between calls of progress; 0: after every tile */
} RenderOptions;

/* POV-Ray's defaults: quality 9, no antialiasing; method 1, threshold 0.3, depth 3, jitter 1,
 * gamma 2.5; the first sample in the pixel's middle. */
RenderOptions render_options_default(void);

typedef struct RenderProgress {
	double share;     /* of the work, 0..1 */
	long pixels;      /* finished or seen once */
	double seconds;   /* since the start */
	double rate;      /* pixels a second */
	double remaining; /* seconds, estimated; negative while unknown */
} RenderProgress;

/* All optional. progress is called by one thread at a time while others go on; it may take a
 * film_snapshot. */
typedef struct RenderCallbacks {
	void (*progress)(void *data, const RenderProgress *progress);
	void *data;
	const volatile int *stop; /* the render ends soon after this becomes nonzero (a signal
				     handler may set it) */
} RenderCallbacks;

typedef struct RenderStatistics {
	uint64_t pixels, samples;
	uint64_t eye_rays, shadow_rays, reflected_rays, refracted_rays, transmitted_rays;
	uint64_t bailouts;     /* rays cut off by adc_bailout or max_trace_level */
	int deepest;           /* trace level reached */
	double seconds, cpu_seconds;
} RenderStatistics;

typedef enum RenderStatus { RENDER_DONE, RENDER_STOPPED, RENDER_FAILED } RenderStatus;

void render_statistics_add(RenderStatistics *sum, const RenderStatistics *part);

/* Fills the film; pixels that are final already (a resumed render) stay. callbacks and statistics
 * may be NULL. */
RenderStatus render_image(const Scene *scene, const RenderOptions *options, Film *film,
                          const RenderCallbacks *callbacks, RenderStatistics *statistics);

#endif
