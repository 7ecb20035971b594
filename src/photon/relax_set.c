#include "photon/relax_set.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/arena.h"
#include "base/parallel.h"
#include "base/random.h"
#include "photon/relax_forest.h"
#include "photon/relax_slices.h"

/* ---- the working copy ---- */

static bool takes_part(const Photon *photon, const RelaxSurfaces *surfaces)
{
	if (surfaces->fixed && photon->object < surfaces->fixed_count &&
	    surfaces->fixed[photon->object])
		return false;
	return isfinite(photon->position[0]) && isfinite(photon->position[1]) &&
	       isfinite(photon->position[2]);
}

void relax_emitter_axes(const float emitter[3], bool on_plane, Vec3 axes[2])
{
	axes[0] = vec3(1, 0, 0);
	axes[1] = vec3(0, 1, 0);
	if (!on_plane)
		vec3_frame(vec3_normalize(vec3_of_floats(emitter)), &axes[0], &axes[1]);
}

static uint16_t sheet_of(const Photon *photon, uint8_t slice)
{
	uint64_t landed = (uint64_t)photon->object << 8 | slice;
	return (uint16_t)random_bits((uint64_t)photon->light, landed, photon->path);
}

static RelaxPoint make_point(const PhotonMap *map, uint32_t number, uint8_t slice)
{
	const Photon *photon = &map->photons[number];
	RelaxPoint point = {.photon = number,
			    .sheet = sheet_of(photon, slice),
			    .object = photon->object,
			    .on_plane = photon_map_on_plane(map, photon),
			    .range2 = INFINITY};
	Rgb flux = photon_flux(photon);
	memcpy(point.position, photon->position, sizeof point.position);
	memcpy(point.emitter, photon->emitter, sizeof point.emitter);
	vec3_to_floats(photon_normal(photon), point.normal);
	point.flux[0] = flux.r;
	point.flux[1] = flux.g;
	point.flux[2] = flux.b;
	return point;
}

/* So that products of fluxes are no extreme numbers, whatever the scene's unit of length. */
static void scale_fluxes(RelaxSet *set)
{
	double sum = 0;
	for (uint32_t i = 0; i < set->count; i++)
		for (int k = 0; k < 3; k++)
			sum += (double)set->points[i].flux[k];
	float scale = sum > 0 && isfinite(sum) ? (float)(3 * set->count / sum) : 1;
	for (uint32_t i = 0; i < set->count; i++)
		for (int k = 0; k < 3; k++)
			set->points[i].flux[k] *= scale;
}

static void sort_points(RelaxSet *set)
{
	uint32_t *order = memory_alloc(sizeof *order * ((size_t)set->count + 1));
	RelaxPoint *sorted = memory_alloc(sizeof *sorted * ((size_t)set->count + 1));
	photon_tree_morton(set->points->position, set->count, sizeof *set->points, order);
	for (uint32_t i = 0; i < set->count; i++)
		sorted[i] = set->points[order[i]];
	free(order);
	free(set->points);
	set->points = sorted;
}

/* The normals kept in photons are coarse: two and a half degrees. The surfaces know better. */
static void settle_normals(RelaxSet *set, uint32_t first, uint32_t end, void *data)
{
	(void)data;
	for (uint32_t i = first; i < end; i++) {
		RelaxPoint *point = &set->points[i];
		RelaxPlace place = {point->object, vec3_of_floats(point->position),
				    vec3_of_floats(point->normal)};
		if (set->surfaces->project(set->surfaces->data, &place, 0))
			vec3_to_floats(place.normal, point->normal);
	}
}

void relax_set_init(RelaxSet *set, const PhotonMap *map, const RelaxSurfaces *surfaces,
		    bool by_hue)
{
	*set = (RelaxSet){.points = memory_alloc(sizeof(RelaxPoint) * ((size_t)map->count + 1)),
			  .surfaces = surfaces};
	uint8_t *slices = by_hue ? relax_slices(map) : NULL;
	for (uint32_t i = 0; i < map->count; i++) {
		if (!takes_part(&map->photons[i], surfaces))
			continue;
		set->points[set->count++] = make_point(map, i, slices ? slices[i] : 0);
	}
	free(slices);
	scale_fluxes(set);
	sort_points(set);
	if (surfaces->project)
		relax_set_each(set, settle_normals, NULL);
}

