/*
 * Searches for those near that left the light near as well: who is found, and that light which
 * gathers is searched as fast as light which does not.
 */
#include "photon/relax_forest.h"

#include <stdlib.h>

#include "base/arena.h"
#include "base/clock.h"
#include "base/random.h"
#include "tests/unit/check.h"

enum { POINTS = 100000, ASKED = 51, IN_RANGE = 200, EVERY = 20 };

static void even(const float from[2], float to[2])
{
	to[0] = from[0];
	to[1] = from[1];
}

/* A rippled lens: all falls onto a small spot, neighbours in range all over it. */
static void gathered(const float from[2], float to[2])
{
	for (int k = 0; k < 2; k++)
		to[k] = 0.5f + 0.001f * sinf(500 * from[k]);
}

/* Some of the light misses the lens. */
static void half_gathered(const float from[2], float to[2])
{
	if (from[0] < 0.5f)
		gathered(from, to);
	else
		even(from, to);
}

typedef void Lens(const float from[2], float to[2]);

static RelaxSet make_set(Lens *lens)
{
	RelaxSet set = {.points = memory_alloc(sizeof(RelaxPoint) * POINTS), .count = POINTS};
	for (uint32_t i = 0; i < POINTS; i++) {
		RelaxPoint *p = &set.points[i];
		*p = (RelaxPoint){.photon = i, .range2 = (float)(IN_RANGE / (M_PI * POINTS))};
		p->emitter[0] = (float)random_uniform(1, i, 0);
		p->emitter[1] = (float)random_uniform(1, i, 1);
		lens(p->emitter, p->position);
	}
	return set;
}

static float square(const float a[3], const float b[3])
{
	float x = a[0] - b[0], y = a[1] - b[1], z = a[2] - b[2];
	return x * x + y * y + z * z;
}

/* Who is found is in range, and nobody else in range is nearer than the farthest. */
static void check_found(const RelaxSet *set, uint32_t point, const Neighbor *found, int count)
{
	const RelaxPoint *p = &set->points[point];
	float farthest = photon_tree_farthest(found, count);
	int nearer = 0, inside = 0, strangers = 0;
	for (int i = 0; i < count; i++)
		strangers += square(set->points[found[i].index].emitter, p->emitter) > p->range2;
	for (uint32_t i = 0; i < set->count; i++) {
		const RelaxPoint *q = &set->points[i];
		if (square(q->emitter, p->emitter) > p->range2)
			continue;
		inside++;
		nearer += square(q->position, p->position) < farthest;
	}
	CHECK(count == (inside < ASKED ? inside : ASKED));
	CHECK(strangers == 0);
	CHECK(nearer < count);
}

/* Processor seconds of many searches. */
static double search(Lens *lens)
{
	RelaxSet set = make_set(lens);
	RelaxForest *forest = relax_forest_create(&set, RELAX_PARAMETER);
	Neighbor found[ASKED + 8 * TREE_SLACK];
	relax_forest_grow(forest);
	for (uint32_t i = 0; i < POINTS; i += POINTS / EVERY)
		check_found(&set, i, found, relax_forest_nearest(forest, i, ASKED, found));
	double start = clock_cpu();
	for (uint32_t i = 0; i < POINTS; i += EVERY)
		relax_forest_nearest(forest, i, ASKED, found);
	double seconds = clock_cpu() - start;
	relax_forest_destroy(forest);
	free(set.points);
	return seconds;
}

int main(void)
{
	double usual = search(even);
	/* Up to four times as long; 25 and 130 times, by places on the ground alone. */
	CHECK(search(gathered) < 8 * usual);
	CHECK(search(half_gathered) < 8 * usual);
	return CHECK_RESULT();
}
