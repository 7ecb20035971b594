#include "photon/relax_forest.h"

#include <math.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

#include "base/arena.h"
#include "photon/group.h"

enum { KEYS = UINT16_MAX + 1 };

struct RelaxForest {
	const RelaxSet *set;
	RelaxSpace space;
	uint32_t starts[KEYS + 1]; /* of each key's points among the members */
	uint32_t *members;         /* the set's points by key, in their order */
	PhotonTree *trees[KEYS];
};

static uint16_t key_of(const RelaxForest *forest, uint32_t point)
{
	const RelaxPoint *p = &forest->set->points[point];
	return forest->space == RELAX_WORLD ? p->object : p->sheet;
}

static void sort_members(RelaxForest *forest)
{
	uint32_t count = forest->set->count, at = 0;
	uint64_t *keys = memory_alloc(sizeof *keys * ((size_t)count + 1));
	for (uint32_t i = 0; i < count; i++)
		keys[i] = key_of(forest, i);
	photon_group(keys, count, forest->members);
	free(keys);
	for (uint32_t key = 0; key <= KEYS; key++) {
		while (at < count && key_of(forest, forest->members[at]) < key)
			at++;
		forest->starts[key] = at;
	}
}

typedef struct Place {
	float position[3], emitter[3];
	uint16_t light;
} Place;

static Place *make_places(const RelaxForest *forest)
{
	const RelaxSet *set = forest->set;
	Place *places = memory_alloc(sizeof *places * ((size_t)set->count + 1));
	for (uint32_t i = 0; i < set->count; i++) {
		const RelaxPoint *p = &set->points[forest->members[i]];
		memcpy(places[i].position,
		       forest->space == RELAX_EMITTER ? p->emitter : p->position,
		       sizeof places[i].position);
		memcpy(places[i].emitter, p->emitter, sizeof places[i].emitter);
		places[i].light = 0;
	}
	return places;
}

/* Square sum of how far coordinates are from their means; offset: of the floats in a Place. */
static double spread_of(const Place *places, uint32_t count, size_t offset)
{
	double sum[3] = {0, 0, 0}, squares = 0;
	for (uint32_t i = 0; i < count; i++)
		for (int k = 0; k < 3; k++)
			sum[k] += (double)((const float *)((const char *)&places[i] + offset))[k];
	for (uint32_t i = 0; i < count; i++) {
		const float *at = (const float *)((const char *)&places[i] + offset);
		for (int k = 0; k < 3; k++)
			squares += pow((double)at[k] - sum[k] / count, 2);
	}
	return squares;
}

/*
 * What makes both spaces as wide. Where light gathers or crosses itself, photons from all over the
 * light lie in one place; leaves that are compact there alone hold some of any range, and a search
 * would look into all of them.
 */
static float weigh_emitter(const Place *places, uint32_t count)
{
	double ratio = spread_of(places, count, offsetof(Place, position)) /
		       spread_of(places, count, offsetof(Place, emitter));
	return ratio > 0 && isfinite(ratio) ? (float)sqrt(ratio) : 1;
}

static PhotonTree *make_tree(const RelaxForest *forest, const Place *places, uint32_t count)
{
	TreePoints points = {
		.position = places->position, .count = count, .stride = sizeof *places};
	if (forest->space == RELAX_PARAMETER) {
		points.emitter = places->emitter;
		points.light = &places->light;
		points.emitter_weight = weigh_emitter(places, count);
	}
	return photon_tree_create(&points);
}

RelaxForest *relax_forest_create(const RelaxSet *set, RelaxSpace space)
{
	RelaxForest *forest = memory_alloc(sizeof *forest);
	memset(forest, 0, sizeof *forest);
	forest->set = set;
	forest->space = space;
	forest->members = memory_alloc(sizeof *forest->members * ((size_t)set->count + 1));
	sort_members(forest);
	return forest;
}

void relax_forest_grow(RelaxForest *forest)
{
	Place *places = make_places(forest);
	for (int key = 0; key < KEYS; key++) {
		uint32_t first = forest->starts[key], count = forest->starts[key + 1] - first;
		photon_tree_destroy(forest->trees[key]);
		if (count > 0)
			forest->trees[key] = make_tree(forest, places + first, count);
	}
	free(places);
}

void relax_forest_destroy(RelaxForest *forest)
{
	for (int key = 0; key < KEYS; key++)
		photon_tree_destroy(forest->trees[key]);
	free(forest->members);
	free(forest);
}

TreeRoom relax_forest_room(RelaxSpace space)
{
	TreeRoom room = photon_tree_room(space == RELAX_PARAMETER);
	return (TreeRoom){room.kept + sizeof(uint32_t), room.building + sizeof(Place)};
}

int relax_forest_nearest(const RelaxForest *forest, uint32_t point, int count, Neighbor *out)
{
	const RelaxPoint *p = &forest->set->points[point];
	const float *at = forest->space == RELAX_EMITTER ? p->emitter : p->position;
	uint16_t key = key_of(forest, point);
	EmitterRange range = {{p->emitter[0], p->emitter[1], p->emitter[2]}, p->range2, 0};
	NearestQuery query = {{at[0], at[1], at[2]},
			      INFINITY,
			      count,
			      forest->space == RELAX_PARAMETER ? &range : NULL};
	int found = photon_tree_nearest(forest->trees[key], &query, out);
	const uint32_t *members = forest->members + forest->starts[key];
	for (int i = 0; i < found; i++)
		out[i].index = members[out[i].index];
	return found;
}
