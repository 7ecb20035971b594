/*
 * Knaus & Zwicker 2011, "Progressive photon mapping: a probabilistic approach", eq. 15 and 20:
 * passes are independent, and r(i+1)^2 / r(i)^2 = (i + alpha) / (i + 1) lets the mean's variance
 * and bias both vanish. The product of these ratios up to a pass is a quotient of gamma functions:
 * r(n)^2 = r(1)^2 gamma(n + alpha) / (gamma(n + 1) gamma(1 + alpha)) for pass n from 0, the first
 * ratio being that of i = 1.
 */
#include <math.h>

#include "render/reduction.h"

static const double alpha = 2.0 / 3;

static double apa_radius(double first, uint32_t pass)
{
	double n = pass + 1.0;
	return first * exp(0.5 * (lgamma(n + alpha) - lgamma(n + 1) - lgamma(1 + alpha)));
}

const ReductionMethod reduction_apa = {"apa", apa_radius};
