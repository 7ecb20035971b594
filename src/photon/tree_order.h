/*
 * Putting the tree's points in order: the parts of it that are compiled for several instruction
 * sets. Points are columns, one a dimension, of keys that rise with the floats; the last column
 * holds the points' numbers. They lie on two sides: a cut leaves the nearer part on the side
 * where it is and takes the farther one to the other, so that nothing is copied twice.
 */
#ifndef PHOTON_TREE_ORDER_H
#define PHOTON_TREE_ORDER_H

#include <stddef.h>
#include <string.h>

#include "photon/tree_build.h"

enum { TREE_COLUMNS = 7 };

/* Points from `first` on; every column has room for a register's width behind the last point.
 * first is a multiple of TREE_WIDTH, and so is the count unless these are the last points. */
typedef struct TreeRun {
	int32_t *here[TREE_COLUMNS], *there[TREE_COLUMNS]; /* at the run's first point */
	int dimensions;                                    /* columns without the numbers */
	uint32_t count;
} TreeRun;

/* Least and greatest key of each dimension. */
typedef struct TreeExtent { int32_t lo[TREE_COLUMNS], hi[TREE_COLUMNS]; } TreeExtent;

/* An involution: the order of keys is that of the floats, and total. */
static inline int32_t tree_key(float value)
{
	int32_t bits;
	memcpy(&bits, &value, sizeof bits);
	return bits ^ ((bits >> 31) & INT32_MAX);
}

static inline float tree_value(int32_t key)
{
	float value;
	key ^= (key >> 31) & INT32_MAX;
	memcpy(&value, &key, sizeof value);
	return value;
}

/* What finds a run's extent; what cuts it: the `left` points that come first along the axis stay
 * here, the others go there, as far behind the run's start. Equal keys go by number. Both parts
 * keep the order in which their points stood. */
typedef struct TreeOrderer {
	void (*extent)(const TreeRun *run, TreeExtent *extent);
	void (*cut)(const TreeRun *run, int axis, uint32_t left);
} TreeOrderer;

#ifdef TREE_HAS_AVX2
extern const TreeOrderer tree_orderer_avx2;
#endif
extern const TreeOrderer tree_orderer_plain;

/* Fills in leaves and boxes, for which there is memory. */
void tree_order(PhotonTree *tree, const TreePoints *points, const TreeOrderer *orderer);
/* Bytes a point that it needs for that. */
double tree_order_room(int dimensions);
/* As photon_tree_create, which chooses the orderer. */
PhotonTree *tree_create(const TreePoints *points, const TreeOrderer *orderer);

#endif
