/*
 * Each photon's own footprint. Photons of one light that went the same way (same objects, same flat
 * faces, same events) to the same object sample one map from emitter coordinates (Spencer & Jones
 * 2013, section 4.1) to the surface. From its neighbours in emitter space a photon knows that map
 * nearby, and so the ellipse over which its share of the light spreads (footprint_shape.c): photon
 * differentials (Schjøth et al. 2007) without tracing any. Density is the sum of flux times the
 * ellipses' normalised kernels over those that cover the gather point.
 *
 * Where glass has parted the light, one photon has several: one for each band of hues
 * (footprint_hue.h).
 *
 * In a progressive pass all shares shrink in proportion to the pass' radius, so the mean over
 * passes converges as Knaus & Zwicker's does: a kernel keeps its integral and its place whatever
 * its shape.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/arena.h"
#include "density/footprint_shape.h"
#include "density/footprint_tree.h"
#include "density/gather.h"

typedef struct FootprintMap {
	FootprintTree tree;
	uint32_t count;
	Footprint *footprints;
} FootprintMap;

/* In the tree's order, in one block with it. */
static FootprintMap *arrange(const Footprint *footprints, const Box3 *boxes, uint32_t count)
{
	uint32_t *order = memory_alloc(sizeof *order * (count + 1));
	Box3 *ordered = memory_alloc(sizeof *ordered * (count + 1));
	footprint_tree_order(boxes, count, order);
	for (uint32_t i = 0; i < count; i++)
		ordered[i] = boxes[order[i]];
	FootprintTree tree = footprint_tree_build(ordered, count);
	size_t nodes = tree.levels > 0 ? tree.level_start[tree.levels - 1] + 1u : 0;
	size_t size = sizeof(FootprintMap) + sizeof(FootprintNode) * nodes + sizeof(Footprint) * count;
	FootprintMap *f = memory_alloc(size);
	*f = (FootprintMap){.tree = tree, .count = count};
	f->tree.nodes = (FootprintNode *)(f + 1);
	f->footprints = (Footprint *)(f->tree.nodes + nodes);
	memcpy(f->tree.nodes, tree.nodes, sizeof(FootprintNode) * nodes);
	for (uint32_t i = 0; i < count; i++)
		f->footprints[i] = footprints[order[i]];
	free(tree.nodes);
	free(ordered);
	free(order);
	return f;
}

static void *footprint_create(const EstimatorSetup *setup, Diag *diag)
{
	(void)diag;
	const PhotonMap *map = setup->map;
	FootprintList list = footprint_shapes(setup);
	Box3 *boxes = memory_alloc(sizeof *boxes * (list.count + 1));
	for (uint32_t i = 0; i < list.count; i++)
		boxes[i] = footprint_box(&list.all[i], photon_normal(&map->photons[list.all[i].photon]));
	FootprintMap *f = arrange(list.all, boxes, list.count);
	free(boxes);
	free(list.all);
	return f;
}

/* ---- gathering ---- */

typedef struct Gathering {
	GatherSum sum;
	const FootprintMap *map;
	float at[3];
	double pixel2; /* what a pixel adds to an axis' square */
	double radius;
} Gathering;

static void add_footprint(Gathering *g, uint32_t number)
{
	const Footprint *f = &g->map->footprints[number];
	const float x[3] = {g->at[0] - f->at[0], g->at[1] - f->at[1], g->at[2] - f->at[2]};
	const GatherTask *task = g->sum.task;
	const Photon *photon = &task->map->photons[f->photon];
	double radius, value = footprint_value(f, x, g->pixel2, &radius);
	if (!(value > 0) || !gather_accepts(task->point, photon, radius))
		return;
	gather_add_flux(&g->sum, photon, f->flux, value);
	g->radius += radius;
}

static void add_footprints(void *data, const uint32_t *numbers, int count)
{
	for (int i = 0; i < count; i++)
		add_footprint(data, numbers[i]);
}

static void footprint_gather(const void *method, const GatherTask *task, GatherResult *result)
{
	Vec3 p = task->point->position;
	double width = task->point->footprint, pixel2 = width * width / 12 / footprint_variance;
	Gathering g = {.sum = {.task = task}, .map = method, .pixel2 = pixel2,
	               .at = {(float)p.x, (float)p.y, (float)p.z}};
	Vec3 reach = vec3_all(sqrt(pixel2));
	Box3 box = {vec3_sub(p, reach), vec3_add(p, reach)};
	footprint_tree_visit(&g.map->tree, box, add_footprints, &g);
	gather_finish(&g.sum, g.sum.photons > 0 ? g.radius / g.sum.photons : 0, result);
}

const EstimatorMethod footprint_method = {"footprint", footprint_create, footprint_gather};
