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
#include "density/footprint_hue.h"
#include "density/footprint_strangers.h"
#include "density/gather.h"
#include "photon/group.h"

/* ---- a kind ---- */

typedef struct Making {
	const PhotonMap *map;
	double shrink, disc_shrink; /* of patches and discs: 1 whole */
	double reach;
	FootprintHues hues;
	FootprintParts parts;
	float *trust;  /* of each photon of the map */
	Strangers *strangers;
} Making;

static void add_sheet(Making *m, const SheetTask *task)
{
	float *trust = memory_alloc(sizeof *trust * task->count);
	footprint_sheet(task, &m->parts.patches, trust);
	for (uint32_t i = 0; i < task->count; i++)
		m->trust[task->photons[i]] = trust[i];
	free(trust);
}

/* Whether the photons have hues: strongly coloured ones, red and violet. Looks at some. */
static bool is_parted(const PhotonMap *map, const uint32_t *photons, uint32_t count)
{
	enum { LOOKS = 64 };
	uint32_t looks = count < LOOKS ? count : LOOKS, pure = 0, red = 0;
	for (uint32_t i = 0; i < looks; i++) {
		Rgb flux = photon_flux(&map->photons[photons[(uint64_t)i * count / looks]]);
		pure += footprint_hue_is_pure(flux);
		red += flux.r > flux.b;
	}
	return 2 * pure > looks && red > looks / 5 && red < looks - looks / 5;
}

/* A photon of a kind, and its hue; sorted by slices of hues. */
enum { SLICES = 4 };

typedef struct Hued {
	float hue;
	int slice;
	uint32_t photon;
} Hued;

static int compare_hued(const void *a, const void *b)
{
	const Hued *x = a, *y = b;
	if (x->slice != y->slice)
		return x->slice - y->slice;
	return (x->photon > y->photon) - (x->photon < y->photon);
}

static double brightness(const PhotonMap *map, uint32_t photon)
{
	Rgb flux = photon_flux(&map->photons[photon]);
	return (flux.r + flux.g + flux.b) / 3.0;
}

/* Photons near one another in emitter space would have the same flux if they had all hues: the mean
 * of some dozens tells it. */
static Hued *find_hues(const Making *m, const uint32_t *photons, uint32_t count)
{
	enum { WINDOW = 128 };
	Hued *hued = memory_alloc(sizeof *hued * count);
	float (*emitters)[3] = memory_alloc(sizeof *emitters * count);
	uint32_t *order = memory_alloc(sizeof *order * count);
	for (uint32_t i = 0; i < count; i++)
		memcpy(emitters[i], m->map->photons[photons[i]].emitter, sizeof *emitters);
	photon_tree_morton(emitters[0], count, sizeof *emitters, order);
	for (uint32_t from = 0; from < count; from += WINDOW) {
		uint32_t to = count - from < 2 * WINDOW ? count : from + WINDOW;
		double mean = 0;
		for (uint32_t i = from; i < to; i++)
			mean += brightness(m->map, photons[order[i]]) / (to - from);
		for (uint32_t i = from; i < to; i++) {
			uint32_t photon = photons[order[i]];
			Rgb flux = rgb_scale(photon_flux(&m->map->photons[photon]),
					     (float)(mean > 0 ? 1 / mean : 0));
			double hue = (footprint_hue_of(&m->hues, flux) + 0.5) / FOOTPRINT_HUES;
			hued[i] = (Hued){(float)hue, 0, photon};
		}
		if (to == count)
			break;
	}
	free(emitters);
	free(order);
	return hued;
}

/* What sheets are told of photons of parted light. */
typedef struct Parted {
	uint32_t *photons;
	float *hues;
	float (*slopes)[3];
} Parted;

static Parted parted_of(const Hued *hued, uint32_t count)
{
	Parted parted = {memory_alloc(sizeof *parted.photons * count),
	                 memory_alloc(sizeof *parted.hues * count),
	                 memory_alloc(sizeof *parted.slopes * count)};
	for (uint32_t i = 0; i < count; i++) {
		parted.photons[i] = hued[i].photon;
		parted.hues[i] = hued[i].hue;
	}
	return parted;
}

