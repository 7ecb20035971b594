/*
 * Algebraic surfaces: polynomials of x, y, z times a field strength, which is the first parameter
 * of all; comments name the others. Coefficients come from fits to POV-Ray's values.
 */
#include <math.h>

#include "surface/function_internal.h"

static double sq(double x)
{
	return x * x;
}

static double limited(double value)
{
	return function_internal_limit(value);
}

/* Scale. */
static double bicorn(const void *data, const double *a)
{
	(void)data;
	double x = a[0], y = a[1], z = a[2];
	double s = a[4], rr = x * x + z * z;
	return limited(a[3] * (y * y * (s * s - rr) - sq(rr + 2 * s * y - s * s)));
}

/* Scale. */
static double bifolia(const void *data, const double *a)
{
	(void)data;
	double x = a[0], y = a[1], z = a[2];
	double s = a[4], rr = x * x + z * z;
	return limited(a[3] * (s * rr * y - sq(rr + y * y)));
}

static double crossed_trough(const void *data, const double *a)
{
	(void)data;
	double x = a[0], y = a[1], z = a[2];
	return limited(a[3] * (x * x * z * z - y));
}

static double cubic_saddle(const void *data, const double *a)
{
	(void)data;
	double x = a[0], y = a[1], z = a[2];
	return limited(a[3] * (z - x * x * x + y * y * y));
}

static double cushion(const void *data, const double *a)
{
	(void)data;
	double x = a[0], y = a[1], z = a[2];
	return limited(a[3] * (x * x + y * y - 2 * z * z + 2 * z * (y * y + z * z) - sq(x * x +
	               y * y) + z * z * (x * x - y * y - z * z)));
}

static double devils_curve(const void *data, const double *a)
{
	(void)data;
	double x = a[0], y = a[1], z = a[2];
	return limited(a[3] * (0.36 * x * x - 0.25 * y * y + y * y * y * y - sq(x * x + z * z)));
}

/* Neck width, divergence. */
static double folium_surface(const void *data, const double *a)
{
	(void)data;
	double x = a[0], y = a[1], z = a[2];
	return limited(a[3] * ((y * y + z * z) * (1 + (a[5] - 4 * a[4]) * x) + x * x * (1 + a[5])));
}

static double glob(const void *data, const double *a)
{
	(void)data;
	double x = a[0], y = a[1], z = a[2];
	return limited(a[3] * (0.5 * x * x * x * x * (x + 1) - y * y - z * z));
}

static double heart(const void *data, const double *a)
{
	(void)data;
	double x = a[0], y = a[1], z = a[2];
	double s = 2 * x * x + y * y + z * z - 1;
	return limited(a[3] * ((0.1 * x * x + y * y) * z * z * z - s * s * s));
}

static double hunt_surface(const void *data, const double *a)
{
	(void)data;
	double x = a[0], y = a[1], z = a[2];
	double s = x * x + y * y + z * z - 13, t = 3 * x * x + y * y - 4 * z * z - 12;
	return limited(-a[3] * (4 * s * s * s + 27 * t * t));
}

/* Major and minor radius. */
static double hyperbolic_torus(const void *data, const double *a)
{
	(void)data;
	double x = a[0], y = a[1], z = a[2];
	double major = a[4] * a[4], minor = a[5] * a[5];
	return limited(a[3] * (4 * major * (x * x - z * z) - sq(x * x + y * y - z * z + major -
	               minor)));
}

/* Dimple, closeness. */
static double kampyle_of_eudoxus(const void *data, const double *a)
{
	(void)data;
	double x = a[0], y = a[1], z = a[2];
	return limited(a[3] * (a[5] * a[5] * x * x * (x * x - a[4] * a[4]) - y * y - z * z));
}

static double klein_bottle(const void *data, const double *a)
{
	(void)data;
	double x = a[0], y = a[1], z = a[2];
	double rr = x * x + y * y + z * z, t = rr - 2 * y - 1;
	return limited(-a[3] * ((rr + 2 * y - 1) * (t * t - 8 * z * z) + 16 * x * z * t));
}

static double kummer_surface_v1(const void *data, const double *a)
{
	(void)data;
	double x = a[0], y = a[1], z = a[2];
	double xx = x * x, yy = y * y, zz = z * z;
	return limited(a[3] * (xx + yy + zz - 1 - xx * xx - yy * yy - zz * zz + xx * yy + yy *
	               zz + zz * xx));
}

