/*
 * The search tree of the photon map: points in world space, each with emitter coordinates of up to
 * three dimensions (5-D and 6-D trees of Spencer & Jones 2013, section 4.1).
 *
 * Eight children a node, eight points a leaf, all full but the last: the points are ordered so
 * that every aligned run of 8, 64, 512... of them is compact, and the tree is implicit in that
 * order. Boxes and points are stored as structures of arrays, so one vector operation looks at
 * eight of them.
 *
 * The same points give the same tree for any number of threads. Queries may run in any number of
 * threads at once; query points that follow a space-filling curve (photon_tree_morton) find the
 * nodes in the cache.
 */
#ifndef PHOTON_TREE_H
#define PHOTON_TREE_H

#include <stdbool.h>
#include <stdint.h>

typedef struct PhotonTree PhotonTree;

typedef struct TreePoints {
	const float *position; /* count points of three floats, stride bytes apart */
	const float *emitter;  /* the same with emitter coordinates, unused ones 0; NULL: none */
	const uint16_t
		*light; /* emitter each comes from, stride bytes apart; NULL with emitter NULL */
	uint32_t count, stride;
	float emitter_weight; /* how much an emitter dimension's extent counts beside a world one's
			       * when the build chooses what to split: 0: never by emitter
			       * coordinates */
} TreePoints;

typedef struct Neighbor {
	float distance2; /* in world space */
	uint32_t index;  /* of the point as it was given */
} Neighbor;

/* What a neighbour's emitter coordinates must be: of the same light and within a radius. */
typedef struct EmitterRange {
	float center[3], radius2;
	uint16_t light;
} EmitterRange;

/* Of any number of points, which are the caller's and may go. */
PhotonTree *photon_tree_create(const TreePoints *points);
void photon_tree_destroy(PhotonTree *tree); /* NULL is allowed */

/* Bytes a point of many: of a tree, and beside it while it is created. */
typedef struct TreeRoom {
	double kept, building;
} TreeRoom;

TreeRoom photon_tree_room(bool with_emitters);

/* The points' numbers in the tree's order, in which runs of 8, 64, 512... of them are compact. */
void photon_tree_order(const PhotonTree *tree, uint32_t *order);

/* The count nearest points nearer than sqrt(max_distance2), in no order, in out (room for
 * count + 8 x TREE_SLACK of them); returns how many. range: NULL for no constraint. The
 * farthest of a full set bounds the kernel: photon_tree_farthest. */
enum { TREE_SLACK = 32 };
typedef struct NearestQuery {
	float center[3], max_distance2;
	int count;
	const EmitterRange *range;
} NearestQuery;

int photon_tree_nearest(const PhotonTree *tree, const NearestQuery *query, Neighbor *out);
/* The greatest squared distance of those found; 0 of none. */
float photon_tree_farthest(const Neighbor *found, int count);

/* Hands over every point nearer than the radius, some at a time. */
typedef void TreeVisit(void *data, const Neighbor *found, int count);
void photon_tree_within(const PhotonTree *tree, const float center[3], float radius,
			TreeVisit *visit, void *data);

/* The order in which points follow a space-filling curve (Morton 1966): order gets count
 * indices; ties by index. */
void photon_tree_morton(const float *position, uint32_t count, uint32_t stride, uint32_t *order);

#endif
