/*
 * Relaxation: photons push each other apart until noise is gone from where they lie, and less
 * bandwidth is needed to estimate their density. Plain (Spencer & Jones 2009), or under
 * constraints that keep the caustic's structure, found among photons that left the light together
 * (Spencer & Jones 2013: SJ13).
 *
 * Only positions change: flux, count and order of the photons stay. Photons stay on the object,
 * and on the side of it, where they landed. The caller owns the map and indexes it again
 * afterwards.
 */
#ifndef PHOTON_RELAX_H
#define PHOTON_RELAX_H

#include <stdbool.h>
#include <stdint.h>

#include "base/vec.h"
#include "photon/map.h"
#include "scene/photon_settings.h"

typedef struct Scene Scene; /* scene/scene.h */

/* A place on a surface: what a moved photon asks for. */
typedef struct RelaxPlace {
	uint16_t object; /* as in Photon */
	Vec3 position, normal;
} RelaxPlace;

/*
 * Moves the place onto the surface of its object nearby and settles its normal; step is how far it
 * came from where the photon was. False when there is no such surface: past an edge. Called from
 * several threads.
 */
typedef bool RelaxProject(void *data, RelaxPlace *place, double step);

/* What relaxation knows of the surfaces that photons lie on, and who may stop it there. */
typedef struct RelaxSurfaces {
	const bool *fixed;     /* by Photon.object: photons on it stay. NULL: none */
	int fixed_count;
	RelaxProject *project; /* NULL: surfaces are flat and have no edges but the light's */
	void *data;
	const volatile int *stop; /* relaxation ends soon after this becomes nonzero; NULL: never */
} RelaxSurfaces;

typedef struct RelaxStatistics {
	uint64_t moved;          /* photons that took part */
	uint64_t iterations;
	double feature_seconds;  /* constraints, trees included */
	double seconds;          /* iterations, trees included */
	double mean_movement;    /* between a photon's first and last place, scene units */
	double mean_constraint; /* length of v_b: 1 moves freely, 0 not at all across the feature;
				   plain: 1 */
} RelaxStatistics;

/* Sums; means over all photons that moved. */
void relax_statistics_add(RelaxStatistics *sum, const RelaxStatistics *part);

/*
 * Moves the photons; the tree of the map is dropped. Constrained, map->constraints is filled in.
 * False when nothing is moved: switched off, no photons, or stopped, when the photons are as they
 * were. statistics may be NULL.
 */
bool photon_relax(PhotonMap *map, const Relaxation *settings, const RelaxSurfaces *surfaces,
		  RelaxStatistics *statistics);

/* Bytes a photon that this takes at most, the map's own among them. */
double photon_relax_room(const Relaxation *settings);

/* The same with a scene's settings, surfaces and `relaxation off` objects; stop as there. */
bool photon_relax_scene(PhotonMap *map, const Scene *scene, const volatile int *stop,
			RelaxStatistics *statistics);

#endif
