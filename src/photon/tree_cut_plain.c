/* Extents and cuts for any processor. */
#include "photon/tree_order.h"

#include "photon/eight_plain.h"

typedef EightLanes Eight;

INLINE Eight lanes_load(const int32_t *at)
{
	Eight a;
	memcpy(a.at, at, sizeof a.at);
	return a;
}

INLINE void lanes_store(int32_t *at, Eight a) { memcpy(at, a.at, sizeof a.at); }

INLINE Eight lanes_min(Eight a, Eight b)
{
	for (int i = 0; i < TREE_WIDTH; i++)
		a.at[i] = b.at[i] < a.at[i] ? b.at[i] : a.at[i];
	return a;
}

INLINE Eight lanes_max(Eight a, Eight b)
{
	for (int i = 0; i < TREE_WIDTH; i++)
		a.at[i] = b.at[i] > a.at[i] ? b.at[i] : a.at[i];
	return a;
}

INLINE int32_t lanes_least(Eight a)
{
	int32_t least = a.at[0];
	for (int i = 1; i < TREE_WIDTH; i++)
		least = a.at[i] < least ? a.at[i] : least;
	return least;
}

INLINE int32_t lanes_most(Eight a)
{
	int32_t most = a.at[0];
	for (int i = 1; i < TREE_WIDTH; i++)
		most = a.at[i] > most ? a.at[i] : most;
	return most;
}

INLINE unsigned lanes_below(Eight a, int32_t b) { return EIGHT_MASK(a.at[i] < b); }
INLINE unsigned lanes_equal(Eight a, int32_t b) { return EIGHT_MASK(a.at[i] == b); }

INLINE Eight lanes_moved(Eight a, Eight order)
{
	Eight moved;
	for (int i = 0; i < TREE_WIDTH; i++)
		moved.at[i] = a.at[order.at[i]];
	return moved;
}

INLINE void lanes_store_some(int32_t *at, Eight a, int count)
{
	memcpy(at, a.at, sizeof *at * (size_t)count);
}

INLINE uint32_t lanes_count(const int32_t *keys, uint32_t count, int32_t bound)
{
	uint32_t sum = 0;
	for (uint32_t i = 0; i < count; i++)
		sum += keys[i] < bound;
	return sum;
}

#define ORDERER tree_orderer_plain
#include "photon/tree_cut.h"
