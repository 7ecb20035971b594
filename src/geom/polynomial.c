#include "geom/polynomial.h"

#include <assert.h>
#include <float.h>
#include <math.h>
#include <stdbool.h>

enum { NEWTON_STEPS = 128 };

double polynomial_eval(const double *c, int degree, double t)
{
	double sum = c[degree];
	for (int i = degree - 1; i >= 0; i--)
		sum = sum * t + c[i];
	return sum;
}

int polynomial_quadratic(double a, double b, double c, double roots[2])
{
	if (a == 0) {
		if (b == 0)
			return 0;
		roots[0] = -c / b;
		return 1;
	}
	double discriminant = b * b - 4 * a * c;
	if (!(discriminant >= 0))
		return 0;
	double q = -0.5 * (b + copysign(sqrt(discriminant), b));
	double first = q / a, second = q != 0 ? c / q : 0;
	roots[0] = fmin(first, second);
	roots[1] = fmax(first, second);
	return 2;
}

/* Value and slope at once. */
static double eval_with_slope(const double *c, int degree, double t, double *slope)
{
	double value = c[degree], derivative = 0;
	for (int i = degree - 1; i >= 0; i--) {
		derivative = derivative * t + value;
		value = value * t + c[i];
	}
	*slope = derivative;
	return value;
}

/* The root between lo and hi, where the values have different signs; low_sign is the sign at lo. */
static double bracketed_root(const double *c, int degree, double lo, double hi, bool low_positive)
{
	double t = 0.5 * (lo + hi), last_step = hi - lo, floor_step = 1e-17 * fmax(fabs(lo), fabs(hi));
	for (int i = 0; i < NEWTON_STEPS; i++) {
		double slope, value = eval_with_slope(c, degree, t, &slope);
		if (value == 0)
			return t;
		if ((value > 0) == low_positive)
			lo = t;
		else
			hi = t;
		double next = t - value / slope;
		/* Newton must stay inside and at least halve its step, else bisect. */
		if (!(next > lo && next < hi) || fabs(next - t) > 0.5 * last_step)
			next = 0.5 * (lo + hi);
		double step = fabs(next - t);
		t = next;
		if (step <= 2 * DBL_EPSILON * fabs(t) + floor_step)
			return t;
		last_step = step;
	}
	return t;
}

static int quadratic_between(const double *c, double lo, double hi, double *roots)
{
	double both[2];
	int count = polynomial_quadratic(c[2], c[1], c[0], both), kept = 0;
	for (int i = 0; i < count; i++)
		if (both[i] > lo && both[i] < hi)
			roots[kept++] = both[i];
	return kept;
}

static int roots_between(const double *c, int degree, double lo, double hi, double *roots);

/* Ends of the monotone pieces: the critical points, then hi. */
static int monotone_ends(const double *c, int degree, double lo, double hi, double *ends)
{
	double derivative[POLYNOMIAL_MAX_DEGREE];
	assert(degree > 2 && degree <= POLYNOMIAL_MAX_DEGREE);
	for (int i = 0; i < degree; i++)
		derivative[i] = (i + 1) * c[i + 1];
	int count = roots_between(derivative, degree - 1, lo, hi, ends);
	ends[count++] = hi;
	return count;
}

static int roots_between(const double *c, int degree, double lo, double hi, double *roots)
{
	if (degree == 2)
		return quadratic_between(c, lo, hi, roots);
	double ends[POLYNOMIAL_MAX_DEGREE + 1];
	int end_count = monotone_ends(c, degree, lo, hi, ends), count = 0;
	/* last is the latest place where the value was not zero; a piece that starts at zero has no root of its own. */
	double last = lo, last_value = polynomial_eval(c, degree, lo);
	for (int i = 0; i < end_count; i++) {
		double value = polynomial_eval(c, degree, ends[i]);
		if (value == 0)
			continue;
		if (last_value != 0 && (value > 0) != (last_value > 0))
			roots[count++] = bracketed_root(c, degree, last, ends[i], last_value > 0);
		last = ends[i];
		last_value = value;
	}
	return count;
}

/* A radius that holds every root: Fujiwara 1916. */
static double root_bound(const double *c, int degree)
{
	double bound = 0;
	for (int i = 1; i <= degree; i++)
		bound = fmax(bound, pow(fabs(c[degree - i] / c[degree]), 1.0 / i));
	return fmin(2 * bound + DBL_MIN, DBL_MAX);
}

int polynomial_roots(const double *c, int degree, double lo, double hi, double *roots)
{
	while (degree > 0 && c[degree] == 0)
		degree--;
	if (degree == 0 || !(lo < hi))
		return 0;
	if (degree == 1) {
		roots[0] = -c[0] / c[1];
		return roots[0] > lo && roots[0] < hi;
	}
	if (degree > 2 && (isinf(lo) || isinf(hi))) {
		double bound = root_bound(c, degree);
		lo = fmax(lo, -bound);
		hi = fmin(hi, bound);
	}
	return lo < hi ? roots_between(c, degree, lo, hi, roots) : 0;
}
