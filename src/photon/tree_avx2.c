/* The queries for processors with AVX2: eight floats are one register. Nothing on others. */
#include "photon/tree_build.h"

#ifdef TREE_HAS_AVX2

#include <math.h>

#include "photon/eight_avx2.h"

typedef __m256 Eight;

INLINE Eight eight_load(const float *at) { return _mm256_loadu_ps(at); }
INLINE void eight_store(float *at, Eight a) { _mm256_storeu_ps(at, a); }

INLINE Eight square_sum(Eight x, Eight y, Eight z)
{
	return _mm256_add_ps(_mm256_add_ps(_mm256_mul_ps(x, x), _mm256_mul_ps(y, y)),
			     _mm256_mul_ps(z, z));
}

INLINE Eight eight_leaf(const TreeLeaf *leaf, const float p[3])
{
	return square_sum(_mm256_sub_ps(_mm256_load_ps(leaf->at[0]), _mm256_set1_ps(p[0])),
	                  _mm256_sub_ps(_mm256_load_ps(leaf->at[1]), _mm256_set1_ps(p[1])),
	                  _mm256_sub_ps(_mm256_load_ps(leaf->at[2]), _mm256_set1_ps(p[2])));
}

/* How far p is outside of the eight intervals. */
INLINE Eight outside(const TreeBoxes *boxes, int axis, float p)
{
	Eight at = _mm256_set1_ps(p), below = _mm256_sub_ps(_mm256_load_ps(boxes->lo[axis]), at);
	Eight above = _mm256_sub_ps(at, _mm256_load_ps(boxes->hi[axis]));
	return _mm256_max_ps(_mm256_max_ps(below, above), _mm256_setzero_ps());
}

INLINE Eight eight_box(const TreeBoxes *boxes, const float p[3])
{
	return square_sum(outside(boxes, 0, p[0]), outside(boxes, 1, p[1]),
			  outside(boxes, 2, p[2]));
}

INLINE unsigned eight_less(Eight a, float bound)
{
	return (unsigned)_mm256_movemask_ps(_mm256_cmp_ps(a, _mm256_set1_ps(bound), _CMP_LT_OQ));
}

INLINE unsigned eight_most(Eight a, float bound)
{
	return (unsigned)_mm256_movemask_ps(_mm256_cmp_ps(a, _mm256_set1_ps(bound), _CMP_LE_OQ));
}

INLINE Eight turned_min(Eight a)
{
	a = _mm256_min_ps(a, _mm256_permute2f128_ps(a, a, 1));
	a = _mm256_min_ps(a, _mm256_permute_ps(a, _MM_SHUFFLE(1, 0, 3, 2)));
	return _mm256_min_ps(a, _mm256_permute_ps(a, _MM_SHUFFLE(2, 3, 0, 1)));
}

/* The least of a mask's lanes, the first of several; the mask is not 0. */
INLINE unsigned eight_least(Eight a, unsigned mask)
{
	__m256i bits = _mm256_setr_epi32(1, 2, 4, 8, 16, 32, 64, 128);
	__m256i out = _mm256_andnot_si256(_mm256_set1_epi32((int)mask), bits);
	__m256i in = _mm256_cmpeq_epi32(out, _mm256_setzero_si256());
	a = _mm256_blendv_ps(_mm256_set1_ps(INFINITY), a, _mm256_castsi256_ps(in));
	Eight same = _mm256_cmp_ps(a, turned_min(a), _CMP_EQ_OQ);
	return (unsigned)__builtin_ctz((unsigned)_mm256_movemask_ps(same));
}

