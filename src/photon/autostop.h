/*
 * POV-Ray's autostop: photons leave a light in ever wider circles around its target's middle, and
 * end with the first circle that misses the target, once the circles are wider than a share of its
 * bounds and some photon has met it (manual, section "Autostop"). Here the circles only find out
 * how wide the cap or disc is that is shot at.
 */
#ifndef PHOTON_AUTOSTOP_H
#define PHOTON_AUTOSTOP_H

#include "photon/aim.h"

/* The share of the aim's region, from its middle, in (0, 1]; 1 as well where there are no circles:
 * in a light's own cone, and around a light that stands within the target's bounds. */
double photon_autostop(const Scene *scene, const PhotonAim *aim);

#endif
