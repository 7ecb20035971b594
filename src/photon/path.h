/* Photon paths, from the light to where they are absorbed or lost. */
#ifndef PHOTON_PATH_H
#define PHOTON_PATH_H

#include "photon/aim.h"

/* Photons stored so far by one worker, and what became of its paths. */
typedef struct PhotonBuffer {
	Photon *photons;
	uint32_t count, capacity;
	PhotonStatistics statistics;
} PhotonBuffer;

/* Paths of an aim, from number `first` on. */
void photon_paths(const Scene *scene, const PhotonAim *aim, const PhotonTraceOptions *options,
		  uint64_t first, uint64_t count, PhotonBuffer *out);

#endif
