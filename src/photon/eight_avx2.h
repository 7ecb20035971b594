/* Eight lanes for processors with AVX2: what the queries and the cuts of the tree share. To be
 * included behind TREE_HAS_AVX2. */
#ifndef PHOTON_EIGHT_AVX2_H
#define PHOTON_EIGHT_AVX2_H

#pragma GCC target("avx2,bmi,bmi2,popcnt")
#include <immintrin.h>
#include <stdint.h>

#define INLINE static inline __attribute__((always_inline))

/* Lane numbers of the mask's bits, packed to the front. */
INLINE __m256i eight_order(unsigned mask)
{
	uint64_t bytes = _pdep_u64(mask, 0x0101010101010101u) * 0xff;
	uint64_t lanes = _pext_u64(0x0706050403020100u, bytes);
	return _mm256_cvtepu8_epi32(_mm_cvtsi64_si128((long long)lanes));
}

INLINE int eight_sum(__m256i lanes)
{
	__m128i half = _mm_add_epi32(_mm256_castsi256_si128(lanes),
				     _mm256_extracti128_si256(lanes, 1));
	half = _mm_add_epi32(half, _mm_shuffle_epi32(half, _MM_SHUFFLE(1, 0, 3, 2)));
	return _mm_cvtsi128_si32(half) + _mm_extract_epi32(half, 1);
}

#endif