static void add_slice(Making *m, uint32_t kind, const Parted *parted, uint32_t first,
		      uint32_t count, int slice)
{
	SheetTask task = {.map = m->map,
	                  .photons = parted->photons + first,
	                  .count = count,
	                  .shrink = m->shrink,
	                  .hues = parted->hues + first,
	                  .hue_slopes = (const float (*)[3])(parted->slopes + first),
	                  .hue = (slice + 0.5) / SLICES,
	                  .hue_width = 1.0 / SLICES,
	                  .strangers = m->strangers,
	                  .kind = kind};
	add_sheet(m, &task);
}

static void add_parted(Making *m, uint32_t kind, const uint32_t *photons, uint32_t count)
{
	Hued *hued = find_hues(m, photons, count);
	for (uint32_t i = 0; i < count; i++)
		hued[i].slice = (int)(hued[i].hue * SLICES);
	qsort(hued, count, sizeof *hued, compare_hued);
	Parted parted = parted_of(hued, count);
	SheetTask all = {
		.map = m->map, .photons = parted.photons, .count = count, .hues = parted.hues};
	footprint_sheet_hue_slopes(&all, parted.slopes);
	for (uint32_t first = 0, last; first < count; first = last) {
		for (last = first + 1; last < count && hued[last].slice == hued[first].slice;)
			last++;
		add_slice(m, kind, &parted, first, last - first, hued[first].slice);
	}
	free(parted.photons);
	free(parted.hues);
	free(parted.slopes);
	free(hued);
}

static void add_kind(Making *m, uint32_t kind, const uint32_t *photons, uint32_t count)
{
	if (is_parted(m->map, photons, count)) {
		add_parted(m, kind, photons, count);
	} else {
		SheetTask task = {.map = m->map,
		                  .photons = photons,
		                  .count = count,
		                  .shrink = m->shrink,
		                  .strangers = m->strangers,
		                  .kind = kind};
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
		double flux = brightness(m->map, near[i].index);
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
	Disc *disc = &m->parts.discs[item];
	const Photon *p = &m->map->photons[disc->photon];
	GatherPoint point = {.position = vec3(p->position[0], p->position[1], p->position[2]),
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

/* Patches are right but for what curves within them, and shrinking makes them noisy: their areas
 * shrink as the radius does. */
static double shrink_of(const EstimatorSetup *setup)
{
	double scale = setup->method->scale > 0 ? setup->method->scale : 1;
	return scale * sqrt(disc_shrink_of(setup));
}

/* Photons sorted by kind, and the kinds' numbers. */
static void sort_photons(const PhotonMap *map, uint32_t *photons, uint32_t *kinds)
{
	uint64_t *keys = memory_alloc(sizeof *keys * ((size_t)map->count + 1));
	for (uint32_t i = 0; i < map->count; i++)
		keys[i] = photon_kind(&map->photons[i]);
	photon_group(keys, map->count, photons);
	for (uint32_t i = 0; i < map->count; i++)
		kinds[i] = i > 0 ? kinds[i - 1] + (keys[photons[i]] != keys[photons[i - 1]]) : 0;
	free(keys);
}

static void add_sheets(Making *m)
{
	size_t room = (size_t)m->map->count + 1;
	uint32_t *photons = memory_alloc(sizeof *photons * room),
		 *kinds = memory_alloc(sizeof *kinds * room);
	sort_photons(m->map, photons, kinds);
	m->strangers = footprint_strangers_create(m->map, photons, kinds);
	for (uint32_t first = 0, end; first < m->map->count; first = end) {
		for (end = first + 1; end < m->map->count && kinds[end] == kinds[first];)
			end++;
		add_kind(m, kinds[first], photons + first, end - first);
	}
	footprint_strangers_destroy(m->strangers);
	free(photons);
	free(kinds);
}

FootprintParts footprint_parts(const EstimatorSetup *setup)
{
	const PhotonMap *map = setup->map;
	Making m = {.map = map,
	            .shrink = shrink_of(setup),
	            .disc_shrink = disc_shrink_of(setup),
	            .reach = gather_reach(map, DISC_COUNT),
	            .hues = footprint_hues(),
	            .trust = memory_alloc(sizeof(float) * (map->count + 1))};
	add_sheets(&m);
	add_discs(&m);
	free(m.trust);
	return m.parts;
}