/* Rod width, divergence, asymmetry. */
static double kummer_surface_v2(const void *data, const double *a)
{
	(void)data;
	double x = a[0], y = a[1], z = a[2];
	double xx = x * x, yy = y * y, zz = z * z;
	return limited(a[3] * (1 - xx * xx - yy * yy - zz * zz - a[4] * (xx + yy + zz) - a[5] *
	               (xx * yy + yy * zz + zz * xx) - a[6] * x * y * z));
}

static double lemniscate_of_gerono(const void *data, const double *a)
{
	(void)data;
	double x = a[0], y = a[1], z = a[2];
	return limited(a[3] * (x * x - x * x * x * x - y * y - z * z));
}

static double mitre(const void *data, const double *a)
{
	(void)data;
	double x = a[0], y = a[1], z = a[2];
	return limited(a[3] * (y * y * (1 - y * y - z * z) - 4 * x * x * (x * x + y * y + z * z)));
}

static double nodal_cubic(const void *data, const double *a)
{
	(void)data;
	double y = a[1], z = a[2];
	return limited(a[3] * (6 * y * z - y * y * y - z * z * z));
}

/* Major radius, filling, thickness. */
static double ovals_of_cassini(const void *data, const double *a)
{
	(void)data;
	double x = a[0], y = a[1], z = a[2];
	double rr = x * x + z * z;
	return limited(a[3] * (a[5] * a[5] + a[6] * a[4] * a[4] * rr - sq(rr + y * y + a[4] *
	               a[4])));
}

static double paraboloid(const void *data, const double *a)
{
	(void)data;
	double x = a[0], y = a[1], z = a[2];
	return limited(a[3] * (y - x * x - z * z));
}

/* Major and minor radius. */
static double parabolic_torus(const void *data, const double *a)
{
	(void)data;
	double x = a[0], y = a[1], z = a[2];
	double major = a[4] * a[4], minor = a[5] * a[5];
	return limited(a[3] * ((major + minor) * (x * x - z) - (major - minor) * (y * y + major
	               - minor) - sq(x * x + y * y - z)));
}

static double pillow(const void *data, const double *a)
{
	(void)data;
	double x = a[0], y = a[1], z = a[2];
	return limited(a[3] * (x * x * (x * x - 1) + y * y * (y * y - 1) + z * z * (z * z - 1)));
}

static double piriform(const void *data, const double *a)
{
	(void)data;
	double x = a[0], y = a[1], z = a[2];
	return limited(a[3] * (x * x * x * (x - 1) + y * y + z * z));
}

static double quartic_paraboloid(const void *data, const double *a)
{
	(void)data;
	double x = a[0], y = a[1], z = a[2];
	return limited(a[3] * (y - x * x * x * x - z * z * z * z));
}

static double quartic_saddle(const void *data, const double *a)
{
	(void)data;
	double x = a[0], y = a[1], z = a[2];
	return limited(a[3] * (y - x * x * x * x + z * z * z * z));
}

/* Diameter of the egg, width of the tube. */
static double quartic_cylinder(const void *data, const double *a)
{
	(void)data;
	double x = a[0], y = a[1], z = a[2];
	return limited(a[3] * (sq(a[4] * a[5]) - (x * x + z * z) * (y * y + a[5] * a[5])));
}

static double steiners_roman(const void *data, const double *a)
{
	(void)data;
	double x = a[0], y = a[1], z = a[2];
	return limited(-a[3] * (x * x * y * y + y * y * z * z + z * z * x * x + x * y * z));
}

/* Size of the bulb, sharpness, fatness. */
static double strophoid(const void *data, const double *a)
{
	(void)data;
	double x = a[0], y = a[1], z = a[2];
	return limited(a[3] * (a[6] * a[6] * x * x * (x + a[4]) + (x - a[5]) * (y * y + z * z)));
}

static double torus_gumdrop(const void *data, const double *a)
{
	(void)data;
	double x = a[0], y = a[1], z = a[2];
	double xx = x * x, s = y * y + z * z;
	return limited(a[3] * (20 * (xx + s) - 4 * (xx * xx + s * s) - 17 * (xx * s + 1)));
}

