/*
 * Light as the sheets that photons sample. Photons of one light that went the same way (same
 * objects, same flat faces, same events) to the same object sample one map from emitter coordinates
 * (Spencer & Jones 2013, section 4.1) to the surface. Triangulated over emitter space and taken to
 * the surface by that map, the triangles are patches of light that meet without gaps and fold over
 * one another as the sheet does (footprint_sheet.c): caustic volumes' triangles (Watt 1990, Nishita
 * & Nakamae 1994), bent. What a gather point receives is the patches' light within the pixel that
 * it stands for, over the pixel's area: no kernel, no bandwidth, and no noise but where the
 * photons' own way is noisy. There each photon's light covers a disc, as with the nearest photons
 * (footprint_parts.c).
 *
 * In progressive passes patches shrink towards their photons, those soonest that fit worst, so that
 * what they get wrong vanishes from the mean over passes.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/arena.h"
#include "density/footprint_parts.h"
#include "density/footprint_tree.h"
#include "density/gather.h"
#include "density/kernel.h"

typedef struct FootprintMap {
	FootprintTree patch_tree, disc_tree;
	Patch *patches;
	uint32_t patch_count;
	Disc *discs;
	double least_width; /* of a pixel, when that is not known */
} FootprintMap;

/* ---- creation ---- */

static size_t size_of_nodes(const FootprintTree *tree)
{
	size_t nodes = tree->levels > 0 ? tree->level_start[tree->levels - 1] + 1u : 0;
	return sizeof(FootprintNode) * nodes;
}

/* A tree over the boxes, and the order of what is in them. */
static FootprintTree make_tree(const Box3 *boxes, uint32_t count, uint32_t *order)
{
	Box3 *ordered = memory_alloc(sizeof *ordered * (count + 1));
	footprint_tree_order(boxes, count, order);
	for (uint32_t i = 0; i < count; i++)
		ordered[i] = boxes[order[i]];
	FootprintTree tree = footprint_tree_build(ordered, count);
	free(ordered);
	return tree;
}

static Vec3 normal_of(const PhotonMap *map, uint32_t photon)
{
	return photon_normal(&map->photons[photon]);
}

static Box3 box_around(Vec3 at, Vec3 reach)
{
	return (Box3){vec3_sub(at, reach), vec3_add(at, reach)};
}

static Box3 disc_box(const Disc *disc, Vec3 normal)
{
	double r = disc->radius;
	Vec3 at = vec3_of_floats(disc->at);
	Vec3 flat = vec3(r * sqrt(fmax(0, 1 - normal.x * normal.x)),
			 r * sqrt(fmax(0, 1 - normal.y * normal.y)),
			 r * sqrt(fmax(0, 1 - normal.z * normal.z)));
	return box_around(at, vec3_add(flat, footprint_depth(r, normal)));
}

/* Trees and parts in one block. */
static FootprintMap *arrange(const FootprintParts *parts, const PhotonMap *map)
{
	uint32_t patches = parts->patches.count, discs = parts->disc_count;
	uint32_t most = patches > discs ? patches : discs;
	Box3 *boxes = memory_alloc(sizeof *boxes * ((size_t)most + 1));
	uint32_t *patch_order = memory_alloc(sizeof *patch_order * ((size_t)patches + 1)),
		 *disc_order = memory_alloc(sizeof *disc_order * ((size_t)discs + 1));
	for (uint32_t i = 0; i < patches; i++)
		boxes[i] = footprint_patch_box(&parts->patches.all[i],
					       normal_of(map, parts->patches.all[i].photon));
	FootprintTree patch_tree = make_tree(boxes, patches, patch_order);
	for (uint32_t i = 0; i < discs; i++)
		boxes[i] = disc_box(&parts->discs[i], normal_of(map, parts->discs[i].photon));
	FootprintTree disc_tree = make_tree(boxes, discs, disc_order);
	free(boxes);
	size_t patch_nodes = size_of_nodes(&patch_tree), disc_nodes = size_of_nodes(&disc_tree);
	FootprintMap *f = memory_alloc(sizeof *f + patch_nodes + disc_nodes +
				       sizeof(Patch) * patches + sizeof(Disc) * discs);
	*f = (FootprintMap){.patch_tree = patch_tree,
	                    .disc_tree = disc_tree,
	                    .patch_count = patches,
	                    .least_width = map->spacing > 0 ? 1e-3 * map->spacing : 1e-6};
	char *at = (char *)(f + 1);
	f->patch_tree.nodes = memcpy(at, patch_tree.nodes, patch_nodes);
	f->disc_tree.nodes = memcpy(at += patch_nodes, disc_tree.nodes, disc_nodes);
	f->patches = (Patch *)(at += disc_nodes);
	f->discs = (Disc *)(at + sizeof(Patch) * patches);
	for (uint32_t i = 0; i < patches; i++)
		f->patches[i] = parts->patches.all[patch_order[i]];
	for (uint32_t i = 0; i < discs; i++)
		f->discs[i] = parts->discs[disc_order[i]];
	free(patch_tree.nodes);
	free(disc_tree.nodes);
	free(patch_order);
	free(disc_order);
	return f;
}

