/*
 * Photons that belong together, one group after another.
 */
#ifndef PHOTON_GROUP_H
#define PHOTON_GROUP_H

#include <stddef.h>
#include <stdint.h>

#include "photon/map.h"

/* Puts the numbers 0 to count - 1 in the order of their keys; those of equal keys stay in theirs.
 */
void photon_group(const uint64_t *keys, uint32_t count, uint32_t *order);

/* How many of these records, the first on, have the first's key; keys are `stride` bytes apart.
 * count: at least one. */
uint32_t photon_group_size(const uint32_t *keys, size_t stride, uint32_t count);

/* Photons of one kind have equal keys, and only they: one light, the same way and number of edges,
 * one object that they landed on. Sorted by it a light's kinds are together. */
uint64_t photon_kind(const Photon *photon);

/* The map's photons by kind, those of a kind along a curve that fills emitter space; and of each of
 * these the number of its kind, 0 on. Both arrays have room for as many numbers as photons. */
void photon_group_kinds(const PhotonMap *map, uint32_t *photons, uint32_t *kinds);

#endif