/* Which of an array's values is the least, the first of several; may read seven beyond. */
INLINE int eight_find_least(float *values, int count)
{
	Eight least = _mm256_set1_ps(INFINITY);
	for (int k = 0; k < TREE_WIDTH; k++)
		values[count + k] = INFINITY;
	for (int i = 0; i < count; i += TREE_WIDTH)
		least = _mm256_min_ps(least, _mm256_loadu_ps(values + i));
	least = turned_min(least);
	for (int i = 0; i < count; i += TREE_WIDTH) {
		Eight same = _mm256_cmp_ps(_mm256_loadu_ps(values + i), least, _CMP_EQ_OQ);
		unsigned mask = (unsigned)_mm256_movemask_ps(same);
		if (mask)
			return i + __builtin_ctz(mask);
	}
	return 0;
}

INLINE unsigned eight_lights(const uint16_t *lights, uint16_t light)
{
	__m128i all = _mm_loadu_si128((const __m128i *)lights);
	__m128i same = _mm_cmpeq_epi16(all, _mm_set1_epi16((short)light));
	return (unsigned)_mm_movemask_epi8(_mm_packs_epi16(same, _mm_setzero_si128()));
}

INLINE void eight_pack(float *out, Eight a, unsigned mask)
{
	_mm256_storeu_ps(out, _mm256_permutevar8x32_ps(a, eight_order(mask)));
}

/* first + lane * step of a mask's lanes. */
INLINE void eight_numbers(uint32_t *out, uint32_t first, uint32_t step, unsigned mask)
{
	__m256i times = _mm256_mullo_epi32(eight_order(mask), _mm256_set1_epi32((int)step));
	_mm256_storeu_si256((__m256i *)out, _mm256_add_epi32(times, _mm256_set1_epi32((int)first)));
}

INLINE void eight_compact(float *distance2, uint32_t *index, Eight d2, const uint32_t *from,
                          unsigned mask)
{
	__m256i lanes = eight_order(mask), all = _mm256_loadu_si256((const __m256i *)from);
	_mm256_storeu_ps(distance2, _mm256_permutevar8x32_ps(d2, lanes));
	_mm256_storeu_si256((__m256i *)index, _mm256_permutevar8x32_epi32(all, lanes));
}

INLINE void eight_pairs(Neighbor *out, Eight d2, const uint32_t *from, unsigned mask)
{
	__m256i lanes = eight_order(mask), all = _mm256_loadu_si256((const __m256i *)from);
	__m256i a = _mm256_permutevar8x32_epi32(_mm256_castps_si256(d2), lanes);
	__m256i b = _mm256_permutevar8x32_epi32(all, lanes);
	__m256i low = _mm256_unpacklo_epi32(a, b), high = _mm256_unpackhi_epi32(a, b);
	_mm256_storeu_si256((__m256i *)out, _mm256_permute2x128_si256(low, high, 0x20));
	_mm256_storeu_si256((__m256i *)(out + 4), _mm256_permute2x128_si256(low, high, 0x31));
}

INLINE int eight_count(const float *values, int count, float bound)
{
	__m256i lanes = _mm256_setzero_si256();
	Eight least = _mm256_set1_ps(bound);
	for (int i = 0; i < count; i += TREE_WIDTH) {
		Eight less = _mm256_cmp_ps(_mm256_loadu_ps(values + i), least, _CMP_LT_OQ);
		lanes = _mm256_sub_epi32(lanes, _mm256_castps_si256(less));
	}
	return eight_sum(lanes);
}

/* The largest finite one. */
INLINE float eight_farthest(const float *values, int count)
{
	Eight most = _mm256_setzero_ps(), infinite = _mm256_set1_ps(INFINITY);
	for (int i = 0; i < count; i += TREE_WIDTH) {
		Eight a = _mm256_loadu_ps(values + i);
		most = _mm256_max_ps(most,
				     _mm256_and_ps(a, _mm256_cmp_ps(a, infinite, _CMP_LT_OQ)));
	}
	Eight negative = turned_min(_mm256_sub_ps(_mm256_setzero_ps(), most));
	return -_mm256_cvtss_f32(negative);
}

#define QUERY_NEAREST tree_nearest_avx2
#define QUERY_WITHIN tree_within_avx2
#include "photon/tree_query.h"

#endif
