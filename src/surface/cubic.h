/* Catmull and Rom's cubic through values that are one apart. */
#ifndef SURFACE_CUBIC_H
#define SURFACE_CUBIC_H

/* The weights of the values at -1, 0, 1 and 2, at t in 0..1. */
static inline void cubic_weights(double t, double w[4])
{
	w[0] = t * (-0.5 + t * (1 - 0.5 * t));
	w[1] = 1 + t * t * (-2.5 + 1.5 * t);
	w[2] = t * (0.5 + t * (2 - 1.5 * t));
	w[3] = t * t * (-0.5 + 0.5 * t);
}

#endif
