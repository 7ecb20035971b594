/* One photon path, from the light to where it is absorbed or lost. */
#ifndef PHOTON_PATH_H
#define PHOTON_PATH_H

#include "photon/aim.h"

/* Photons stored so far by one worker, and what became of its paths. */
typedef struct PhotonBuffer {
	Photon *photons;
	uint32_t count, capacity;
	PhotonStatistics statistics;
} PhotonBuffer;

/* number: of the path among all of the aim's. */
void photon_path(const Scene *scene, const PhotonAim *aim, const PhotonTraceOptions *options,
		 uint64_t number, PhotonBuffer *out);

#endif
