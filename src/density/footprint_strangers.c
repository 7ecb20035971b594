/*
 * Beside each vertex the nearest photons of the light are looked at, whatever their kind. A kind
 * that starts at the same places as the sheet falls into its triangles, all but what lies along the
 * border, and into large and small ones by their areas. One that lands elsewhere because the sheet
 * has a gap there falls into few triangles, or into large ones: those that reach over the gap.
 */
#include "density/footprint_strangers.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/arena.h"
#include "base/parallel.h"
#include "photon/group.h"

/* ---- the light's photons ---- */

struct Strangers {
	const PhotonMap *map;
	const uint32_t *photons, *kinds;
	float (*emitters)[3];
	struct Field {
		PhotonTree *tree;
		uint32_t first; /* of its photons */
	} *fields; /* by light */
};

/* Photons sorted by kind are sorted by light. */
static void make_fields(Strangers *s)
{
	uint32_t lights = (uint32_t)s->map->light_count, first = 0;
	uint32_t *sizes = memory_alloc(sizeof *sizes * ((size_t)lights + 1));
	memset(sizes, 0, sizeof *sizes * lights);
	for (uint32_t i = 0; i < s->map->count; i++)
		sizes[s->map->photons[i].light]++;
	for (uint32_t light = 0; light < lights; first += sizes[light++]) {
		TreePoints points = {.position = s->emitters[first],
		                     .count = sizes[light],
		                     .stride = sizeof *s->emitters};
		s->fields[light] = (struct Field){photon_tree_create(&points), first};
	}
	free(sizes);
}

Strangers *footprint_strangers_create(const PhotonMap *map, const uint32_t *photons,
				      const uint32_t *kinds)
{
	Strangers *s = memory_alloc(sizeof *s);
	*s = (Strangers){map, photons, kinds,
			 memory_alloc(sizeof *s->emitters * ((size_t)map->count + 1)),
			 memory_alloc(sizeof *s->fields * ((size_t)map->light_count + 1))};
	for (uint32_t i = 0; i < map->count; i++)
		memcpy(s->emitters[i], map->photons[photons[i]].emitter, sizeof *s->emitters);
	make_fields(s);
	return s;
}

void footprint_strangers_destroy(Strangers *s)
{
	for (int i = 0; i < s->map->light_count; i++)
		photon_tree_destroy(s->fields[i].tree);
	free(s->fields);
	free(s->emitters);
	free(s);
}

/* ---- beside the sheet ---- */

enum { AROUND = 9 }; /* with the vertex' own photon */

/* A stranger among the photons nearest to a vertex. */
typedef struct Beside { uint32_t kind, stranger, vertex; } Beside;

typedef struct Look {
	const Sheet *sheet;
	Beside (*beside)[AROUND];
	int *counts;
} Look;

static void look_around(void *data, long item, int thread)
{
	(void)thread;
	const Look *look = data;
	const SheetTask *task = look->sheet->task;
	const Strangers *s = task->strangers;
	const Photon *p = &s->map->photons[task->photons[item]];
	const struct Field *field = &s->fields[p->light];
	NearestQuery query = {
		{p->emitter[0], p->emitter[1], p->emitter[2]}, INFINITY, AROUND, NULL};
	Neighbor found[AROUND + 8 * TREE_SLACK];
	int around = photon_tree_nearest(field->tree, &query, found), count = 0;
	for (int k = 0; k < around; k++) {
		uint32_t other = field->first + found[k].index;
		if (s->kinds[other] != task->kind)
			look->beside[item][count++] =
				(Beside){s->kinds[other], other, (uint32_t)item};
	}
	look->counts[item] = count;
}

/* By kind and stranger; of one stranger the vertices stay in their order. The list is replaced. */
static Beside *sort_beside(Beside *list, uint32_t count)
{
	uint64_t *keys = memory_alloc(sizeof *keys * ((size_t)count + 1));
	uint32_t *order = memory_alloc(sizeof *order * ((size_t)count + 1));
	Beside *sorted = memory_alloc(sizeof *sorted * ((size_t)count + 1));
	for (uint32_t i = 0; i < count; i++)
		keys[i] = (uint64_t)list[i].kind << 32 | list[i].stranger;
	photon_group(keys, count, order);
	for (uint32_t i = 0; i < count; i++)
		sorted[i] = list[order[i]];
	free(keys);
	free(order);
	free(list);
	return sorted;
}

