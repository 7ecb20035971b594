/*
 * Which footprints cover a point: a tree of boxes, eight children a node, over footprints parted
 * by where they are and by their extents, so that a few large ones don't widen the boxes of many
 * small ones. Implicit: the children of box i of a level are the boxes 8 i .. 8 i + 7 of the
 * level below, and below the lowest are the footprints.
 */
#ifndef DENSITY_FOOTPRINT_TREE_H
#define DENSITY_FOOTPRINT_TREE_H

#include <stdint.h>

#include "base/vec.h"

enum { FOOTPRINT_LEVELS = 12 };

/* Eight boxes; empty ones have lo over hi. */
typedef struct FootprintNode { float lo[3][8], hi[3][8]; } FootprintNode;

typedef struct FootprintTree {
	FootprintNode *nodes;
	/* Nodes of each level, from the lowest. */
	uint32_t level_start[FOOTPRINT_LEVELS], level_count[FOOTPRINT_LEVELS];
	int levels;
} FootprintTree;

/* The order in which footprints of these boxes are to stand. */
void footprint_tree_order(const Box3 *boxes, uint32_t count, uint32_t *order);
/* boxes in that order. The nodes are the caller's to free. */
FootprintTree footprint_tree_build(const Box3 *boxes, uint32_t count);

/* Hands over every footprint whose box meets the box, some at a time, in ascending order. */
typedef void FootprintVisit(void *data, const uint32_t *footprints, int count);
void footprint_tree_visit(const FootprintTree *tree, Box3 box, FootprintVisit *visit, void *data);

#endif
