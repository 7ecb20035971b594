/*
 * Tubes along curves. Their cross sections share one family: with exponent 1 a circle, 0 a square, 2 a diamond, beyond a
 * star; in between superellipses.
 */
#include <math.h>

#include "surface/function_internal.h"

/* The "radius" of a cross section's point for the cross section type. */
static double cross_section(double a, double b, double type)
{
	a = fabs(a);
	b = fabs(b);
	if (type == 1)
		return sqrt(a * a + b * b);
	if (type == 0)
		return a > b ? a : b;
	if (type == 2)
		return a + b;
	return pow(pow(a, 2 / type) + pow(b, 2 / type), type / 2);
}

/* x mod m in [0, m). */
static double wrap(double x, double m)
{
	x = fmod(x, m);
	return x < 0 ? x + m : x;
}

/* Parameters: helixes, period, minor radius, major radius, shape, cross section, its rotation. */
static double helix1(const void *data, const double *a)
{
	(void)data;
	double r = sqrt(a[0] * a[0] + a[2] * a[2]), period = a[4];
	if (period == 0)
		return r + a[6] - a[5];
	double turn = 2 * M_PI / a[3];
	double across = r - a[6], along = (wrap(atan2(a[2], a[0]) + a[1] * period, turn) - turn / 2) / period / a[7];
	double angle = a[9] * M_PI / 180, c = cos(angle), s = sin(angle);
	return function_internal_limit(cross_section(across * c - along * s, across * s + along * c, a[8]) - a[5]);
}

/* Parameters: not used, period, minor radius, major radius, not used, cross section, its rotation. The cross section lies
 * in a plane of constant y and turns with the helix. */
static double helix2(const void *data, const double *a)
{
	(void)data;
	double angle = a[1] * a[4];
	double x = a[0] - a[6] * cos(angle), z = a[2] - a[6] * sin(angle);
	angle += a[9] * M_PI / 180;
	double c = cos(angle), s = sin(angle);
	return function_internal_limit(cross_section(x * c + z * s, z * c - x * s, a[8]) - a[5]);
}

/* Parameters: distance between windings, thickness, outer radius, two not used, cross section. */
static double spiral(const void *data, const double *a)
{
	(void)data;
	double r = sqrt(a[0] * a[0] + a[2] * a[2]), distance = a[3];
	double across = wrap(r + distance * atan2(a[2], a[0]) / (2 * M_PI), distance) - distance / 2;
	double tube = cross_section(across, a[1], a[8]) - a[4];
	double ball = sqrt(r * r + a[1] * a[1]) - a[5];
	return function_internal_limit(tube > ball ? tube : ball);
}

const InternalFunction function_internal_curves[] = {
	{25, 7, helix1}, {26, 7, helix2}, {64, 6, spiral}, {0, 0, NULL},
};
