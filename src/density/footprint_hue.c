#include "density/footprint_hue.h"

#include <math.h>

#include "surface/texture.h"

FootprintHues footprint_hues(void)
{
	FootprintHues hues;
	Rgb all = {0, 0, 0};
	for (int i = 0; i < FOOTPRINT_HUES; i++) {
		hues.color[i] = interior_hue_color((i + 0.5) / FOOTPRINT_HUES);
		all = rgb_add(all, rgb_scale(hues.color[i], 1.0f / FOOTPRINT_HUES));
	}
	for (int i = 0; i < FOOTPRINT_HUES; i++)
		hues.color[i] = rgb(hues.color[i].r / all.r, hues.color[i].g / all.g,
				    hues.color[i].b / all.b);
	return hues;
}

int footprint_hue_of(const FootprintHues *hues, Rgb flux)
{
	float least = INFINITY;
	int best = 0;
	for (int i = 0; i < FOOTPRINT_HUES; i++) {
		Rgb off = rgb_sub(flux, hues->color[i]);
		float distance = off.r * off.r + off.g * off.g + off.b * off.b;
		if (distance < least) {
			least = distance;
			best = i;
		}
	}
	return best;
}

bool footprint_hue_is_pure(Rgb flux)
{
	static const float least_saturation = 0.3f;
	float most = rgb_max(flux), least = fminf(flux.r, fminf(flux.g, flux.b));
	return most - least > least_saturation * most;
}
