/* The inside of the search tree: what its build fills in and its queries read. */
#ifndef PHOTON_TREE_BUILD_H
#define PHOTON_TREE_BUILD_H

#include <stdbool.h>
#include <stddef.h>

#include "photon/tree.h"

/* Eight fill a 256-bit register with floats; ten levels of them hold 8^10 leaves. */
enum { TREE_WIDTH = 8, TREE_MAX_LEVELS = 10 };

/* Eight points in two cache lines; missing ones are infinitely far away. */
typedef struct TreeLeaf {
	float at[3][TREE_WIDTH];
	uint32_t index[TREE_WIDTH]; /* as given */
} TreeLeaf;

/* The boxes of a node's eight children; missing ones are empty (lo = inf, hi = -inf). */
typedef struct TreeBoxes {
	float lo[3][TREE_WIDTH], hi[3][TREE_WIDTH];
} TreeBoxes;

/* levels[0] holds the boxes of leaves, levels[1] of those nodes, and so on up to one root. */
typedef struct TreeLevel {
	TreeBoxes *boxes, *emitter_boxes;
	uint32_t count;
} TreeLevel;

struct PhotonTree {
	uint32_t count, leaf_count;
	TreeLeaf *leaves, *emitters;
	uint16_t *lights;
	TreeLevel levels[TREE_MAX_LEVELS];
	int level_count;
};

/* Memory of a multiple of 64 bytes, aligned to it; for free(). */
void *tree_alloc(size_t count, size_t size);

typedef struct WithinQuery {
	float center[3], radius;
} WithinQuery;

/* The queries, compiled for several instruction sets; photon/tree.c chooses. */
#if defined(__x86_64__) && defined(__GNUC__)
#define TREE_HAS_AVX2 1
static inline bool tree_has_avx2(void)
{
	return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("bmi2");
}
int tree_nearest_avx2(const PhotonTree *tree, const NearestQuery *query, Neighbor *out);
void tree_within_avx2(const PhotonTree *tree, const WithinQuery *query, TreeVisit *visit,
                      void *data);
#endif
int tree_nearest_plain(const PhotonTree *tree, const NearestQuery *query, Neighbor *out);
void tree_within_plain(const PhotonTree *tree, const WithinQuery *query, TreeVisit *visit,
                      void *data);

#endif
