/*
 * A smooth map from an emitter's parameters to a surface, fitted to a photon's neighbours: to
 * second order,
 *
 *   x(d) = J d + d H d / 2,     two coordinates each of d (parameters) and x (the surface's plane),
 *
 * and to second order of hue where that differs,
 *
 * by weighted least squares through the photon itself, which is the origin of both.
 */
#ifndef DENSITY_FOOTPRINT_FIT_H
#define DENSITY_FOOTPRINT_FIT_H

#include <stdbool.h>

typedef struct FitSample {
	double d[2]; /* in the parameters, relative to the photon, up to about 1 */
	double x[2]; /* on the surface, relative to the photon */
	double hue;  /* relative to the photon */
} FitSample;

typedef struct FootprintFit {
	double jacobian[2][2]; /* of coordinate i by parameter j */
	double hue[2];       /* first derivative by hue */
	double roughness;    /* residual's share of the samples' mean square, 0..1 */
} FootprintFit;

enum { FIT_MOST_SAMPLES = 64 };

/* False when the samples don't say: fewer than six or in a line. */
bool footprint_fit(const FitSample *samples, int count, FootprintFit *fit);

#endif
