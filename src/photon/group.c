#include "photon/group.h"

#include <stdlib.h>
#include <string.h>

#include "base/arena.h"

/* Radix sort by digits of sixteen bits, from the lowest; such in which no keys differ are left
 * out. */
enum { BITS = 16, DIGITS = 1 << BITS };

static unsigned digit_of(uint64_t key, int shift) { return key >> shift & (DIGITS - 1); }

/* Where each digit's numbers start. */
static void count_digits(const uint64_t *keys, uint32_t count, int shift, uint32_t *starts)
{
	uint32_t sum = 0;
	memset(starts, 0, sizeof *starts * DIGITS);
	for (uint32_t i = 0; i < count; i++)
		starts[digit_of(keys[i], shift)]++;
	for (int digit = 0; digit < DIGITS; digit++) {
		uint32_t own = starts[digit];
		starts[digit] = sum;
		sum += own;
	}
}

void photon_group(const uint64_t *keys, uint32_t count, uint32_t *order)
{
	uint64_t differ = 0;
	uint32_t *starts = memory_alloc(sizeof *starts * DIGITS),
		 *before = memory_alloc(sizeof *before * ((size_t)count + 1));
	for (uint32_t i = 0; i < count; i++) {
		differ |= keys[i] ^ keys[0];
		order[i] = i;
	}
	for (int shift = 0; shift < 64; shift += BITS) {
		if (digit_of(differ, shift) == 0)
			continue;
		memcpy(before, order, sizeof *before * count);
		count_digits(keys, count, shift, starts);
		for (uint32_t i = 0; i < count; i++)
			order[starts[digit_of(keys[before[i]], shift)]++] = before[i];
	}
	free(starts);
	free(before);
}

uint64_t photon_kind(const Photon *photon)
{
	uint64_t landed = (uint64_t)photon->light << 16 | photon->object;
	uint64_t way = (uint64_t)photon->path << 8 | photon->edges;
	return landed << 24 | way;
}