static double umbrella(const void *data, const double *a)
{
	(void)data;
	double x = a[0], y = a[1], z = a[2];
	return limited(a[3] * (y * z * z - x * x));
}

/* Width of the spike. */
static double witch_of_agnesi(const void *data, const double *a)
{
	(void)data;
	double x = a[0], y = a[1], z = a[2];
	return limited(a[3] * (a[4] * (1 - y) - y * (x * x + z * z)));
}

/* Scale, a factor. Apery's polynomial of Boy's surface. */
static double boy_surface(const void *data, const double *a)
{
	(void)data;
	double x = a[0], y = a[1], z = a[2], w = 1 - z, rr = x * x + y * y, zz = z * z,
	       root = 1.4142135623730951;
	double value = 64 * w * w * w * zz * z - 48 * w * w * zz * (3 * rr + 2 * zz);
	value += 12 * w * z *
		 (27 * rr * rr - 24 * zz * rr + 36 * root * y * z * (y * y - 3 * x * x) +
		  4 * zz * zz);
	value += (9 * rr - 2 * zz) * (-81 * rr * rr - 72 * zz * rr +
				      108 * root * x * z * (x * x - 3 * y * y) + 4 * zz * zz);
	return limited(a[3] * a[4] * value);
}

/* Major and minor radius of a torus about y, its displacement in x and y, radius of the inversion
 * about the origin. The torus' quartic at the inverse of the point, times the fourth power of the
 * distance: a polynomial. */
static double dupin_cyclid(const void *data, const double *a)
{
	(void)data;
	double rr = a[0] * a[0] + a[1] * a[1] + a[2] * a[2], k = a[8] * a[8];
	double x = k * a[0] - a[6] * rr, z = k * a[2];
	double major = a[4] * a[4], minor = a[5] * a[5];
	double s = k * k - 2 * k * (a[0] * a[6] + a[1] * a[7]) + rr * (a[6] * a[6] + a[7] * a[7]) +
		   (major - minor) * rr;
	/* POV-Ray's polynomial has the opposite sign in one of y's terms. */
	double odd = 8 * k * a[7] * a[1] * rr * (major - minor);
	return limited(a[3] * (4 * major * (x * x + z * z) - s * s - odd));
}

/* Enneper's minimal surface; z is kept from 0, where the field has its pole. */
static double enneper(const void *data, const double *a)
{
	(void)data;
	double z = fabs(a[2]) > 0.2 ? a[2] : 0.2, s = (a[0] * a[0] - a[1] * a[1]) / z;
	double t = s / 2 - 2 * a[2] * a[2] / 9;
	return limited(a[3] * (t * t * t + 6 * s * s / 16));
}

const InternalFunction function_internal_algebra[] = {
	{4, 2, bicorn, false},
	{5, 2, bifolia, false},
	{8, 2, boy_surface, false},
	{11, 1, crossed_trough, false},
	{12, 1, cubic_saddle, false},
	{13, 1, cushion, false},
	{14, 1, devils_curve, false},
	{16, 6, dupin_cyclid, false},
	{18, 1, enneper, false},
	{20, 3, folium_surface, false},
	{22, 1, glob, false},
	{23, 1, heart, false},
	{30, 1, hunt_surface, false},
	{31, 3, hyperbolic_torus, false},
	{33, 3, kampyle_of_eudoxus, false},
	{35, 1, klein_bottle, false},
	{36, 1, kummer_surface_v1, false},
	{37, 4, kummer_surface_v2, false},
	{38, 1, lemniscate_of_gerono, false},
	{41, 1, mitre, false},
	{42, 1, nodal_cubic, false},
	{43, 1, cushion, false},
	{44, 4, ovals_of_cassini, false},
	{45, 1, paraboloid, false},
	{46, 3, parabolic_torus, false},
	{48, 1, pillow, false},
	{49, 1, piriform, false},
	{54, 1, quartic_paraboloid, false},
	{55, 1, quartic_saddle, false},
	{56, 3, quartic_cylinder, false},
	{65, 1, steiners_roman, false},
	{66, 4, strophoid, false},
	{72, 1, torus_gumdrop, false},
	{73, 1, umbrella, false},
	{74, 2, witch_of_agnesi, false},
	{0, 0, NULL, false},
};
