#include "density/kernel.h"

#include <math.h>

/* About as smooth as the cone (its integrated square is 0.55 against 0.48) with a step of 4 %
 * of its height at the rim. */
static const double gaussian_width = 0.4;

static double gaussian_value(double t2)
{
	double s2 = 2 * gaussian_width * gaussian_width;
	return exp(-t2 / s2) / (M_PI * s2 * (1 - exp(-1 / s2)));
}

double kernel_value(EstimatorKernel kernel, double t2)
{
	if (!(t2 < 1))
		return 0;
	switch (kernel) {
	case KERNEL_UNIFORM:
		break;
	case KERNEL_CONE:
		return 3 / M_PI * (1 - sqrt(t2));
	case KERNEL_EPANECHNIKOV:
		return 2 / M_PI * (1 - t2);
	case KERNEL_GAUSSIAN:
	case KERNEL_ISOTROPIC:
		return gaussian_value(t2);
	}
	return 1 / M_PI;
}
