/*
 * Photons of one kind make one sheet: those of one light that met the same objects and flat faces
 * in the same way and landed on the same object. Of parted light each photon has one hue; where it
 * lands depends on that too. Its spectrum is cut into slices, each a sheet of its own, whose
 * photons are moved to where the slice's middle hue would have taken them, and whose patches are
 * smeared over the slice's hues (footprint_sheet.c).
 */
#include "density/footprint_parts.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/arena.h"
#include "base/parallel.h"
#include "density/footprint_strangers.h"
#include "density/gather.h"
#include "photon/group.h"
#include "photon/hue.h"

/* ---- a kind ---- */

typedef struct Making {
	const PhotonMap *map;
	double scale, shrink, disc_shrink; /* of patches, of these in passes, of discs: 1 whole */
	double reach;
	FootprintParts parts;
	float *trust, *brightness; /* of each photon of the map */
	Strangers *strangers;
	const volatile int *stop;
} Making;

static bool is_stopped(const Making *m) { return m->stop && *m->stop; }

static void add_sheet(Making *m, const SheetTask *task)
{
	float *trust = memory_alloc(sizeof *trust * task->count);
	footprint_sheet(task, &m->parts.patches, trust);
	for (uint32_t i = 0; i < task->count; i++)
		m->trust[task->photons[i]] = trust[i];
	free(trust);
}

static void set_brightness(void *data, long photon, int thread)
{
	(void)thread;
	Making *m = data;
	Rgb flux = photon_flux(&m->map->photons[photon]);
	m->brightness[photon] = flux.r + flux.g + flux.b;
}

/* What sheets are told of photons of parted light. */
typedef struct Parted {
	uint32_t *photons;
	float *hues;
	float (*slopes)[3];
	uint32_t *slices; /* by hue, each a sheet */
} Parted;

static Parted make_parted(uint32_t count)
{
	return (Parted){memory_alloc(sizeof(uint32_t) * count), memory_alloc(sizeof(float) * count),
			memory_alloc(sizeof(float[3]) * count),
			memory_alloc(sizeof(uint32_t) * count)};
}

static void free_parted(Parted *parted)
{
	free(parted->photons);
	free(parted->hues);
	free(parted->slopes);
	free(parted->slices);
}

enum { SLICES = 4 };

static Parted sort_by_slice(const Parted *all, uint32_t count)
{
	Parted sorted = make_parted(count);
	uint64_t *keys = memory_alloc(sizeof *keys * count);
	uint32_t *order = memory_alloc(sizeof *order * count);
	for (uint32_t i = 0; i < count; i++)
		keys[i] = (uint64_t)(all->hues[i] * SLICES);
	photon_group(keys, count, order);
	for (uint32_t i = 0; i < count; i++) {
		sorted.photons[i] = all->photons[order[i]];
		sorted.hues[i] = all->hues[order[i]];
		memcpy(sorted.slopes[i], all->slopes[order[i]], sizeof *sorted.slopes);
		sorted.slices[i] = (uint32_t)keys[order[i]];
	}
	free(keys);
	free(order);
	return sorted;
}

static SheetTask make_task(const Making *m, uint32_t kind, const uint32_t *photons, uint32_t count)
{
	return (SheetTask){.map = m->map,
	                   .photons = photons,
	                   .count = count,
	                   .scale = m->scale,
	                   .shrink = m->shrink,
	                   .strangers = m->strangers,
	                   .stop = m->stop,
	                   .kind = kind};
}

static void add_slice(Making *m, uint32_t kind, const Parted *parted, uint32_t first,
		      uint32_t count)
{
	SheetTask task = make_task(m, kind, parted->photons + first, count);
	task.hues = parted->hues + first;
	task.hue_slopes = (const float (*)[3])(parted->slopes + first);
	task.hue = (parted->slices[first] + 0.5) / SLICES;
	task.hue_width = 1.0 / SLICES;
	add_sheet(m, &task);
}

static void add_parted(Making *m, uint32_t kind, const uint32_t *photons, uint32_t count)
{
	Parted all = make_parted(count);
	memcpy(all.photons, photons, sizeof *photons * count);
	photon_hue_find(m->map, photons, count, all.hues);
	SheetTask whole = make_task(m, kind, photons, count);
	whole.hues = all.hues;
	whole.strangers = NULL;
	footprint_sheet_hue_slopes(&whole, all.slopes);
	Parted parted = sort_by_slice(&all, count);
	free_parted(&all);
	for (uint32_t first = 0, size; first < count && !is_stopped(m); first += size) {
		const uint32_t *slices = parted.slices + first;
		size = photon_group_size(slices, sizeof *slices, count - first);
		add_slice(m, kind, &parted, first, size);
	}
	free_parted(&parted);
}

