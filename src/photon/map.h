/*
 * The photon map: photons in path order, and the search tree over them. Photons stand in path order
 * (light, then path, then the order in which the path landed) before anything sorts them, so the
 * map is the same for any number of threads. Immutable after photon_map_index.
 */
#ifndef PHOTON_MAP_H
#define PHOTON_MAP_H

#include <stdbool.h>

#include "base/diag.h"
#include "photon/photon.h"
#include "photon/tree.h"

/* What a light sent out; shares scale the density of a light's photons. */
typedef struct PhotonLight {
	uint64_t paths;          /* emitted, those that hit nothing included */
	double parameter_area; /* of the part of the emitter's parameter space that was sampled:
				  plane area or solid angle */
	int parameter_dimensions; /* 2: on the plane; 3: on the sphere */
} PhotonLight;

/*
 * How relaxation under constraints let a photon move (SJ13 eq. 7): as it is pushed along the unit
 * vector u_b, by a share of that across it. v_b is freedom long and lies across u_b in the surface.
 */
typedef struct PhotonConstraint {
	float along[3]; /* u_b */
	float freedom;  /* 0..1 */
} PhotonConstraint;

typedef struct PhotonMap {
	Photon *photons;
	uint32_t count;
	PhotonLight *lights;
	int light_count;
	PhotonTree *tree;        /* NULL until photon_map_index */
	PhotonConstraint *constraints; /* of each photon; NULL: not relaxed under constraints */
	bool relaxed;            /* photons are no longer where they landed */
	double spacing; /* mean distance of neighbours on the surfaces, from the photons themselves;
			   0: unknown */
} PhotonMap;

/* Without photons; the caller destroys it. */
PhotonMap *photon_map_create(void);
void photon_map_destroy(PhotonMap *map); /* NULL is allowed */
/* Whether a photon's emitter coordinates are two on a plane. False: a direction, or not known. */
bool photon_map_on_plane(const PhotonMap *map, const Photon *photon);
/* Builds the tree. emitter_weight as in TreePoints; with 0 the tree is over positions alone, and
 * its queries know no emitter range (relaxation has trees of its own). Photons may be moved
 * (relaxation) and indexed again. */
void photon_map_index(PhotonMap *map, float emitter_weight);

/* PLY, binary little-endian, one vertex a photon, every field a named property, constraints too.
 * False on failure, reported. */
bool photon_map_write(const PhotonMap *map, const char *path, Diag *diag);
/* What that wrote, not indexed. NULL on failure, reported. */
PhotonMap *photon_map_read(const char *path, Diag *diag);

#endif