void relax_set_free(RelaxSet *set)
{
	free(set->points);
	free(set->bases);
	relax_lists_drop(set);
}

void relax_set_store(const RelaxSet *set, PhotonMap *map)
{
	for (uint32_t i = 0; i < set->count; i++) {
		const RelaxPoint *point = &set->points[i];
		Photon *photon = &map->photons[point->photon];
		memcpy(photon->position, point->position, sizeof photon->position);
		if (set->surfaces->project)
			photon_set_normal(photon, vec3_of_floats(point->normal));
	}
}

/* ---- runs ---- */

enum { RUN = 1024 };

typedef struct EachJob {
	RelaxSet *set;
	RelaxRun *run;
	void *data;
} EachJob;

bool relax_set_is_stopped(const RelaxSet *set)
{
	return set->surfaces->stop && *set->surfaces->stop;
}

static void each_run(void *data, long item, int thread)
{
	(void)thread;
	const EachJob *job = data;
	uint32_t first = (uint32_t)item * RUN, left = job->set->count - first;
	if (!relax_set_is_stopped(job->set))
		job->run(job->set, first, first + (left < RUN ? left : RUN), job->data);
}

void relax_set_each(RelaxSet *set, RelaxRun *run, void *data)
{
	EachJob job = {set, run, data};
	parallel_for((set->count + (long)RUN - 1) / RUN, 1, each_run, &job);
}

/* ---- neighbours ---- */

/* cosine of 45 degrees: beyond an edge or on the other side is another surface. */
static const float SAME_SIDE = 0.7f;

static bool same_side(const RelaxPoint *a, const RelaxPoint *b)
{
	return a->normal[0] * b->normal[0] + a->normal[1] * b->normal[1] +
		       a->normal[2] * b->normal[2] >=
	       SAME_SIDE;
}

static void drop_farthest(Neighbor *near, int *count)
{
	int worst = 0;
	for (int i = 1; i < *count; i++) {
		if (near[i].distance2 > near[worst].distance2 ||
		    (near[i].distance2 == near[worst].distance2 &&
		     near[i].index > near[worst].index))
			worst = i;
	}
	near[worst] = near[--*count];
}

typedef struct FillJob {
	const RelaxForest *forest;
	int widest; /* the most that is asked for when many found lie on another side */
} FillJob;

/* Those of the `asked` nearest on the point's side; *met: how many were found at all. */
static int find_near(const RelaxSet *set, const FillJob *job, uint32_t i, int asked,
			  Neighbor *near, int *met)
{
	const RelaxPoint *point = &set->points[i];
	*met = relax_forest_nearest(job->forest, i, asked, near);
	int kept = 0;
	for (int j = 0; j < *met; j++) {
		if (near[j].index != i && same_side(point, &set->points[near[j].index]))
			near[kept++] = near[j];
	}
	return kept;
}

static void fill_run(RelaxSet *set, uint32_t first, uint32_t end, void *data)
{
	const FillJob *job = data;
	int most = set->lists.most;
	Neighbor near[job->widest + 8 * TREE_SLACK];
	for (uint32_t i = first; i < end; i++) {
		int asked = most + 1, met, count = find_near(set, job, i, asked, near, &met);
		while (count < most && met == asked && asked < job->widest) {
			asked = 2 * asked < job->widest ? 2 * asked : job->widest;
			count = find_near(set, job, i, asked, near, &met);
		}
		while (count > most)
			drop_farthest(near, &count);
		set->lists.counts[i] = (uint8_t)count;
		uint32_t *row = set->lists.index + (size_t)i * (size_t)most;
		for (int j = 0; j < count; j++)
			row[j] = near[j].index;
	}
}

void relax_lists_drop(RelaxSet *set)
{
	free(set->lists.index);
	free(set->lists.counts);
	set->lists = (RelaxLists){.index = NULL};
}

void relax_lists_fill(RelaxSet *set, const RelaxForest *forest, int most)
{
	size_t rows = (size_t)set->count + 1;
	relax_lists_drop(set);
	set->lists = (RelaxLists){memory_alloc(sizeof *set->lists.index * (size_t)most * rows),
				  memory_alloc(rows), most};
	FillJob job = {forest, 4 * (most + 1)};
	relax_set_each(set, fill_run, &job);
}
