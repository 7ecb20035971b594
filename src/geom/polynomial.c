#include "geom/polynomial.h"

#include <assert.h>
#include <float.h>
#include <math.h>
#include <stdbool.h>

enum { NEWTON_STEPS = 128, MAX_HALVINGS = 5 };

/* Relative precision of the roots asked for, and of critical points, which only need to tell
 * roots apart. */
static const double ROOT_PRECISION = 1e-15, CRITICAL_PRECISION = 1e-8;

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

/* A piece of the t axis that ends with different signs. */
typedef struct Bracket {
	double lo, hi;
	bool low_positive;
	double precision; /* relative */
} Bracket;

static inline double bracketed_root(const double *c, int degree, const Bracket *bracket)
{
	double lo = bracket->lo, hi = bracket->hi, last_step = hi - lo;
	double t = 0.5 * (lo + hi), floor_step = 1e-17 * fmax(fabs(lo), fabs(hi));
	for (int i = 0; i < NEWTON_STEPS; i++) {
		double slope, value = eval_with_slope(c, degree, t, &slope);
		if (value == 0)
			return t;
		if ((value > 0) == bracket->low_positive)
			lo = t;
		else
			hi = t;
		double next = t - value / slope;
		/* Newton must stay inside and at least halve its step, else bisect. */
		if (!(next > lo && next < hi) || fabs(next - t) > 0.5 * last_step)
			next = 0.5 * (lo + hi);
		double step = fabs(next - t);
		t = next;
		if (step <= bracket->precision * fabs(t) + floor_step)
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

/* ---- isolation by critical points ---- */

typedef struct Search {
	const double *c;
	int degree;
	double lo, hi, precision;
	double doubt; /* the sign of a Bernstein coefficient smaller than this may be wrong */
} Search;

static int roots_between(const Search *search, double *roots);

/* Ends of the monotone pieces: the critical points, then hi. */
static int monotone_ends(const Search *search, double *ends)
{
	double derivative[POLYNOMIAL_MAX_DEGREE];
	assert(search->degree > 2 && search->degree <= POLYNOMIAL_MAX_DEGREE);
	for (int i = 0; i < search->degree; i++)
		derivative[i] = (i + 1) * search->c[i + 1];
	int count = roots_between(&(Search){derivative, search->degree - 1, search->lo, search->hi,
					    CRITICAL_PRECISION, 0},
				  ends);
	ends[count++] = search->hi;
	return count;
}

static int roots_between(const Search *search, double *roots)
{
	const double *c = search->c;
	int degree = search->degree;
	if (degree == 2)
		return quadratic_between(c, search->lo, search->hi, roots);
	double ends[POLYNOMIAL_MAX_DEGREE + 1];
	int end_count = monotone_ends(search, ends), count = 0;
	/* last is the latest place where the value was not zero; a piece that starts at zero has
	 * no root of its own. */
	double last = search->lo, last_value = polynomial_eval(c, degree, last);
	for (int i = 0; i < end_count; i++) {
		double value = polynomial_eval(c, degree, ends[i]);
		if (value == 0)
			continue;
		if (last_value != 0 && (value > 0) != (last_value > 0))
			roots[count++] = bracketed_root(
				c, degree,
				&(Bracket){last, ends[i], last_value > 0, search->precision});
		last = ends[i];
		last_value = value;
	}
	return count;
}

/* ---- isolation by signs ---- */

/* Bernstein coefficients on [lo, hi], and how far rounding may have moved them. */
static void to_bernstein(Search *search, double *b)
{
	int degree = search->degree;
	double width = search->hi - search->lo, power = 1, share = 1, sum = 0;
	for (int i = 0; i <= degree; i++)
		b[i] = search->c[i];
	for (int k = 0; k < degree; k++)
		for (int i = degree - 1; i >= k; i--)
			b[i] += search->lo * b[i + 1];
	/* Now powers of t - lo; divide by the binomials, then sum up. */
	for (int i = 0; i <= degree; i++) {
		sum += fabs(b[i]) * power;
		b[i] *= power * share;
		power *= width;
		share *= (i + 1.0) / (i < degree ? degree - i : 1);
	}
	search->doubt = 4 * degree * DBL_EPSILON * sum;
	for (int k = 1; k <= degree; k++)
		for (int i = degree; i >= k; i--)
			b[i] += b[i - 1];
}

/* -1 when rounding leaves a sign in doubt. */
static int sign_changes(const Search *search, const double *b)
{
	int changes = 0;
	for (int i = 0; i <= search->degree; i++) {
		if (fabs(b[i]) <= search->doubt)
			return -1;
		if (i > 0)
			changes += (b[i] > 0) != (b[i - 1] > 0);
	}
	return changes;
}

/* de Casteljau's scheme at the share s: b becomes the left part, right the right one. */
static void split(double *b, int degree, double s, double *right)
{
	for (int k = 0; k < degree; k++) {
		right[degree - k] = b[degree];
		for (int i = degree; i > k; i--)
			b[i] = b[i - 1] + s * (b[i] - b[i - 1]);
	}
	right[0] = b[degree];
}

/* Descartes' rule: no change of sign, no root; one change, one root; else halve, a few times. */
static int isolate(const Search *search, double *b, int halvings, double *roots)
{
	int changes = sign_changes(search, b);
	if (changes == 0)
		return 0;
	if (changes == 1) {
		Bracket bracket = {search->lo, search->hi, b[0] > 0, search->precision};
		roots[0] = bracketed_root(search->c, search->degree, &bracket);
		return 1;
	}
	if (changes < 0 || halvings == MAX_HALVINGS)
		return roots_between(search, roots);
	double right[POLYNOMIAL_MAX_DEGREE + 1],
		middle = search->lo + 0.5 * (search->hi - search->lo);
	Search low = *search, high = *search;
	low.hi = high.lo = middle;
	split(b, search->degree, 0.5, right);
	/* A root in the very middle would be lost between the halves. */
	if (fabs(right[0]) <= search->doubt)
		return roots_between(search, roots);
	int count = isolate(&low, b, halvings + 1, roots);
	return count + isolate(&high, right, halvings + 1, roots + count);
}

/* ---- all ---- */

/* A radius that holds every root: Fujiwara 1916, rounded up to powers of two. */
static double root_bound(const double *c, int degree)
{
	int leading = ilogb(c[degree]), exponent = -1000;
	for (int i = 1; i <= degree; i++) {
		if (c[degree - i] == 0)
			continue;
		int ratio = ilogb(c[degree - i]) - leading + 1;
		int root = ratio > 0 ? (ratio + i - 1) / i : ratio / i;
		exponent = root > exponent ? root : exponent;
	}
	return ldexp(1, exponent < 1000 ? exponent + 1 : 1000);
}

/* An overflowed coefficient, of a shape with absurd sizes, leaves nothing to solve. */
static bool all_finite(const double *c, int degree)
{
	for (int i = 0; i <= degree; i++)
		if (!isfinite(c[i]))
			return false;
	return true;
}

int polynomial_roots(const double *c, int degree, double lo, double hi, double *roots)
{
	if (!all_finite(c, degree))
		return 0;
	while (degree > 0 && c[degree] == 0)
		degree--;
	if (degree == 0 || !(lo < hi))
		return 0;
	if (degree == 1) {
		roots[0] = -c[0] / c[1];
		return roots[0] > lo && roots[0] < hi;
	}
	if (degree == 2)
		return quadratic_between(c, lo, hi, roots);
	double bound = root_bound(c, degree), b[POLYNOMIAL_MAX_DEGREE + 1];
	Search search = {c, degree, fmax(lo, -bound), fmin(hi, bound), ROOT_PRECISION, 0};
	if (!(search.lo < search.hi))
		return 0;
	to_bernstein(&search, b);
	return isolate(&search, b, 0, roots);
}
