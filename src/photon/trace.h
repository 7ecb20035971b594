/*
 * Photon paths: from each light towards the objects that are targets, through specular reflections
 * and refractions by the one scattering interface (surface/bsdf.h), to the diffuse surfaces that
 * collect.
 */
#ifndef PHOTON_TRACE_H
#define PHOTON_TRACE_H

#include "photon/map.h"
#include "scene/scene.h"

typedef struct PhotonTraceOptions {
	uint64_t seed;
	uint64_t
		pass; /* passes of one render use different parts of the low-discrepancy sequence */
	uint64_t count;    /* photons to aim for; 0: as the scene says */
	double scale;      /* of the scene's count; 1 */
	const volatile int *stop;
	Diag *diag;        /* NULL: silent */
} PhotonTraceOptions;

typedef struct PhotonStatistics {
	uint64_t paths, stored, absorbed, escaped, segments;
	double emitted_flux, stored_flux, absorbed_flux,
		escaped_flux; /* sums of grey values, as at the targets: emitted = the rest */
	double seconds, cpu_seconds;
} PhotonStatistics;

void photon_statistics_add(PhotonStatistics *sum, const PhotonStatistics *part);

/* A new map, not yet indexed. NULL when stopped, or when the machine has no room for so many
 * photons, which is reported. statistics may be NULL. */
PhotonMap *photon_trace(const Scene *scene, const PhotonTraceOptions *options,
			PhotonStatistics *statistics);

#endif
