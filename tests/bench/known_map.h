/*
 * Photon maps whose map from emitter to floor is a given function: photons of a plane emitter, at
 * Halton's points of a square, land on the plane y = 0.
 */
#ifndef TESTS_BENCH_KNOWN_MAP_H
#define TESTS_BENCH_KNOWN_MAP_H

#include <stdlib.h>

#include "base/random.h"
#include "photon/map.h"

/* to: x and z of where the path from u, v lands. */
typedef void KnownWay(double u, double v, double to[2]);

typedef struct KnownMap {
	KnownWay *way;
	double low, side; /* the emitter's square: from low on, both ways */
} KnownMap;

/* count photons, Halton's points from number `first` + 1 on, of flux side^2 / count each; path
 * `path`. Not indexed. */
static inline PhotonMap *known_map_photons(const KnownMap *known, uint32_t count, uint64_t first)
{
	PhotonMap *map = photon_map_create();
	map->photons = calloc((size_t)count + 1, sizeof(Photon));
	map->lights = calloc(1, sizeof(PhotonLight));
	map->lights[0] = (PhotonLight){count, known->side * known->side, 2};
	map->light_count = 1;
	map->count = count;
	for (uint32_t i = 0; i < count; i++) {
		Photon *p = &map->photons[i];
		double u = random_halton(first + i + 1, 0) * known->side + known->low,
		       v = random_halton(first + i + 1, 1) * known->side + known->low, to[2];
		float flux = (float)(known->side * known->side / count);
		known->way(u, v, to);
		*p = (Photon){.position = {(float)to[0], 0, (float)to[1]},
			      .emitter = {(float)u, (float)v},
			      .edges = 2};
		photon_set_flux(p, rgb(flux, flux, flux));
		photon_set_direction(p, vec3(0, 1, 0));
		photon_set_normal(p, vec3(0, 1, 0));
	}
	return map;
}

/* The same, indexed. */
static inline PhotonMap *known_map_make(const KnownMap *known, uint32_t count, uint64_t first)
{
	PhotonMap *map = known_map_photons(known, count, first);
	photon_map_index(map, 0);
	return map;
}

/* GatherBsdf of a floor that shows what it receives. */
static inline Rgb known_map_white(void *data, Vec3 direction)
{
	(void)data;
	(void)direction;
	return rgb(1, 1, 1);
}

#endif
