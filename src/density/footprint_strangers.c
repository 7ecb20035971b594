/*
 * Beside each vertex the nearest photons of the light are looked at, whatever their kind. A kind
 * that starts at the same places as the sheet falls into its triangles, all but what lies along the
 * border, and into large and small ones by their areas. One that lands elsewhere because the sheet
 * has a gap there falls into few triangles, or into large ones: those that reach over the gap. One
 * may do both, as where glass mirrors a little of the light here and all of it there: so of a kind
 * that lands in gaps, strangers that are alone are judged apart from those that are in groups, and
 * of these such as have photons of the sheet on all sides tell nothing.
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
	bool stopped = footprint_mesh_is_stopped(look->sheet);
	int around = stopped ? 0 : photon_tree_nearest(field->tree, &query, found), count = 0;
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

/* Whether there is no line through the middle with all places on one side. */
static bool are_all_around(const double (*off)[2], int count)
{
	enum { SIDES = 16 };
	for (int side = 0; side < SIDES; side++) {
		double x = cos(2 * M_PI / SIDES * side), y = sin(2 * M_PI / SIDES * side);
		bool any = false;
		for (int i = 0; i < count && !any; i++)
			any = x * off[i][0] + y * off[i][1] > 0;
		if (!any)
			return false;
	}
	return true;
}

/*
 * Whether the sheet's photons are on all sides of a stranger, among the nearest of any kind. Beside
 * a gap there are none on the side where that is; of places shared at random by halves, one in
 * twenty looks so.
 */
static bool is_surrounded(const Sheet *sheet, uint32_t stranger)
{
	enum { NEAR = 17 };
	const Strangers *s = sheet->task->strangers;
	const Photon *p = &s->map->photons[s->photons[stranger]];
	const struct Field *field = &s->fields[p->light];
	NearestQuery query = {{p->emitter[0], p->emitter[1], p->emitter[2]}, INFINITY, NEAR, NULL};
	Neighbor found[NEAR + 8 * TREE_SLACK];
	double at[2], off[NEAR + 8 * TREE_SLACK][2];
	int around = photon_tree_nearest(field->tree, &query, found), count = 0;
	footprint_mesh_chart(sheet, p->emitter, at);
	for (int k = 0; k < around; k++) {
		uint32_t other = field->first + found[k].index;
		if (s->kinds[other] != sheet->task->kind)
			continue;
		footprint_mesh_chart(sheet, s->emitters[other], off[count]);
		off[count][0] -= at[0];
		off[count++][1] -= at[1];
	}
	return are_all_around((const double (*)[2])off, count);
}

/* Strangers of one kind, or those of them that are beside one another. */
typedef struct Group {
	uint32_t held, all;
	double areas; /* of the triangles that hold one */
} Group;

static void add_to_group(const Sheet *sheet, uint32_t triangle, Group *group)
{
	group->all++;
	if (triangle == NONE)
		return;
	group->held++;
	group->areas += area_of(sheet, sheet->triangles[triangle]);
}

/*
 * Of random points' triangles those that hold a place at random are 1.8 times as large as the mean,
 * give or take about as much; of sheets that share their places, at least six in ten strangers
 * beside a sheet are in it. allowed: how much of what chance may add is left to it, 0..1.
 */
static bool lands_in_gaps(const Group *group, double allowed)
{
	static const double least_held = 0.6, most_area = 2;
	double chance = allowed / sqrt(group->all);
	return group->held < (least_held - 0.5 * chance) * group->all ||
	       group->areas > (most_area + 3 * chance) * group->held;
}

/* Strangers of one kind. */
typedef struct Kind {
	struct Stranger {
		uint32_t inside; /* a triangle or NONE */
		uint32_t next;   /* of its group, towards the first of them; of that its own */
		uint32_t number; /* in Strangers.photons */
	} *all;
	uint32_t count;
	Group whole;
} Kind;

