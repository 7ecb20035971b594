/*
 * Search trees among the points that may be neighbours: one for each sheet, or for each object.
 * In one tree for all, a search on a sheet would walk through all others that lie over it.
 */
#ifndef PHOTON_RELAX_FOREST_H
#define PHOTON_RELAX_FOREST_H

#include "photon/relax_set.h"
#include "photon/tree.h"

/* Knows which points go into one tree; has no trees yet. */
RelaxForest *relax_forest_create(const RelaxSet *set, RelaxSpace space);
/* Makes the trees of where the points are now, in the place of those before. */
void relax_forest_grow(RelaxForest *forest);
void relax_forest_destroy(RelaxForest *forest);
/* Bytes a point of a grown forest, and beside it while it grows. */
TreeRoom relax_forest_room(RelaxSpace space);

/* The count points nearest to a point in that space, itself among them, in no order, in out (room
 * as for photon_tree_nearest; indices into the set's points); returns how many. */
int relax_forest_nearest(const RelaxForest *forest, uint32_t point, int count, Neighbor *out);

#endif
