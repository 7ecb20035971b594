#include <math.h>

#include "base/vec.h"
#include "surface/function_internal.h"

static double length_of(const double *a)
{
	return sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2]);
}

/* Distance from the origin. */
static double radius(const void *data, const double *a)
{
	(void)data;
	return length_of(a);
}

/* Longitude: 0 on +z, towards +x. */
static double theta(const void *data, const double *a)
{
	(void)data;
	return atan2(a[0], a[2]);
}

/* Angle from +y. */
static double phi(const void *data, const double *a)
{
	(void)data;
	return atan2(hypot(a[0], a[2]), a[1]);
}

/* Radius. */
static double sphere(const void *data, const double *a)
{
	(void)data;
	return length_of(a) - a[3];
}

/* Factors of x, y and z. */
static double ellipsoid(const void *data, const double *a)
{
	(void)data;
	double x = a[0] * a[3], y = a[1] * a[4], z = a[2] * a[5];
	return sqrt(x * x + y * y + z * z);
}

/* Major and minor radius. */
static double torus(const void *data, const double *a)
{
	(void)data;
	double ring = sqrt(a[0] * a[0] + a[2] * a[2]) - a[3];
	return sqrt(ring * ring + a[1] * a[1]) - a[4];
}

/* Field strength, major and minor radius: the torus' polynomial. */
static double torus2(const void *data, const double *a)
{
	(void)data;
	double ring = a[0] * a[0] + a[2] * a[2], major = a[4] * a[4], minor = a[5] * a[5];
	double s = ring + a[1] * a[1] + major - minor;
	return function_internal_limit(-a[3] * (s * s - 4 * major * ring));
}

/* Edge radius, half extents. POV-Ray's is 1e-6 below the distance. */
static double rounded_box(const void *data, const double *a)
{
	(void)data;
	double sum = 0;
	for (int i = 0; i < 3; i++) {
		double beyond = fabs(a[i]) - (a[4 + i] - a[3]);
		sum += beyond > 0 ? beyond * beyond : 0;
	}
	return sqrt(sum) - a[3] - 1e-6;
}

/* East-west and north-south exponent. */
static double superellipsoid(const void *data, const double *a)
{
	(void)data;
	double east = 2 / a[3], north = 2 / a[4];
	double ring = pow(fabs(a[0]), east) + pow(fabs(a[1]), east);
	return 1 - pow(pow(ring, a[3] / a[4]) + pow(fabs(a[2]), north), a[4] / 2);
}

const InternalFunction function_internal_shapes[] = {
	{17, 3, ellipsoid, false},   {47, 0, phi, false},    {57, 0, radius, false},
	{60, 4, rounded_box, false}, {61, 1, sphere, false}, {68, 2, superellipsoid, false},
	{69, 0, theta, false},       {70, 2, torus, false},  {71, 3, torus2, false},
	{0, 0, NULL, false},
};
