/* What a finish is where the scene says nothing: POV-Ray's initial values. */
#include "surface/texture.h"

Finish finish_default(void)
{
	Finish finish = {
		.ambient = {0.1f, 0.1f, 0.1f},
		.diffuse = 0.6f,
		.brilliance = 1,
		.phong_size = 40,
		.roughness = 0.05f,
	};
	finish.reflection.falloff = 1;
	finish.reflection.exponent = 1;
	return finish;
}
