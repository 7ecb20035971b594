/*
 * A small hierarchy of boxes over numbered items, for rays and points inside compound shapes (CSG
 * with many children, blobs, meshes of segments). Items with unbounded boxes are kept aside and
 * always visited; empty boxes never.
 */
#ifndef GEOM_BOX_TREE_H
#define GEOM_BOX_TREE_H

#include "base/arena.h"
#include "geom/ray_box.h"

typedef struct BoxTree BoxTree;

/* Called for an item whose box the ray or point may touch; true stops the walk. */
typedef bool BoxTreeVisit(void *data, int item);

/* Over items 0 to count - 1. In the arena; the boxes are the caller's. */
const BoxTree *box_tree_create(Arena *arena, const Box3 *boxes, int count);
/* The visitor may lower ray->tmax to skip what lies farther. True when it stopped the walk. */
bool box_tree_walk_ray(const BoxTree *tree, const RaySlabs *ray, BoxTreeVisit *visit, void *data);
/* The same for what may hold a point. */
bool box_tree_walk_point(const BoxTree *tree, Vec3 p, BoxTreeVisit *visit, void *data);

#endif
