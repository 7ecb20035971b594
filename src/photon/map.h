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

typedef struct PhotonMap {
	Photon *photons;
	uint32_t count;
	PhotonLight *lights;
	int light_count;
	PhotonTree *tree;        /* NULL until photon_map_index */
	float *constraint; /* of each photon, in [0, 1]: how freely relaxation let it move across
			    * the feature it lies on (length of v_b, SJ13 eq. 7); NULL: not relaxed
			    * under constraints */
	double spacing; /* mean distance of neighbours on the surfaces, from the photons themselves;
			   0: unknown */
} PhotonMap;

PhotonMap *photon_map_create(void);
void photon_map_destroy(PhotonMap *map); /* NULL is allowed */
/* Builds the tree. emitter_weight as in TreePoints. Photons may be moved (relaxation) and indexed
 * again. */
void photon_map_index(PhotonMap *map, float emitter_weight);

/* PLY, binary little-endian, one vertex a photon, every field a named property. False on failure,
 * reported. */
bool photon_map_write(const PhotonMap *map, const char *path, Diag *diag);
PhotonMap *photon_map_read(const char *path, Diag *diag);

#endif
