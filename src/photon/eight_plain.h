/* Eight lanes for any processor: what the queries and the cuts of the tree share. */
#ifndef PHOTON_EIGHT_PLAIN_H
#define PHOTON_EIGHT_PLAIN_H

#include "photon/tree_build.h"

#define INLINE static inline __attribute__((always_inline))

/* A bit for each lane i of which the condition holds. */
#define EIGHT_MASK(condition)                                                    \
	({                                                                       \
		unsigned mask_ = 0;                                              \
		for (int i = 0; i < TREE_WIDTH; i++)                             \
			mask_ |= (unsigned)(condition) << i;                     \
		mask_;                                                           \
	})

typedef struct EightLanes { int32_t at[TREE_WIDTH]; } EightLanes;

/* Lane numbers of the mask's bits, packed to the front; behind them stands anything. */
INLINE EightLanes eight_order(unsigned mask)
{
	EightLanes order = {{0}};
	for (int i = 0, count = 0; i < TREE_WIDTH; i++) {
		order.at[count] = i; /* count <= i */
		count += mask >> i & 1;
	}
	return order;
}

#endif