static void *footprint_create(const EstimatorSetup *setup, Diag *diag)
{
	(void)diag;
	FootprintParts parts = footprint_parts(setup);
	bool stopped = setup->stop && *setup->stop;
	FootprintMap *f = stopped ? NULL : arrange(&parts, setup->map);
	free(parts.patches.all);
	free(parts.discs);
	return f;
}

/* ---- gathering ---- */

typedef struct Gathering {
	GatherSum sum;
	const FootprintMap *map;
	Window window;
	double radius;
} Gathering;

/* Patches lie in their surface but for how that curves: gather_accepts' bounds, about a corner. */
static void add_patch(Gathering *g, uint32_t number)
{
	const Patch *patch = &g->map->patches[number];
	double share = footprint_patch_share(patch, &g->window);
	if (!(share > 0))
		return;
	const GatherTask *task = g->sum.task;
	const Photon *photon = &task->map->photons[patch->photon];
	double radius = footprint_patch_extent(patch) + sqrt(g->window.area);
	if (!gather_accepts(task->point, photon, radius))
		return;
	gather_add_flux(&g->sum, photon, patch->flux, share / g->window.area);
	g->radius += radius;
}

static void add_patches(void *data, const uint32_t *numbers, int count)
{
	for (int i = 0; i < count; i++)
		add_patch(data, numbers[i]);
}

static void add_disc(Gathering *g, uint32_t number)
{
	const Disc *disc = &g->map->discs[number];
	const GatherTask *task = g->sum.task;
	const Photon *photon = &task->map->photons[disc->photon];
	double x = g->window.at[0] - disc->at[0], y = g->window.at[1] - disc->at[1],
	       z = g->window.at[2] - disc->at[2];
	/* A pixel's variance along an axis is a twelfth of its square, the kernel's a sixth. */
	double radius2 = (double)disc->radius * disc->radius + g->window.area / 2;
	double value = kernel_value(KERNEL_EPANECHNIKOV, (x * x + y * y + z * z) / radius2);
	if (!(value > 0) || !gather_accepts(task->point, photon, sqrt(radius2)))
		return;
	gather_add_flux(&g->sum, photon, disc->flux, value / radius2);
	g->radius += sqrt(radius2);
}

static void add_discs(void *data, const uint32_t *numbers, int count)
{
	for (int i = 0; i < count; i++)
		add_disc(data, numbers[i]);
}

static Gathering begin(const FootprintMap *map, const GatherTask *task)
{
	return (Gathering){.sum = {.task = task}, .map = map,
			   .window = window_around(task->point, map->least_width)};
}

static void footprint_gather(const void *method, const GatherTask *task, GatherResult *result)
{
	const FootprintMap *map = method;
	Vec3 at = task->point->position;
	Gathering g = begin(map, task);
	footprint_tree_visit(&map->patch_tree, box_around(at, g.window.reach), add_patches, &g);
	Vec3 reach = vec3_all(sqrt(g.window.area / 2));
	footprint_tree_visit(&map->disc_tree, box_around(at, reach), add_discs, &g);
	gather_finish(&g.sum, g.sum.photons > 0 ? g.radius / g.sum.photons : 0, result);
}

const EstimatorMethod footprint_method = {"footprint", footprint_create, footprint_gather};
