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

/* A coordinate of the Halton point of a path, shifted by the seed, in [0, 1). */
double photon_halton(const PhotonAim *aim, const PhotonTraceOptions *options, uint64_t path,
		     int dimension);

enum { PHOTON_EMISSIONS_MAX = 64 };

/* The emissions of an aim's paths from number `path` on, at most PHOTON_EMISSIONS_MAX of them: the
 * first coordinates of their Halton points. */
void photon_emissions(const Scene *scene, const PhotonAim *aim, const PhotonTraceOptions *options,
		      uint64_t path, int count, Emission *out);
/* Whether a ray meets the target's box. */
bool photon_aim_hits(const PhotonAim *aim, const Emission *emission);
/* Whether the light shines on the surface at all (light groups). */
bool photon_light_reaches(const Light *light, const Surface *surface);

#endif
