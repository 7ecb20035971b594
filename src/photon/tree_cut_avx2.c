/* Extents and cuts for processors with AVX2: eight numbers are one register. Nothing on others. */
#include "photon/tree_order.h"

#ifdef TREE_HAS_AVX2

#include "photon/eight_avx2.h"

typedef __m256i Eight;

INLINE Eight lanes_load(const int32_t *at) { return _mm256_loadu_si256((const __m256i *)at); }
INLINE void lanes_store(int32_t *at, Eight a) { _mm256_storeu_si256((__m256i *)at, a); }
INLINE Eight lanes_min(Eight a, Eight b) { return _mm256_min_epi32(a, b); }
INLINE Eight lanes_max(Eight a, Eight b) { return _mm256_max_epi32(a, b); }

INLINE int32_t lanes_least(Eight a)
{
	__m128i half = _mm_min_epi32(_mm256_castsi256_si128(a), _mm256_extracti128_si256(a, 1));
	half = _mm_min_epi32(half, _mm_shuffle_epi32(half, _MM_SHUFFLE(1, 0, 3, 2)));
	half = _mm_min_epi32(half, _mm_shuffle_epi32(half, _MM_SHUFFLE(2, 3, 0, 1)));
	return _mm_cvtsi128_si32(half);
}

INLINE int32_t lanes_most(Eight a)
{
	return ~lanes_least(_mm256_xor_si256(a, _mm256_set1_epi32(-1)));
}

INLINE unsigned lanes_mask(Eight a) { return (unsigned)_mm256_movemask_ps(_mm256_castsi256_ps(a)); }

INLINE unsigned lanes_below(Eight a, int32_t b)
{
	return lanes_mask(_mm256_cmpgt_epi32(_mm256_set1_epi32(b), a));
}

INLINE unsigned lanes_equal(Eight a, int32_t b)
{
	return lanes_mask(_mm256_cmpeq_epi32(a, _mm256_set1_epi32(b)));
}

INLINE Eight lanes_moved(Eight a, Eight order) { return _mm256_permutevar8x32_epi32(a, order); }

INLINE void lanes_store_some(int32_t *at, Eight a, int count)
{
	__m256i lanes = _mm256_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7);
	_mm256_maskstore_epi32(at, _mm256_cmpgt_epi32(_mm256_set1_epi32(count), lanes), a);
}

INLINE uint32_t lanes_count(const int32_t *keys, uint32_t count, int32_t bound)
{
	__m256i sums = _mm256_setzero_si256(), all = _mm256_set1_epi32(bound);
	uint32_t i = 0;
	for (; i + TREE_WIDTH <= count; i += TREE_WIDTH)
		sums = _mm256_sub_epi32(sums, _mm256_cmpgt_epi32(all, lanes_load(keys + i)));
	uint32_t sum = (uint32_t)eight_sum(sums);
	for (; i < count; i++)
		sum += keys[i] < bound;
	return sum;
}

#define ORDERER tree_orderer_avx2
#include "photon/tree_cut.h"

#endif
