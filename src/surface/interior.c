/* What is inside a body where the scene says nothing: vacuum. And how its index of refraction runs
 * over the spectrum. */
#include "surface/texture.h"

#include <math.h>

Interior interior_default(void)
{
	return (Interior){.ior = 1, .dispersion = 1, .dispersion_samples = 7};
}

double interior_ior_of_hue(const Interior *interior, double hue)
{
	double ior = interior->ior > 0 ? interior->ior : 1;
	return ior * pow(interior->dispersion, hue - 0.5);
}

/* One lobe: a Gaussian with different widths on its two sides. */
static double lobe(double x, double middle, double below, double above)
{
	double t = (x - middle) * (x < middle ? below : above);
	return exp(-0.5 * t * t);
}

/*
 * The CIE 1931 colour matching functions as sums of Gaussians (Wyman, Sloan & Shirley 2013,
 * single-precision fit), taken to linear sRGB over wavelengths from 680 to 420 nm; what falls
 * outside of the gamut is cut, and each channel is divided by its mean, so that the spectrum adds
 * up to white.
 */
Rgb interior_hue_color(double hue)
{
	double nm = 680 - 260 * hue;
	double x = 1.056 * lobe(nm, 599.8, 0.0264, 0.0323) +
		   0.362 * lobe(nm, 442.0, 0.0624, 0.0374) -
		   0.065 * lobe(nm, 501.1, 0.0490, 0.0382);
	double y = 0.821 * lobe(nm, 568.8, 0.0213, 0.0247) +
		   0.286 * lobe(nm, 530.9, 0.0613, 0.0322);
	double z = 1.217 * lobe(nm, 437.0, 0.0845, 0.0278) +
		   0.681 * lobe(nm, 459.0, 0.0385, 0.0725);
	double r = 3.2406 * x - 1.5372 * y - 0.4986 * z, g = -0.9689 * x + 1.8758 * y + 0.0415 * z;
	double b = 0.0557 * x - 0.2040 * y + 1.0570 * z;
	return rgb((float)(fmax(r, 0) / 0.669223), (float)(fmax(g, 0) / 0.443678),
		   (float)(fmax(b, 0) / 0.397226));
}
