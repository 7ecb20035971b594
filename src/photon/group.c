#include "photon/group.h"

#include <stdlib.h>
#include <string.h>

#include "base/arena.h"

/* Radix sort by digits, from the lowest; such in which no keys differ are left out. Digits are
 * short where few keys are sorted, and for many such that all places in use stay in the cache. */
enum { SHORT = 8, LONG = 11, FEW = 4096 };

typedef struct Entry {
	uint64_t key;
	uint32_t number;
} Entry;

typedef struct Digit { int shift, bits; } Digit;

static unsigned digit_of(uint64_t key, Digit digit)
{
	return key >> digit.shift & ((1u << digit.bits) - 1);
}

static void sort_by(const Entry *from, uint32_t count, Digit digit, Entry *to)
{
	uint32_t starts[1 << LONG], sum = 0;
	memset(starts, 0, sizeof *starts << digit.bits);
	for (uint32_t i = 0; i < count; i++)
		starts[digit_of(from[i].key, digit)]++;
	for (unsigned d = 0; d < 1u << digit.bits; d++) {
		uint32_t own = starts[d];
		starts[d] = sum;
		sum += own;
	}
	for (uint32_t i = 0; i < count; i++)
		to[starts[digit_of(from[i].key, digit)]++] = from[i];
}

void photon_group(const uint64_t *keys, uint32_t count, uint32_t *order)
{
	uint64_t differ = 0;
	size_t size = sizeof(Entry) * ((size_t)count + 1);
	Entry *entries = memory_alloc(size), *other = memory_alloc(size);
	Digit digit = {0, count < FEW ? SHORT : LONG};
	for (uint32_t i = 0; i < count; i++) {
		differ |= keys[i] ^ keys[0];
		entries[i] = (Entry){keys[i], i};
	}
	for (; digit.shift < 64; digit.shift += digit.bits) {
		if (digit_of(differ, digit) == 0)
			continue;
		sort_by(entries, count, digit, other);
		Entry *sorted = other;
		other = entries;
		entries = sorted;
	}
	for (uint32_t i = 0; i < count; i++)
		order[i] = entries[i].number;
	free(entries);
	free(other);
}

uint32_t photon_group_size(const uint32_t *keys, size_t stride, uint32_t count)
{
	uint32_t size = 1;
	while (size < count && *(const uint32_t *)((const char *)keys + size * stride) == *keys)
		size++;
	return size;
}

uint64_t photon_kind(const Photon *photon)
{
	uint64_t landed = (uint64_t)photon->light << 16 | photon->object;
	uint64_t way = (uint64_t)photon->path << 8 | photon->edges;
	return landed << 24 | way;
}

/* Photons sorted by kind, and the kinds' numbers. */
static void sort_by_kind(const PhotonMap *map, uint32_t *photons, uint32_t *kinds)
{
	uint64_t *keys = memory_alloc(sizeof *keys * ((size_t)map->count + 1));
	for (uint32_t i = 0; i < map->count; i++)
		keys[i] = photon_kind(&map->photons[i]);
	photon_group(keys, map->count, photons);
	for (uint32_t i = 0; i < map->count; i++)
		kinds[i] = i > 0 ? kinds[i - 1] + (keys[photons[i]] != keys[photons[i - 1]]) : 0;
	free(keys);
}

/* Photons of a kind along a curve that fills emitter space. */
static void sort_by_place(const PhotonMap *map, uint32_t *photons, uint32_t count)
{
	float (*emitters)[3] = memory_alloc(sizeof *emitters * count);
	uint32_t *order = memory_alloc(sizeof *order * count),
		 *before = memory_alloc(sizeof *before * count);
	memcpy(before, photons, sizeof *before * count);
	for (uint32_t i = 0; i < count; i++)
		memcpy(emitters[i], map->photons[photons[i]].emitter, sizeof *emitters);
	photon_tree_morton(emitters[0], count, sizeof *emitters, order);
	for (uint32_t i = 0; i < count; i++)
		photons[i] = before[order[i]];
	free(emitters);
	free(order);
	free(before);
}

void photon_group_kinds(const PhotonMap *map, uint32_t *photons, uint32_t *kinds)
{
	uint32_t size;
	sort_by_kind(map, photons, kinds);
	for (uint32_t first = 0; first < map->count; first += size) {
		size = photon_group_size(kinds + first, sizeof *kinds, map->count - first);
		sort_by_place(map, photons + first, size);
	}
}