static Kind make_kind(const Sheet *sheet, const Beside *list, uint32_t count)
{
	Kind kind = {.all = memory_alloc(sizeof *kind.all * count)};
	for (uint32_t first = 0, size; first < count; first += size) {
		size = photon_group_size(&list[first].stranger, sizeof *list, count - first);
		uint32_t inside = triangle_with(sheet, list + first, size);
		add_to_group(sheet, inside, &kind.whole);
		kind.all[kind.count] = (struct Stranger){inside, kind.count, list[first].stranger};
		kind.count++;
	}
	return kind;
}

static uint32_t first_of(const Kind *kind, uint32_t stranger)
{
	struct Stranger *all = kind->all;
	while (all[stranger].next != stranger)
		stranger = all[stranger].next = all[all[stranger].next].next;
	return stranger;
}

/* Those beside one vertex are of one group. last: NONE for each vertex, and left so. */
static void make_groups(const Kind *kind, const Beside *list, uint32_t count, uint32_t *last)
{
	uint32_t stranger = 0;
	for (uint32_t i = 0; i < count; i++) {
		uint32_t *beside = &last[list[i].vertex];
		stranger += i > 0 && list[i].stranger != list[i - 1].stranger;
		if (*beside != NONE) {
			uint32_t a = first_of(kind, *beside), b = first_of(kind, stranger);
			kind->all[a > b ? a : b].next = a > b ? b : a;
		}
		*beside = stranger;
	}
	for (uint32_t i = 0; i < count; i++)
		last[list[i].vertex] = NONE;
}

/* Whether one of a group tells of a gap. Where the triangles are clearly larger than at random
 * places there is one, though the sheet's photons be all around. */
static bool tells_gap(const Sheet *sheet, const struct Stranger *stranger, const Group *group)
{
	static const double clear_area = 2.6;
	return lands_in_gaps(group, 0) && (group->areas > clear_area * group->held ||
					   !is_surrounded(sheet, stranger->number));
}

/* Few strangers beside one another, as where a kind shares its places with the sheet and has few
 * photons there, tell nothing: those of all such groups tell together. A larger group of a kind
 * that lands in gaps does so too, if it does not tell clearly that it does not. */
static void mark_gaps(const Sheet *sheet, const Kind *kind, bool *gaps)
{
	enum { FEW = 4 };
	Group *groups = memory_alloc(sizeof *groups * ((size_t)kind->count + 1));
	Group *alone = &groups[kind->count];
	memset(groups, 0, sizeof *groups * ((size_t)kind->count + 1));
	for (uint32_t i = 0; i < kind->count; i++)
		add_to_group(sheet, kind->all[i].inside, &groups[first_of(kind, i)]);
	for (uint32_t i = 0; i < kind->count; i++)
		if (groups[first_of(kind, i)].all < FEW)
			add_to_group(sheet, kind->all[i].inside, alone);
	bool alone_too = alone->all > 0 && lands_in_gaps(alone, 1);
	for (uint32_t i = 0; i < kind->count; i++) {
		const Group *group = &groups[first_of(kind, i)];
		if (kind->all[i].inside != NONE &&
		    (group->all < FEW ? alone_too : tells_gap(sheet, &kind->all[i], group)))
			gaps[kind->all[i].inside] = true;
	}
	free(groups);
}

static void look_at_kind(const Sheet *sheet, const Beside *list, uint32_t count, uint32_t *last,
			 bool *gaps)
{
	Kind kind = make_kind(sheet, list, count);
	if (lands_in_gaps(&kind.whole, 1)) {
		make_groups(&kind, list, count, last);
		mark_gaps(sheet, &kind, gaps);
	}
	free(kind.all);
}

void footprint_strangers_find(const Sheet *sheet, bool *gaps)
{
	uint32_t count, *last = memory_alloc(sizeof *last * ((size_t)sheet->count + 1));
	Beside *list = list_beside(sheet, &count);
	for (uint32_t i = 0; i < sheet->count; i++)
		last[i] = NONE;
	for (uint32_t first = 0, size; first < count; first += size) {
		size = photon_group_size(&list[first].kind, sizeof *list, count - first);
		look_at_kind(sheet, list + first, size, last, gaps);
	}
	free(last);
	free(list);
}
