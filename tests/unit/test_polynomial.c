/* Roots of polynomials that were made from their roots. */
#include "geom/polynomial.h"

#include "base/random.h"
#include "tests/unit/check.h"

/* The product of (t - roots[i]) times factor. */
static void from_roots(const double *roots, int degree, double factor, double *c)
{
	c[0] = factor;
	for (int n = 0; n < degree; n++) {
		c[n + 1] = c[n];
		for (int i = n; i > 0; i--)
			c[i] = c[i - 1] - roots[n] * c[i];
		c[0] = -roots[n] * c[0];
	}
}

static void check_known(const double *roots, int degree, double factor, double tolerance)
{
	double c[POLYNOMIAL_MAX_DEGREE + 1], found[POLYNOMIAL_MAX_DEGREE];
	from_roots(roots, degree, factor, c);
	int count = polynomial_roots(c, degree, -INFINITY, INFINITY, found);
	CHECK(count == degree);
	for (int i = 0; i < count && i < degree; i++)
		CHECK_NEAR(found[i], roots[i], tolerance * (1 + fabs(roots[i])));
}

static void test_simple_roots(void)
{
	check_known((double[]){-2, 3}, 2, 1, 1e-14);
	check_known((double[]){-2, 3, 5}, 3, -2, 1e-14);
	check_known((double[]){-2, 0.5, 3, 5}, 4, 7, 1e-13);
	check_known((double[]){-2, -1, 0.25, 3, 5}, 5, 1, 1e-12);
	check_known((double[]){-5, -4, -3, -2, -1, 0, 1, 2, 3, 4, 5}, 11, 1, 1e-9);
}

static void test_bad_scales(void)
{
	check_known((double[]){1e-9, 1, 1e9}, 3, 1, 1e-12);
	check_known((double[]){1e-6, 1e-3, 1e3, 1e6}, 4, 1e-200, 1e-12);
	check_known((double[]){100, 100.1, 100.5, 101}, 4, 1e20, 1e-6);
	check_known((double[]){-1e8, 1e-8}, 2, 1, 1e-14);
	/* A leading coefficient that is only noise leaves the other roots alone. */
	double found[3];
	CHECK(polynomial_roots((double[]){-2, 1, 0, 1e-30}, 3, 0, 100, found) == 1);
	CHECK_NEAR(found[0], 2, 1e-14);
	CHECK(polynomial_roots((double[]){-1, 0, 1, INFINITY}, 3, 0, 100, found) == 0);
	CHECK(polynomial_roots((double[]){-1, NAN, 0, 1}, 3, 0, 100, found) == 0);
	CHECK(polynomial_roots((double[]){2, -3, 1, 0, 0}, 4, -INFINITY, INFINITY, found) == 2);
}

static void test_multiple_roots(void)
{
	double c[6], found[6];
	from_roots((double[]){1, 1, 1, 4}, 4, 1, c);
	int count = polynomial_roots(c, 4, -10, 10, found);
	CHECK(count == 2 || count == 4);
	CHECK_NEAR(found[0], 1, 1e-4);
	CHECK_NEAR(found[count - 1], 4, 1e-12);
	from_roots((double[]){1, 1, 4}, 3, 1, c);
	count = polynomial_roots(c, 3, -10, 10, found);
	CHECK(count == 1 || count == 3);
	CHECK_NEAR(found[count - 1], 4, 1e-12);
	/* Just off the double root: two roots, or none. */
	CHECK(polynomial_roots((double[]){1 - 1e-10, -2, 1, 0.0}, 3, 0, 2, found) == 2);
	CHECK(polynomial_roots((double[]){1 + 1e-10, -2, 1, 0.0}, 3, 0, 2, found) == 0);
}

static void test_interval(void)
{
	double c[5], found[5];
	from_roots((double[]){-2, 0, 3, 5}, 4, 1, c);
	CHECK(polynomial_roots(c, 4, 0, 4, found) == 1);
	CHECK_NEAR(found[0], 3, 1e-14);
	CHECK(polynomial_roots(c, 4, 6, INFINITY, found) == 0);
	CHECK(polynomial_roots(c, 4, -INFINITY, -1, found) == 1);
	CHECK(polynomial_roots(c, 4, 2, 1, found) == 0);
	CHECK(polynomial_roots((double[]){3}, 0, 0, 1, found) == 0);
	CHECK(polynomial_roots((double[]){0, 0, 0, 0}, 3, 0, 1, found) == 0);
}

/* Random roots in [-1, 1], factors without real roots mixed in. */
static void test_random_roots(void)
{
	for (int n = 0; n < 2000; n++) {
		Sampler sampler = {7, (uint64_t)n, 0};
		double roots[8], c[20], found[20], t = -1;
		int real = 1 + (int)(sampler_next(&sampler) * 6);
		for (int i = 0; i < real; i++)
			roots[i] = t += 0.05 + 0.2 * sampler_next(&sampler);
		from_roots(roots, real, 1, c);
		int degree = real;
		for (int k = 0; k < n % 3; k++, degree += 2) {
			double middle = sampler_next(&sampler), rise = 0.1 + sampler_next(&sampler);
			double b = -2 * middle, a0 = middle * middle + rise;
			c[degree + 1] = c[degree + 2] = 0;
			for (int i = degree + 2; i >= 0; i--)
				c[i] = a0 * c[i] + (i > 0 ? b * c[i - 1] : 0) +
				       (i > 1 ? c[i - 2] : 0);
		}
		int count = polynomial_roots(c, degree, -2, 2, found);
		CHECK(count == real);
		for (int i = 0; i < count && i < real; i++)
			CHECK_NEAR(found[i], roots[i], 1e-9);
	}
}

static void test_high_degree(void)
{
	double roots[POLYNOMIAL_MAX_DEGREE], c[POLYNOMIAL_MAX_DEGREE + 1],
		found[POLYNOMIAL_MAX_DEGREE];
	/* Chebyshev nodes are the best conditioned set on [-1, 1]. */
	for (int i = 0; i < 20; i++)
		roots[i] = -cos((i + 0.5) * M_PI / 20);
	from_roots(roots, 20, 1, c);
	CHECK(polynomial_roots(c, 20, -1, 1, found) == 20);
	for (int i = 0; i < 20; i++)
		CHECK_NEAR(found[i], roots[i], 1e-7);
	for (int i = 0; i < POLYNOMIAL_MAX_DEGREE; i++)
		c[i] = 0;
	c[0] = -2, c[POLYNOMIAL_MAX_DEGREE] = 1;
	CHECK(polynomial_roots(c, POLYNOMIAL_MAX_DEGREE, 0, 10, found) == 1);
	CHECK_NEAR(found[0], pow(2, 1.0 / POLYNOMIAL_MAX_DEGREE), 1e-14);
}

int main(void)
{
	test_simple_roots();
	test_bad_scales();
	test_multiple_roots();
	test_interval();
	test_random_roots();
	test_high_degree();
	return CHECK_RESULT();
}
