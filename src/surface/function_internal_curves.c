/*
 * Tubes along curves. Their cross sections share one family: with exponent 1 a circle, 0 a square,
 * 2 a diamond, beyond a star; in between superellipses.
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
	double farthest = r + a[6];
	if (period == 0)
		return farthest - a[5];
	double turn = 2 * M_PI / a[3];
	double across = r - a[6],
	       along = (wrap(atan2(a[2], a[0]) + a[1] * period, turn) - turn / 2) / period / a[7];
	double angle = a[9] * M_PI / 180, c = cos(angle), s = sin(angle);
	double tube = cross_section(across * c - along * s, across * s + along * c, a[8]);
	return function_internal_limit(fmin(tube, farthest) - a[5]);
}

/* Parameters: not used, period, minor radius, major radius, not used, cross section, one not used.
 * The cross section lies in a plane of constant y and turns with the helix. */
static double helix2(const void *data, const double *a)
{
	(void)data;
	double angle = a[1] * a[4];
	double x = a[0] - a[6] * cos(angle), z = a[2] - a[6] * sin(angle);
	double c = cos(angle), s = sin(angle);
	return function_internal_limit(cross_section(x * c + z * s, z * c - x * s, a[8]) - a[5]);
}

/* Parameters: distance between windings, thickness, outer radius, two not used, cross section. */
static double spiral(const void *data, const double *a)
{
	(void)data;
	double r = sqrt(a[0] * a[0] + a[2] * a[2]), distance = a[3];
	double across = wrap(r + distance * atan2(a[2], a[0]) / (2 * M_PI), distance) -
			distance / 2;
	double tube = cross_section(across, a[1], a[8]) - a[4];
	double ball = sqrt(r * r + a[1] * a[1]) - a[5];
	return function_internal_limit(tube > ball ? tube : ball);
}

/* c0 + c1 y + c2 y^2 + c3 y^3 + c4 y^4 */
static double quartic(const double *c, double y)
{
	return c[0] + y * (c[1] + y * (c[2] + y * (c[3] + y * c[4])));
}

/* The surface of revolution of a quartic of y; parameters: its coefficients. */
static double poly4(const void *data, const double *a)
{
	(void)data;
	return sqrt(a[0] * a[0] + a[2] * a[2]) - quartic(&a[3], a[1]);
}

/* Tubes around the y axis that follow a quartic of y, the first one on the side of +z. Parameters:
 * their number, the coefficients. */
static double polytubes(const void *data, const double *a)
{
	(void)data;
	double r = sqrt(a[0] * a[0] + a[2] * a[2]), turn = 2 * M_PI / trunc(a[3]);
	double angle = wrap(atan2(a[0], a[2]) + turn / 2, turn) - turn / 2;
	double across = r * cos(angle) - quartic(&a[4], a[1]), along = r * sin(angle);
	return sqrt(across * across + along * along);
}

/* Distance to the nearer of the two neighbouring threads of a row: `side` is across the row, `up`
 * the weave's height. */
static double thread(double side, double spacing, double up, const double *relative)
{
	double nearest = HUGE_VAL, first = floor(side / spacing);
	for (int n = 0; n < 2; n++) {
		bool odd = fmod(first + n, 2) != 0;
		double across = (side - (first + n) * spacing) * relative[0];
		double height = (odd ? relative[3] + up : relative[3] - up) * relative[2];
		nearest = fmin(nearest, sqrt(across * across + height * height));
	}
	return nearest;
}

/* A woven mesh. Parameters: spacing in x and z, relative thickness across, amplitude of the weave,
 * relative thickness in y. */
static double mesh1(const void *data, const double *a)
{
	(void)data;
	const double relative[4] = {a[5], a[6], a[7], a[1]};
	double along_z = thread(a[0], a[3], -a[6] * cos(M_PI * a[2] / a[4]), relative);
	double along_x = thread(a[2], a[4], a[6] * cos(M_PI * a[0] / a[3]), relative);
	return along_x < along_z ? along_x : along_z;
}

/* Hexagonal cells of circumradius 1, whose centres lie sqrt(3) apart along x. Gives the point
 * relative to the centre of its cell, in the frame whose first axis goes through the side that is
 * nearest. */
static void hexagon_frame(const double *a, double *toward, double *beside)
{
	const double width = sqrt(3);
	double best = HUGE_VAL;
	double x = 0, y = 0;
	for (int odd = 0; odd < 2; odd++) {
		double row = floor((a[1] - odd * 1.5) / 3 + 0.5) * 3 + odd * 1.5;
		double column = floor((a[0] - odd * width / 2) / width + 0.5) * width +
				odd * width / 2;
		double dx = a[0] - column, dy = a[1] - row;
		if (dx * dx + dy * dy < best) {
			best = dx * dx + dy * dy;
			x = dx;
			y = dy;
		}
	}
	*toward = -1;
	for (int side = 0; side < 3; side++) {
		double c = cos(side * M_PI / 3), s = sin(side * M_PI / 3),
		       distance = fabs(c * x + s * y);
		if (distance > *toward + 1e-12) {
			*toward = distance;
			*beside = fabs(c * y - s * x);
		}
	}
}

/* The distance from the middle of a hexagonal cell towards the nearest side. The parameter is not
 * used. */
static double hex_x(const void *data, const double *a)
{
	(void)data;
	double toward, beside;
	hexagon_frame(a, &toward, &beside);
	return toward;
}

/* The distance along that side from its middle. */
static double hex_y(const void *data, const double *a)
{
	(void)data;
	double toward, beside;
	hexagon_frame(a, &toward, &beside);
	return beside;
}

/* A torus with a winding: major radius, loops, twist, fatness, threshold, ... Only fatness and
 * threshold of the plain torus are followed; lang warns about it. */
static double helical_torus(const void *data, const double *a)
{
	(void)data;
	double ring = sqrt(a[0] * a[0] + a[2] * a[2]) - a[3];
	return function_internal_limit(sqrt(ring * ring + a[1] * a[1]) - a[6] - a[7]);
}

/* The head of a comma shape: a ball that touches the origin; lang warns that the tail is missing.
 * Parameter: scale. */
static double comma(const void *data, const double *a)
{
	(void)data;
	double x = a[0] - a[3] / 2;
	return sqrt(x * x + a[1] * a[1] + a[2] * a[2]) - a[3] / 2;
}

const InternalFunction function_internal_curves[] = {
	{9, 1, comma, true},    {24, 10, helical_torus, true}, {25, 7, helix1, false},
	{26, 7, helix2, false}, {27, 1, hex_x, false},         {28, 1, hex_y, false},
	{40, 5, mesh1, false},  {51, 5, poly4, false},         {52, 6, polytubes, false},
	{64, 6, spiral, false}, {0, 0, NULL, false},
};
