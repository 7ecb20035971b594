#include "photon/tree.h"

#include <stdlib.h>

#include "photon/tree_order.h"

void photon_tree_destroy(PhotonTree *tree)
{
	if (!tree)
		return;
	for (int i = 0; i < tree->level_count; i++) {
		free(tree->levels[i].boxes);
		free(tree->levels[i].emitter_boxes);
	}
	free(tree->leaves);
	free(tree->emitters);
	free(tree->lights);
	free(tree);
}

TreeRoom photon_tree_room(bool with_emitters)
{
	const double all_levels = 1.0 / (TREE_WIDTH - 1); /* nodes beside leaves: 1/8, 1/64... */
	int spaces = with_emitters ? 2 : 1;
	double nodes = (sizeof(TreeLeaf) + sizeof(TreeBoxes) * all_levels) / TREE_WIDTH;
	double lights = with_emitters ? sizeof(uint16_t) : 0;
	return (TreeRoom){spaces * nodes + lights, tree_order_room(3 * spaces)};
}

void photon_tree_order(const PhotonTree *tree, uint32_t *order)
{
	for (uint32_t i = 0; i < tree->count; i++)
		order[i] = tree->leaves[i / TREE_WIDTH].index[i % TREE_WIDTH];
}

float photon_tree_farthest(const Neighbor *found, int count)
{
	float farthest = 0;
	for (int i = 0; i < count; i++)
		farthest = found[i].distance2 > farthest ? found[i].distance2 : farthest;
	return farthest;
}

int photon_tree_nearest(const PhotonTree *tree, const NearestQuery *query, Neighbor *out)
{
#ifdef TREE_HAS_AVX2
	if (tree_has_avx2())
		return tree_nearest_avx2(tree, query, out);
#endif
	return tree_nearest_plain(tree, query, out);
}

void photon_tree_within(const PhotonTree *tree, const float center[3], float radius,
			TreeVisit *visit, void *data)
{
	WithinQuery query = {{center[0], center[1], center[2]}, radius};
#ifdef TREE_HAS_AVX2
	if (tree_has_avx2()) {
		tree_within_avx2(tree, &query, visit, data);
		return;
	}
#endif
	tree_within_plain(tree, &query, visit, data);
}
