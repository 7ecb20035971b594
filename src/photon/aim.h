/*
 * What photons are aimed at: for each light and each target object, a ball around it, how many
 * paths go there, and where they start in the low-discrepancy sequence.
 */
#ifndef PHOTON_AIM_H
#define PHOTON_AIM_H

#include "base/arena.h"
#include "light/emission.h"
#include "photon/trace.h"
#include "scene/inside.h"
#include "scene/scene.h"

/* Coordinates of a path's Halton point: those of its emission come first (light/emission.h). */
enum { AIM_EMISSION_DIMENSIONS = 4, AIM_DIMENSIONS = 8 };

typedef struct PhotonAim {
	int light;         /* number of the scene's light */
	int target;        /* Surface.id */
	EmissionAim ball;
	EmissionRegion region; /* of the light's own position */
	double shift[AIM_DIMENSIONS]; /* of the Halton points, by the seed */
	Box3 box;          /* paths that miss it are counted but not followed */
	bool tight;        /* the target fills the ball: none misses the box */
	uint64_t paths;    /* of this pass */
	uint64_t first;    /* number of its first path among all of the pass */
	InsideStack inside; /* what the light stands in */
	bool passes;       /* some object lets photons pass on the way to their target */
} PhotonAim;

typedef struct PhotonAims {
	PhotonAim *aims;
	int count;
	uint64_t paths;    /* of all */
} PhotonAims;

/* In the arena. Unbounded targets are left out. */
PhotonAims photon_aims(const Scene *scene, const PhotonTraceOptions *options, Arena *arena);

enum { PHOTON_STARTS_MAX = EMISSION_RUN_MAX };

/* Where some paths start: emissions, made of the first coordinates of their Halton points, and the
 * later coordinates, by dimension, as far as they have been asked for. */
typedef struct PhotonStarts {
	Emission emissions[PHOTON_STARTS_MAX];
	double later[AIM_DIMENSIONS][PHOTON_STARTS_MAX];
	bool filled[AIM_DIMENSIONS];
	const PhotonAim *aim;
	uint64_t index; /* of the first path's Halton point */
	int count;
} PhotonStarts;

/* The starts of an aim's paths from number `path` on, at most PHOTON_STARTS_MAX of them. */
void photon_starts(const Scene *scene, const PhotonAim *aim, const PhotonTraceOptions *options,
		   uint64_t path, int count, PhotonStarts *out);
/* A later coordinate of a start's Halton point, shifted by the seed, in [0, 1); the starts remember
 * it for their other paths. */
double photon_start_number(PhotonStarts *starts, int start, int dimension);
/* Whether a ray meets the target's box. */
bool photon_aim_hits(const PhotonAim *aim, const Emission *emission);

#endif