/* The block is the caller's to free. */
static Beside *list_beside(const Sheet *sheet, uint32_t *count)
{
	Look look = {sheet, memory_alloc(sizeof *look.beside * sheet->count),
	             memory_alloc(sizeof *look.counts * sheet->count)};
	Beside *list = look.beside[0];
	parallel_for(sheet->count, 256, look_around, &look);
	*count = 0;
	for (uint32_t i = 0; i < sheet->count; i++)
		for (int k = 0; k < look.counts[i]; k++)
			list[(*count)++] = look.beside[i][k];
	free(look.counts);
	return sort_beside(list, *count);
}

/* ---- gaps ---- */

static bool holds(const Sheet *s, const uint32_t t[3], const double e[2])
{
	const Vertex *v = s->vertices;
	return footprint_cross(v[t[0]].e, v[t[1]].e, e) >= 0 &&
	       footprint_cross(v[t[1]].e, v[t[2]].e, e) >= 0 &&
	       footprint_cross(v[t[2]].e, v[t[0]].e, e) >= 0;
}

static const uint32_t NONE = UINT32_MAX;

/* The triangle around one of the vertices beside a stranger that holds it and reaches over no gap
 * that is known already, or NONE. */
static uint32_t triangle_with(const Sheet *sheet, const Beside *list, uint32_t count)
{
	double e[2];
	footprint_mesh_chart(sheet, sheet->task->strangers->emitters[list->stranger], e);
	for (uint32_t i = 0; i < count; i++) {
		uint32_t v = list[i].vertex;
		for (uint32_t k = sheet->first[v]; k < sheet->first[v + 1]; k++) {
			const uint32_t *t = sheet->triangles[sheet->ring[k]];
			if (holds(sheet, t, e))
				return footprint_mesh_bridges(sheet, t) ? NONE : sheet->ring[k];
		}
	}
	return NONE;
}

/* Beside the median one. */
static double area_of(const Sheet *s, const uint32_t t[3])
{
	const Vertex *v = s->vertices;
	double space = fmin(fmin(v[t[0]].space, v[t[1]].space), v[t[2]].space);
	return footprint_cross(v[t[0]].e, v[t[1]].e, v[t[2]].e) / space;
}

/* Strangers of one kind. */
typedef struct Kind {
	uint32_t *inside; /* triangles that hold one */
	uint32_t held, all;
	double areas; /* of these triangles */
} Kind;

/*
 * Of random points' triangles those that hold a place at random are 1.8 times as large as the mean,
 * give or take about as much; of sheets that share their places, at least six in ten strangers
 * beside a sheet are in it.
 */
static bool lands_in_gaps(const Kind *kind)
{
	static const double least_held = 0.6, most_area = 2;
	double chance = 1 / sqrt(kind->all);
	return kind->held < (least_held - 0.5 * chance) * kind->all ||
	       kind->areas > (most_area + 3 * chance) * kind->held;
}

static void look_at_kind(const Sheet *sheet, const Beside *list, uint32_t count, bool *gaps)
{
	Kind kind = {.inside = memory_alloc(sizeof *kind.inside * count)};
	for (uint32_t first = 0, size; first < count; first += size) {
		size = photon_group_size(&list[first].stranger, sizeof *list, count - first);
		uint32_t t = triangle_with(sheet, list + first, size);
		kind.all++;
		if (t == NONE)
			continue;
		kind.inside[kind.held++] = t;
		kind.areas += area_of(sheet, sheet->triangles[t]);
	}
	for (uint32_t i = 0; i < kind.held && lands_in_gaps(&kind); i++)
		gaps[kind.inside[i]] = true;
	free(kind.inside);
}

void footprint_strangers_find(const Sheet *sheet, bool *gaps)
{
	uint32_t count;
	Beside *list = list_beside(sheet, &count);
	for (uint32_t first = 0, size; first < count; first += size) {
		size = photon_group_size(&list[first].kind, sizeof *list, count - first);
		look_at_kind(sheet, list + first, size, gaps);
	}
	free(list);
}
