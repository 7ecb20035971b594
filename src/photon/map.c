#include "photon/map.h"

#include <math.h>
#include <stdlib.h>

#include "base/arena.h"
#include "base/median.h"

PhotonMap *photon_map_create(void)
{
	PhotonMap *map = memory_alloc(sizeof *map);
	*map = (PhotonMap){0};
	return map;
}

void photon_map_destroy(PhotonMap *map)
{
	if (!map)
		return;
	photon_tree_destroy(map->tree);
	free(map->photons);
	free(map->lights);
	free(map->constraints);
	free(map);
}

bool photon_map_on_plane(const PhotonMap *map, const Photon *photon)
{
	return photon->light < map->light_count &&
	       map->lights[photon->light].parameter_dimensions == 2;
}

/*
 * The spacing of photons on surfaces: with k of them in a disc of radius r there is one in pi r^2 /
 * k, and the side of that square is what is meant. The median over some photons, taken evenly, is
 * not moved by the few in the dense caustic's core or far out.
 */
static double median_spacing(const PhotonMap *map)
{
	enum { SAMPLES = 1000, NEIGHBORS = 8 };
	uint32_t samples = map->count < SAMPLES ? map->count : SAMPLES, found = 0;
	double all[SAMPLES];
	Neighbor near[NEIGHBORS + 8 * TREE_SLACK];
	for (uint32_t i = 0; i < samples; i++) {
		const float *p = map->photons[(uint64_t)i * map->count / samples].position;
		NearestQuery query = {{p[0], p[1], p[2]}, INFINITY, NEIGHBORS, NULL};
		int count = photon_tree_nearest(map->tree, &query, near);
		float r2 = photon_tree_farthest(near, count);
		if (count == NEIGHBORS && r2 > 0)
			all[found++] = sqrtf((float)M_PI * r2 / NEIGHBORS);
	}
	return found ? median(all, (int)found) : 0;
}

void photon_map_index(PhotonMap *map, float emitter_weight)
{
	photon_tree_destroy(map->tree);
	TreePoints points = {
		.count = map->count, .stride = sizeof(Photon), .emitter_weight = emitter_weight};
	if (map->count > 0)
		points.position = map->photons->position;
	if (map->count > 0 && emitter_weight > 0) {
		points.emitter = map->photons->emitter;
		points.light = &map->photons->light;
	}
	map->tree = photon_tree_create(&points);
	map->spacing = median_spacing(map);
}
