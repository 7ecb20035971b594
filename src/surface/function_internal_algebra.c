/*
 * Algebraic surfaces: polynomials of x, y, z times a field strength, which is the first parameter of nearly all.
 */
#include <math.h>

#include "surface/function_internal.h"

/* Parameter: field strength (of this and the following). */
static double crossed_trough(const void *data, const double *a)
{
	(void)data;
	double x = a[0], y = a[1], z = a[2];
	return function_internal_limit(a[3] * (x * x * z * z - y));
}

static double cubic_saddle(const void *data, const double *a)
{
	(void)data;
	double x = a[0], y = a[1], z = a[2];
	return function_internal_limit(a[3] * (z - x * x * x + y * y * y));
}

const InternalFunction function_internal_algebra[] = {
	{11, 1, crossed_trough}, {12, 1, cubic_saddle}, {0, 0, NULL},
};
