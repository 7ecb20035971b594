/*
 * Photons that belong together, one group after another.
 */
#ifndef PHOTON_GROUP_H
#define PHOTON_GROUP_H

#include <stdint.h>

#include "photon/map.h"

/* Puts the numbers 0 to count - 1 in the order of their keys; those of equal keys stay in theirs.
 */
void photon_group(const uint64_t *keys, uint32_t count, uint32_t *order);

/* Photons of one kind have equal keys, and only they: one light, the same way and number of edges,
 * one object that they landed on. Sorted by it a light's kinds are together. */
uint64_t photon_kind(const Photon *photon);

#endif
