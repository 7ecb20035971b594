/*
 * What the photons of a pass take of the machine's memory, before they are traced: a scene asks for
 * a thousand times more of them as easily as for ten times.
 */
#ifndef PHOTON_ROOM_H
#define PHOTON_ROOM_H

#include "photon/aim.h"

/* How many photons the machine has room for, with what the scene's relaxation and estimator make of
 * them; at most as many as 32 bits can number. */
uint64_t photon_room(const Scene *scene);
/* About how many photons all these paths leave, and the processor time they take, in seconds: from
 * a few of them, spread evenly, fewer when stopped; zeros from none. */
typedef struct PhotonForecast { double photons, seconds; } PhotonForecast;
PhotonForecast photon_room_forecast(const Scene *scene, const PhotonAims *aims,
			    const PhotonTraceOptions *options);
/* Reports that these paths leave more photons than there is room for, at the place where the scene
 * asks for them. */
void photon_room_refuse(const Scene *scene, const PhotonAims *aims,
			const PhotonTraceOptions *options);

#endif
