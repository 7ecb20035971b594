/*
 * Plane curves F(x, y), extruded along z or, with the sweep switch above 0, swept about the y axis:
 * x is then the distance from the axis less the sweep's offset, and the plane is turned by its
 * angle. Field strength comes first.
 */
#include <math.h>

#include "surface/function_internal.h"

typedef struct PlanePoint { double x, y; } PlanePoint;

/* sweep: switch, offset, angle in degrees. */
static PlanePoint plane_point(const double *a, const double *sweep)
{
	if (sweep[0] <= 0)
		return (PlanePoint){a[0], a[1]};
	double r = sqrt(a[0] * a[0] + a[2] * a[2]) - sweep[1], angle = sweep[2] * M_PI / 180;
	return (PlanePoint){r * cos(angle) - a[1] * sin(angle), r * sin(angle) + a[1] * cos(angle)};
}

static double within(double value, double limit)
{
	return value > limit ? limit : value < -limit ? -limit : value;
}

/* The algebraic cylinders' parameters: strength, limit, sweep (3). */
static double algbr_cyl1(const void *data, const double *a)
{
	(void)data;
	PlanePoint p = plane_point(a, &a[5]);
	return within(a[3] * (p.x * p.x * (fabs(p.x) - 1) + p.y * p.y), a[4]);
}

/* The tacnode. */
static double algbr_cyl2(const void *data, const double *a)
{
	(void)data;
	PlanePoint p = plane_point(a, &a[5]);
	double x2 = p.x * p.x, y = p.y;
	return within(a[3] * (3 * x2 * y - 2 * x2 * x2 - y * y * (1 - 2 * y + y * y)), a[4]);
}

/* The rhamphoid cusp. */
static double algbr_cyl3(const void *data, const double *a)
{
	(void)data;
	PlanePoint p = plane_point(a, &a[5]);
	double x2 = p.x * p.x, y = p.y;
	return within(a[3] * (x2 * (2 * y - x2 - y * y) + (p.x - 1) * y * y), a[4]);
}

/* The trifolium. */
static double algbr_cyl4(const void *data, const double *a)
{
	(void)data;
	PlanePoint p = plane_point(a, &a[5]);
	double x2 = p.x * p.x, y2 = p.y * p.y;
	return within(a[3] * (p.y * (y2 - 3 * x2) - (x2 + y2) * (x2 + y2)), a[4]);
}

/* x factor, y factor, sweep. */
static double devils_curve_2d(const void *data, const double *a)
{
	(void)data;
	PlanePoint p = plane_point(a, &a[6]);
	double x2 = p.x * p.x, y2 = p.y * p.y;
	return function_internal_limit(a[3] * (x2 * (a[4] * a[4] - x2) - y2 * (a[5] * a[5] - y2)));
}

/* Neck width, divergence, sweep. */
static double folium_surface_2d(const void *data, const double *a)
{
	(void)data;
	PlanePoint p = plane_point(a, &a[6]);
	return function_internal_limit(
		-a[3] * (p.y * p.y * (1 + (a[5] - 4 * a[4]) * p.x) + p.x * p.x * (1 + a[5])));
}

/* Dimple, closeness, sweep. */
static double kampyle_of_eudoxus_2d(const void *data, const double *a)
{
	(void)data;
	PlanePoint p = plane_point(a, &a[6]);
	double x2 = p.x * p.x, c2 = a[5] * a[5];
	return function_internal_limit(a[3] * (c2 * x2 * (x2 - a[4] * a[5]) - p.y * p.y));
}

/* Size, width, sweep. */
static double lemniscate_of_gerono_2d(const void *data, const double *a)
{
	(void)data;
	PlanePoint p = plane_point(a, &a[6]);
	double x2 = p.x * p.x;
	return function_internal_limit(a[3] * (a[5] * a[5] * x2 * (a[4] * a[4] - x2) - p.y * p.y));
}

/* Size factors 1 and 2, fatness, sweep. */
static double piriform_2d(const void *data, const double *a)
{
	(void)data;
	PlanePoint p = plane_point(a, &a[7]);
	return function_internal_limit(
		a[3] * (a[6] * a[6] * p.x * p.x * p.x * (a[4] + a[5] * p.x) - p.y * p.y));
}

/* Size of the bulb, sharpness, fatness, sweep. */
static double strophoid_2d(const void *data, const double *a)
{
	(void)data;
	PlanePoint p = plane_point(a, &a[7]);
	return function_internal_limit(
		a[3] * (a[6] * a[6] * p.x * p.x * (p.x + a[4]) + (p.x - a[5]) * p.y * p.y));
}

/* Size and height of the spike, sweep. */
static double witch_of_agnesi_2d(const void *data, const double *a)
{
	(void)data;
	PlanePoint p = plane_point(a, &a[6]);
	return function_internal_limit(a[3] * (a[5] - p.y * (p.x * p.x + a[4] * a[4])));
}

const InternalFunction function_internal_plane[] = {
	{0, 5, algbr_cyl1, false},
	{1, 5, algbr_cyl2, false},
	{2, 5, algbr_cyl3, false},
	{3, 5, algbr_cyl4, false},
	{15, 6, devils_curve_2d, false},
	{21, 6, folium_surface_2d, false},
	{34, 6, kampyle_of_eudoxus_2d, false},
	{39, 6, lemniscate_of_gerono_2d, false},
	{50, 7, piriform_2d, false},
	{67, 7, strophoid_2d, false},
	{75, 6, witch_of_agnesi_2d, false},
	{0, 0, NULL, false},
};
