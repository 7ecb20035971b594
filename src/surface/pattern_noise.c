/* Patterns made of noise. Formulas as measured at random points through function { pattern { } }.
 */
#include <math.h>

#include "surface/pattern_classes.h"
#include "surface/pattern_data.h"
#include "surface/warp.h"

static double value_bozo(const Pattern *pattern, const SurfacePoint *at)
{
	return noise_value(at->p, pattern_generator(pattern));
}

static void bump_bumps(const Pattern *pattern, const SurfacePoint *at, double amount, Vec3 *normal)
{
	*normal = vec3_mad(*normal, amount, noise_vector(at->p, pattern_generator(pattern)));
}

static double value_dents(const Pattern *pattern, const SurfacePoint *at)
{
	double v = noise_value(at->p, pattern_generator(pattern));
	return v * v * v;
}

static void bump_dents(const Pattern *pattern, const SurfacePoint *at, double amount, Vec3 *normal)
{
	double v = value_dents(pattern, at);
	*normal = vec3_mad(*normal, v * amount, noise_vector(at->p, pattern_generator(pattern)));
}

/* Noise with the narrower range of generators 2 and 3 stretched. */
static double stretched_noise(Vec3 p, int generator)
{
	double v = noise_value(p, generator);
	return generator == 1 ? v : fmax(0, fmin(1, 2 * v - 0.5));
}

static double value_wrinkles(const Pattern *pattern, const SurfacePoint *at)
{
	int generator = pattern_generator(pattern);
	double sum = 0, scale = 1;
	for (int i = 0; i < 10; i++, scale *= 2)
		sum += stretched_noise(vec3_scale(at->p, scale), generator) / scale;
	return sum / 2;
}

static void bump_wrinkles(const Pattern *pattern, const SurfacePoint *at, double amount,
                          Vec3 *normal)
{
	int generator = pattern_generator(pattern);
	Vec3 sum = vec3_all(0);
	double scale = 1;
	for (int i = 0; i < 10; i++, scale *= 2) {
		Vec3 v = noise_vector(vec3_scale(at->p, scale), generator);
		sum = vec3_add(sum, vec3(fabs(v.x / scale), fabs(v.y / scale), fabs(v.z / scale)));
	}
	*normal = vec3_mad(*normal, amount, sum);
}

static double value_granite(const Pattern *pattern, const SurfacePoint *at)
{
	int generator = pattern_generator(pattern);
	double sum = 0, scale = 1;
	for (int i = 0; i < 6; i++, scale *= 2) {
		double v = fabs(0.5 - noise_value(vec3_scale(at->p, 4 * scale), generator));
		sum += (generator == 1 ? v : fmin(2 * v, 0.5)) / scale;
	}
	return sum;
}

static double value_agate(const Pattern *pattern, const SurfacePoint *at)
{
	const AgateData *data = pattern->data;
	const Turbulence *classic = warp_find_classic(pattern->warps);
	Turbulence turbulence = classic ? *classic : turbulence_default();
	double stir = (data ? (float)data->turbulence : 1) *
	              turbulence_value(at->p, &turbulence, pattern_generator(pattern));
	double v = 0.5 * (pattern_cycloid(1.3 * stir + 1.1 * at->p.z) + 1);
	return v <= 0 ? 0 : pow(v < 1 ? v : 1, 0.77);
}

static double value_marble(const Pattern *pattern, const SurfacePoint *at)
{
	const Turbulence *turbulence = warp_find_classic(pattern->warps);
	double stir = 0;
	if (turbulence)
		stir = turbulence->amount.x *
		       turbulence_value(at->p, turbulence, pattern_generator(pattern));
	return at->p.x + stir;
}

static double value_wood(const Pattern *pattern, const SurfacePoint *at)
{
	const Turbulence *turbulence = warp_find_classic(pattern->warps);
	double x = at->p.x, y = at->p.y;
	if (turbulence) {
		Vec3 stir = turbulence_vector(at->p, turbulence, pattern_generator(pattern));
		x += pattern_cycloid((at->p.x + stir.x) * turbulence->amount.x);
		y += pattern_cycloid((at->p.y + stir.y) * turbulence->amount.y);
	}
	return sqrt(x * x + y * y);
}

const PatternClass pattern_bozo = {"bozo", value_bozo, 0, NULL, 0};
const PatternClass pattern_bumps = {"bumps", value_bozo, 0, bump_bumps, 0};
const PatternClass pattern_spotted = {"spotted", value_bozo, 0, NULL, 0};
const PatternClass pattern_dents = {"dents", value_dents, 0, bump_dents, 0};
const PatternClass pattern_wrinkles = {"wrinkles", value_wrinkles, 0, bump_wrinkles, 0};
const PatternClass pattern_granite = {"granite", value_granite, 0, NULL, 0};
const PatternClass pattern_agate = {"agate", value_agate, 0, NULL, 0};
const PatternClass pattern_marble = {"marble", value_marble, 0, NULL,
                                     PATTERN_OWN_TURBULENCE | PATTERN_TRIANGLE};
const PatternClass pattern_wood = {"wood", value_wood, 0, NULL,
                                   PATTERN_OWN_TURBULENCE | PATTERN_TRIANGLE};
