/*
 * The photon stage and the picture: photons once and one picture (the usual), or progressive
 * passes, each with photons of its own and a smaller radius, whose pictures are averaged. How radii
 * shrink is a Reduction's affair (reduction.h).
 */
#ifndef RENDER_PASSES_H
#define RENDER_PASSES_H

#include "photon/relax.h"
#include "photon/trace.h"
#include "render/caustics.h"
#include "render/render.h"

/* What switches say beside the scene's photons { }. */
typedef struct PassOptions {
	const char *save_file, *load_file; /* photon maps; NULL: what the scene says */
	const char *landed_file; /* the map before relaxation goes there; NULL: nowhere */
	const Estimator *estimator; /* instead of the scene's and its objects'; NULL: theirs */
	int passes;                        /* 0: what the scene says */
} PassOptions;

typedef struct PassStatistics {
	RenderStatistics render;
	PhotonStatistics photons;
	RelaxStatistics relaxation; /* all zero: none */
	CausticTimes caustics;
	uint32_t passes;      /* finished, those of an earlier run included */
	double first_radius,
		radius; /* of the first and of the last progressive pass; 0: not progressive */
	bool has_photons;
} PassStatistics;

typedef struct PassJob {
	const Scene *scene;
	const RenderOptions *render;
	const PassOptions *options;
	const RenderCallbacks *callbacks; /* or NULL; progress counts all passes */
	Film *film; /* a film that holds some passes already (film_passes) is gone on with */
	Diag *diag;
} PassJob;

/* Sums; radii are the last frame's. */
void pass_statistics_add(PassStatistics *sum, const PassStatistics *part);

/* RENDER_FAILED is reported. With RENDER_STOPPED a progressive film holds the mean of the finished
 * passes. */
RenderStatus passes_render(const PassJob *job, PassStatistics *statistics);

#endif
