/*
 * Radially symmetric kernels over the unit disc, each of integral one, as functions of t2 =
 * (distance / radius)^2:
 *
 *   uniform        1 / pi
 *   cone           3 / pi (1 - t)                   (Jensen 1996)
 *   epanechnikov   2 / pi (1 - t^2)                 (Silverman 1986)
 *   gaussian       exp(-t^2 / 2 s^2) / normaliser,  cut at the disc, s = 0.4
 *
 * A flux times the kernel over radius^2 is flux per area.
 */
#ifndef DENSITY_KERNEL_H
#define DENSITY_KERNEL_H

#include "scene/photon_settings.h"

/* 0 at and beyond t2 = 1. The isotropic kernel of the adaptive method is the gaussian here. */
double kernel_value(EstimatorKernel kernel, double t2);

#endif
