/* Sums of bells: blobs, and ellipsoids along the three axes combined in several ways. */
#include <math.h>

#include "surface/function_internal.h"

/* A component of radius 1 / inverse_radius around (x, 0, 0): (1 - (d / radius)^2)^2 inside, 0
 * outside. */
static double component(const double *a, double x, double strength, double inverse_radius)
{
	double dx = a[0] - x;
	double fall = 1 - (dx * dx + a[1] * a[1] + a[2] * a[2]) * inverse_radius * inverse_radius;
	return fall > 0 ? strength * fall * fall : 0;
}

/* Distance of the two components, strength and inverse radius of each. */
static double blob(const void *data, const double *a)
{
	(void)data;
	return -component(a, -a[3] / 2, a[4], a[5]) - component(a, a[3] / 2, a[6], a[7]);
}

/* Separation, inverse size, strength, threshold. */
static double blob2(const void *data, const double *a)
{
	(void)data;
	double around = a[1] * a[1] + a[2] * a[2], x = a[0] - a[3];
	return a[6] - a[5] * (exp(-a[4] * (a[0] * a[0] + around)) + exp(-a[4] * (x * x + around)));
}

/* Squared "radii" of the ellipsoids whose axis is x, y and z: the other two squares count
 * eccentricity times. */
static void ellipsoids(const double *a, double eccentricity, double out[3])
{
	double x = a[0] * a[0], y = a[1] * a[1], z = a[2] * a[2];
	out[0] = x + eccentricity * (y + z);
	out[1] = y + eccentricity * (z + x);
	out[2] = z + eccentricity * (x + y);
}

/* Eccentricity, inverse size, diameter, threshold: of this and the next two. */
static double cross_ellipsoids(const void *data, const double *a)
{
	(void)data;
	double q[3];
	ellipsoids(a, a[3], q);
	return a[6] - a[5] * exp(-a[4] * fmin(q[0], fmin(q[1], q[2])));
}

static double isect_ellipsoids(const void *data, const double *a)
{
	(void)data;
	double q[3];
	ellipsoids(a, a[3], q);
	return a[6] - a[5] * exp(-a[4] * fmax(q[0], fmax(q[1], q[2])));
}

static double flange_cover(const void *data, const double *a)
{
	(void)data;
	double q[3];
	ellipsoids(a, a[3], q);
	return a[6] - a[5] * (exp(-a[4] * q[0]) + exp(-a[4] * q[1]) + exp(-a[4] * q[2]));
}

/* Spikiness, hollowness, size, roundness, fatness. */
static double spikes(const void *data, const double *a)
{
	(void)data;
	double q[3], rr = a[0] * a[0] + a[1] * a[1] + a[2] * a[2];
	ellipsoids(a, a[3], q);
	return a[5] *
	       (exp(-a[4] * q[0]) + exp(-a[4] * q[1]) + exp(-a[4] * q[2]) - a[7] * exp(-a[6] * rr));
}

/* Height, frequency in x and z, fall-off. */
static double spikes_2d(const void *data, const double *a)
{
	(void)data;
	return a[1] - a[3] * cos(a[4] * a[0]) * cos(a[5] * a[2]) *
			      exp(-a[6] * (a[0] * a[0] + a[2] * a[2]));
}

/* The density of a d orbital. The parameter is not used. */
static double quantum(const void *data, const double *a)
{
	(void)data;
	double rr = a[0] * a[0] + a[1] * a[1] + a[2] * a[2], lobe = 3 * a[1] * a[1] - rr;
	return 1.2 - 1.6 * lobe * lobe * exp(-4.0 / 3 * sqrt(rr));
}

const InternalFunction function_internal_blobs[] = {
	{6, 5, blob, false},
	{7, 4, blob2, false},
	{10, 4, cross_ellipsoids, false},
	{19, 4, flange_cover, false},
	{32, 4, isect_ellipsoids, false},
	{53, 1, quantum, false},
	{62, 5, spikes, false},
	{63, 4, spikes_2d, false},
	{0, 0, NULL, false},
};
