/* What is inside a body where the scene says nothing: vacuum. */
#include "surface/texture.h"

Interior interior_default(void)
{
	return (Interior){.ior = 1, .dispersion = 1, .dispersion_samples = 7};
}
