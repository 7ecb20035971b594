#include "photon/hue.h"

#include <math.h>

#include "surface/texture.h"

enum { HUES = 64 };

/* The spectrum: colours evenly spaced from red to violet, white on the average. */
typedef struct Spectrum { Rgb color[HUES]; } Spectrum;

static Spectrum make_spectrum(void)
{
	Spectrum spectrum;
	Rgb all = {0, 0, 0};
	for (int i = 0; i < HUES; i++) {
		spectrum.color[i] = interior_hue_color((i + 0.5) / HUES);
		all = rgb_add(all, rgb_scale(spectrum.color[i], 1.0f / HUES));
	}
	for (int i = 0; i < HUES; i++)
		spectrum.color[i] =
			rgb(spectrum.color[i].r / all.r, spectrum.color[i].g / all.g,
			    spectrum.color[i].b / all.b);
	return spectrum;
}

/* The number of the colour nearest to a flux that would be 1 with all hues. */
static int nearest_color(const Spectrum *spectrum, Rgb flux)
{
	float least = INFINITY;
	int best = 0;
	for (int i = 0; i < HUES; i++) {
		Rgb off = rgb_sub(flux, spectrum->color[i]);
		float distance = off.r * off.r + off.g * off.g + off.b * off.b;
		if (distance < least) {
			least = distance;
			best = i;
		}
	}
	return best;
}

static bool is_pure(Rgb flux)
{
	static const float least_saturation = 0.3f;
	float most = rgb_max(flux), least = fminf(flux.r, fminf(flux.g, flux.b));
	return most - least > least_saturation * most;
}

bool photon_hue_parts(const PhotonMap *map, const uint32_t *photons, uint32_t count)
{
	enum { LOOKS = 64 };
	uint32_t looks = count < LOOKS ? count : LOOKS, pure = 0, red = 0;
	for (uint32_t i = 0; i < looks; i++) {
		Rgb flux = photon_flux(&map->photons[photons[(uint64_t)i * count / looks]]);
		pure += is_pure(flux);
		red += flux.r > flux.b;
	}
	return 2 * pure > looks && red > looks / 5 && red < looks - looks / 5;
}

/* Photons near one another where they left the light would have the same flux if they had all hues:
 * the mean of some dozens tells it. */
static void find_some(const Spectrum *spectrum, const PhotonMap *map, const uint32_t *photons,
		      uint32_t count, float *hues)
{
	double mean = 0;
	for (uint32_t i = 0; i < count; i++) {
		Rgb flux = photon_flux(&map->photons[photons[i]]);
		mean += (flux.r + flux.g + flux.b) / 3.0 / count;
	}
	for (uint32_t i = 0; i < count; i++) {
		Rgb flux = rgb_scale(photon_flux(&map->photons[photons[i]]),
				     (float)(mean > 0 ? 1 / mean : 0));
		hues[i] = (float)((nearest_color(spectrum, flux) + 0.5) / HUES);
	}
}

void photon_hue_find(const PhotonMap *map, const uint32_t *photons, uint32_t count, float *hues)
{
	enum { WINDOW = 128 };
	const Spectrum spectrum = make_spectrum();
	for (uint32_t from = 0, some; from < count; from += some) {
		some = count - from < 2 * WINDOW ? count - from : WINDOW;
		find_some(&spectrum, map, photons + from, some, hues + from);
	}
}