static void add_kind(Making *m, uint32_t kind, const uint32_t *photons, uint32_t count)
{
	if (photon_hue_parts(m->map, photons, count)) {
		add_parted(m, kind, photons, count);
	} else {
		SheetTask task = make_task(m, kind, photons, count);
		add_sheet(m, &task);
	}
}

/* ---- discs ---- */

enum { DISC_COUNT = 40 };

/* Of the light around, that which found no sheet. */
static double share_left(const Making *m, const Neighbor *near, int count)
{
	double all = 0, left = 0;
	for (int i = 0; i < count; i++) {
		double flux = m->brightness[near[i].index];
		all += flux;
		left += (1 - m->trust[near[i].index]) * flux;
	}
	return all > 0 ? left / all : 1;
}

/*
 * A disc of area A blurs by its part s of the light times A, squared, and leaves noise like s / A:
 * the sum is least where A goes with the cube root of 1 / s.
 */
static void set_disc(void *data, long item, int thread)
{
	(void)thread;
	Making *m = data;
	if (is_stopped(m))
		return;
	Disc *disc = &m->parts.discs[item];
	const Photon *p = &m->map->photons[disc->photon];
	GatherPoint point = {.position = vec3_of_floats(p->position),
	                     .normal = photon_normal(p)};
	GatherTask task = {.map = m->map, .point = &point};
	static const double least_share = 1e-3;
	Neighbor found[GATHER_ROOM(DISC_COUNT)];
	double radius2 = 0, least = 1e-3 * m->map->spacing;
	int count = gather_nearest(&task, DISC_COUNT, m->reach, found, &radius2);
	radius2 /= cbrt(fmax(share_left(m, found, count), least_share));
	memcpy(disc->at, p->position, sizeof disc->at);
	disc->radius = (float)fmax(m->disc_shrink * sqrt(radius2), least);
	disc->flux = rgb_scale(photon_flux(p), 1 - m->trust[disc->photon]);
}

static void add_discs(Making *m)
{
	FootprintParts *parts = &m->parts;
	parts->discs = memory_alloc(sizeof *parts->discs * (m->map->count + 1));
	for (uint32_t i = 0; i < m->map->count; i++)
		if (m->trust[i] < 1)
			parts->discs[parts->disc_count++].photon = i;
	parallel_for(parts->disc_count, 64, set_disc, m);
}

/* ---- the whole ---- */

/* The radius that a render without a word about it starts with holds fifty photons. */
static double disc_shrink_of(const EstimatorSetup *setup)
{
	double first = setup->map->spacing * sqrt(50 / M_PI);
	return setup->radius > 0 && first > 0 ? fmin(1, setup->radius / first) : 1;
}

static void add_sheets(Making *m)
{
	uint32_t count = m->map->count, size;
	uint32_t *photons = memory_alloc(sizeof *photons * ((size_t)count + 1)),
		 *kinds = memory_alloc(sizeof *kinds * ((size_t)count + 1));
	photon_group_kinds(m->map, photons, kinds);
	m->strangers = footprint_strangers_create(m->map, photons, kinds);
	for (uint32_t first = 0; first < count && !is_stopped(m); first += size) {
		size = photon_group_size(kinds + first, sizeof *kinds, count - first);
		add_kind(m, kinds[first], photons + first, size);
	}
	footprint_strangers_destroy(m->strangers);
	free(photons);
	free(kinds);
}

FootprintParts footprint_parts(const EstimatorSetup *setup)
{
	const PhotonMap *map = setup->map;
	double disc_shrink = disc_shrink_of(setup);
	Making m = {.map = map,
	            .scale = setup->method->scale > 0 ? setup->method->scale : 1,
	            .shrink = sqrt(disc_shrink), /* patches' areas go with the radius */
	            .disc_shrink = disc_shrink,
	            .reach = gather_reach(map, DISC_COUNT),
	            .stop = setup->stop,
	            .trust = memory_alloc(sizeof(float) * (map->count + 1)),
	            .brightness = memory_alloc(sizeof(float) * (map->count + 1))};
	parallel_for(map->count, 4096, set_brightness, &m);
	add_sheets(&m);
	if (!is_stopped(&m))
		add_discs(&m);
	free(m.trust);
	free(m.brightness);
	return m.parts;
}
