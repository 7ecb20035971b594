/*
 * Features of the caustic: how freely each photon may move across the structure it lies on
 * (Spencer & Jones 2013, sections 4.2 and 4.3). Inside the room, but for its tests.
 */
#ifndef PHOTON_FEATURES_H
#define PHOTON_FEATURES_H

#include "photon/relax_set.h"

/* Points in the tangent plane about a photon, and what their covariance says. */
typedef struct FeatureAxes {
	double l1, l2; /* l1 >= l2 >= 0, per square of the kernel's radius: a uniform disc has 1/4
			  both */
	double u[2];     /* unit vector of l1 */
} FeatureAxes;

/* Principal components of count points, relative to their mean; radius: of the kernel. */
FeatureAxes feature_axes(const double (*points)[2], int count, double radius);
/* Length of v_b for l2 found among count neighbours: in [0, 1] for any input (SJ13 eq. 7). */
double feature_freedom(double l2, int count);

/* The search range of every point (SJ13 eq. 1), then its basis. */
void features_detect(RelaxSet *set, const Relaxation *settings);

#endif
