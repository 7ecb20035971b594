/*
 * Values spread along the edges of a sheet, as heat does. Inner edges belong to two triangles and
 * carry twice what border edges do. A vertex has some six neighbours, and how many cannot be
 * foreseen: all are given eight places, so that no branch is taken a vertex.
 */
#include <stdlib.h>
#include <string.h>

#include "base/arena.h"
#include "density/footprint_mesh.h"

/* ---- links ---- */

static void add_link(Links *links, uint32_t *room, uint32_t to, uint32_t from, double weight)
{
	if (links->more_count == *room) {
		*room = *room ? 2 * *room : 64;
		links->more = memory_resize(links->more, sizeof *links->more * *room);
	}
	links->more[links->more_count++] = (struct Link){to, from, weight};
}

/* A ring has what follows the vertex, each for two triangles; of a border edge one of the two is
 * the other end's. */
void footprint_mesh_link(Sheet *s)
{
	Links *links = &s->links;
	uint32_t room = 0;
	links->around = memory_alloc_wide(sizeof *links->around * ((size_t)s->count + 1));
	for (uint32_t i = 0; i < s->count; i++) {
		const uint32_t *ring = s->ring + s->first[i];
		uint32_t size = s->first[i + 1] - s->first[i];
		for (uint32_t k = 0; k < LINKS; k++)
			links->around[i][k] = k < size ? ring[k] : i;
		for (uint32_t k = 0; k < size; k++) {
			if (k >= LINKS)
				add_link(links, &room, i, ring[k], 2);
			if (footprint_mesh_is_border(s, i, ring[k])) {
				add_link(links, &room, i, ring[k], -1);
				add_link(links, &room, ring[k], i, 1);
			}
		}
	}
}

/* ---- rounds ---- */

static const double part = 1.0 / 24; /* of a triangle's edge */

/* pairs is a constant where this is inlined. */
static inline void spread_around(const uint32_t around[LINKS], const Pair *old, const Pair *own,
				 Pair *out, int pairs)
{
	for (int i = 0; i < pairs; i++) {
		Pair sum = {0};
#pragma GCC unroll 8
		for (int k = 0; k < LINKS; k++)
			sum += old[around[k] * (size_t)pairs + (size_t)i];
		out[i] = own[i] + 2 * part * (sum - LINKS * own[i]);
	}
}

static inline void spread_all(const Sheet *s, const Pair *old, Pair *values, int pairs)
{
	for (uint32_t i = 0; i < s->count; i++) {
		size_t at = i * (size_t)pairs;
		spread_around(s->links.around[i], old, old + at, values + at, pairs);
	}
	for (uint32_t k = 0; k < s->links.more_count; k++) {
		const struct Link *link = &s->links.more[k];
		size_t to = link->to * (size_t)pairs, from = link->from * (size_t)pairs;
		for (int i = 0; i < pairs; i++)
			values[to + (size_t)i] += part * link->weight *
						  (old[from + (size_t)i] - old[to + (size_t)i]);
	}
}

static void spread_once(const Sheet *s, const Pair *old, Pair *values, int pairs)
{
	if (pairs == 1)
		spread_all(s, old, values, 1);
	else
		spread_all(s, old, values, 2);
}

void footprint_mesh_spread(const Sheet *s, Pair *values, int pairs, int rounds)
{
	Pair *other = memory_alloc_wide(sizeof *other * s->count * (size_t)pairs);
	for (int round = 0; round < rounds; round += 2) {
		spread_once(s, values, other, pairs);
		spread_once(s, other, values, pairs);
	}
	free(other);
}
