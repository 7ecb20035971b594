/* Every kernel integrates to one over the unit disc, never rises outwards and ends at the rim. */
#include "density/kernel.h"

#include "tests/unit/check.h"

int main(void)
{
	const EstimatorKernel kernels[] = {KERNEL_UNIFORM, KERNEL_CONE, KERNEL_EPANECHNIKOV,
	                                   KERNEL_GAUSSIAN, KERNEL_ISOTROPIC};
	enum { STEPS = 20000 };
	for (int k = 0; k < 5; k++) {
		double sum = 0, last = INFINITY;
		for (int i = 0; i < STEPS; i++) {
			double t2 = (i + 0.5) / STEPS,
			       value = kernel_value(kernels[k], t2); /* area: pi d(t2) */
			CHECK(value > 0 && value <= last);
			last = value;
			sum += M_PI * value / STEPS;
		}
		CHECK_NEAR(sum, 1, 1e-5);
		CHECK(kernel_value(kernels[k], 1) == 0 && kernel_value(kernels[k], 7) == 0);
	}
	return CHECK_RESULT();
}
