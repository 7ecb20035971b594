/*
 * The table of patterns, and what happens to every pattern's value: warps before, frequency, phase
 * and wave after.
 *
 * The wave shaping is POV-Ray's as measured through function { pattern { } }: the value times
 * frequency plus phase is taken modulo 1.00001 (not 1, so that exactly 1 stays 1), negative values
 * are lifted by whole numbers, then the wave applies. Frequency and phase are single precision.
 */
#include "surface/pattern.h"

#include <math.h>
#include <string.h>

#include "surface/pattern_classes.h"
#include "surface/warp.h"

static const PatternClass *const pattern_table[] = {
	&pattern_solid,       &pattern_gradient,     &pattern_planar,   &pattern_spherical,
	&pattern_cylindrical, &pattern_boxed,        &pattern_radial,   &pattern_onion,
	&pattern_leopard,     &pattern_spiral1,      &pattern_spiral2,  &pattern_quilted,
	&pattern_bozo,        &pattern_bumps,        &pattern_spotted,  &pattern_dents,
	&pattern_wrinkles,    &pattern_granite,      &pattern_agate,    &pattern_marble,
	&pattern_wood,        &pattern_ripples,      &pattern_waves,    &pattern_checker,
	&pattern_brick,       &pattern_hexagon,      &pattern_cubic,    &pattern_square,
	&pattern_triangular,  &pattern_object,       &pattern_cells,    &pattern_crackle,
	&pattern_facets,      &pattern_mandel,       &pattern_julia,    &pattern_magnet1m,
	&pattern_magnet1j,    &pattern_magnet2m,     &pattern_magnet2j, &pattern_function,
	&pattern_image,       &pattern_density_file, &pattern_pigment,  &pattern_slope,
	&pattern_aoi,         &pattern_potential,    &pattern_tiling,  &pattern_pavement,
};

const PatternClass *pattern_find(const char *name)
{
	for (size_t i = 0; i < sizeof pattern_table / sizeof *pattern_table; i++)
		if (strcmp(pattern_table[i]->name, name) == 0)
			return pattern_table[i];
	return NULL;
}

void pattern_init(Pattern *pattern, const PatternClass *class)
{
	*pattern = (Pattern){
		.class = class,
		.frequency = class->list > 0 || class->flags & PATTERN_STILL ? 0 : 1,
		.wave = class->flags & PATTERN_TRIANGLE ? WAVE_TRIANGLE : WAVE_RAMP,
		.exponent = 1,
	};
}

int pattern_generator(const Pattern *pattern)
{
	return pattern->noise_generator ? pattern->noise_generator : NOISE_GENERATOR_DEFAULT;
}

double pattern_cycloid(double value)
{
	const double turn = 2 * M_PI;
	return value >= 0 ? sin((value - floor(value)) * turn)
			  : -sin((-value - floor(-value)) * turn);
}

double pattern_triangle_wave(double value)
{
	value -= floor(value);
	return value >= 0.5 ? 2 * (1 - value) : 2 * value;
}

static double wave_apply(WaveType wave, double exponent, double v)
{
	switch (wave) {
	case WAVE_TRIANGLE:
		return pattern_triangle_wave(v);
	case WAVE_SINE:
		return (1 + pattern_cycloid(v)) * 0.5;
	case WAVE_SCALLOP:
		return fabs(pattern_cycloid(v * 0.5));
	case WAVE_CUBIC:
		return v * v * (3 - 2 * v);
	case WAVE_POLY:
		return pow(v, exponent);
	default:
		return v;
	}
}

Vec3 pattern_warp_point(const Pattern *pattern, const SurfacePoint *at)
{
	if (!pattern->warps)
		return at->p;
	bool own = pattern->class && pattern->class->flags & PATTERN_OWN_TURBULENCE;
	return warp_apply(pattern->warps, at->p, pattern_generator(pattern), own);
}

double pattern_value(const Pattern *pattern, const SurfacePoint *at)
{
	SurfacePoint warped = *at;
	warped.p = pattern_warp_point(pattern, at);
	return pattern_value_unwarped(pattern, &warped);
}

double pattern_value_unwarped(const Pattern *pattern, const SurfacePoint *at)
{
	double v = pattern->class->value(pattern, at);
	if (pattern->class->list > 0)
		return v;
	if (pattern->frequency != 0)
		v = fmod(v * (float)pattern->frequency + (float)pattern->phase, 1.00001);
	if (v < 0)
		v -= floor(v);
	return wave_apply(pattern->wave, pattern->exponent, v);
}

Vec3 pattern_warp_normal(const Pattern *pattern, Vec3 normal)
{
	for (const Warp *warp = pattern->warps; warp; warp = warp->next)
		if (warp->kind == WARP_TRANSFORM)
			normal = transform_normal_inverse(&warp->u.transform, normal);
	return normal;
}

/* Back the way it came: the innermost transformation, last in the list, first. */
static Vec3 unwarp_normal(const Warp *warp, Vec3 normal)
{
	if (!warp)
		return normal;
	normal = unwarp_normal(warp->next, normal);
	return warp->kind == WARP_TRANSFORM ? transform_normal(&warp->u.transform, normal) : normal;
}

Vec3 pattern_unwarp_normal(const Pattern *pattern, Vec3 normal)
{
	return unwarp_normal(pattern->warps, normal);
}
