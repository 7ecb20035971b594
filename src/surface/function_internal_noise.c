#include <math.h>

#include "surface/function_internal.h"
#include "surface/noise.h"

/* No scene needs more octaves: what follows is below the noise's own precision. */
enum { MAX_OCTAVES = 64 };

static double noise3d(const void *data, const double *a)
{
	return noise_value(vec3(a[0], a[1], a[2]), *(const int *)data);
}

/* 1, 2 or 3; anything else means 1. */
static int generator_number(double x)
{
	return x >= 2 && x < 4 ? (int)x : 1;
}

static double noise_generator(const void *data, const double *a)
{
	(void)data;
	return noise_value(vec3(a[0], a[1], a[2]), generator_number(a[3]));
}

static double limit_octaves(double octaves)
{
	return octaves < MAX_OCTAVES ? octaves : MAX_OCTAVES;
}

static double signed_noise(Vec3 p, double generator)
{
	return 2 * noise_value(p, generator_number(generator)) - 1;
}

static double whole_power(double base, double exponent)
{
	return pow(base, exponent >= 1 ? trunc(exponent) : 0);
}

/* Heterogeneous multifractal (Musgrave): each octave is weighted by the height so far, to the whole
 * power T. Parameters: H, lacunarity, octaves, offset, T, generator. What remains of fractional
 * octaves is weighted by the height once. */
static double hetero_mf(const void *data, const double *a)
{
	(void)data;
	double h = a[3], lacunarity = a[4], octaves = limit_octaves(a[5]), offset = a[6], t = a[7];
	Vec3 p = vec3(a[0], a[1], a[2]);
	double value = offset + signed_noise(p, a[8]), frequency = 1;
	for (int i = 1; i < octaves; i++) {
		p = vec3_scale(p, lacunarity);
		frequency *= lacunarity;
		value += (offset + signed_noise(p, a[8])) * pow(frequency, -h) *
			 whole_power(value, t);
	}
	double rest = octaves - floor(octaves);
	if (rest == 0)
		return value;
	p = vec3_scale(p, lacunarity);
	return value +
	       rest * (offset + signed_noise(p, a[8])) * pow(frequency * lacunarity, -h) * value;
}

static double ridge_signal(Vec3 p, double offset, double generator)
{
	double signal = offset - fabs(signed_noise(p, generator));
	return signal * signal;
}

/* Ridged multifractal (Musgrave). Parameters: H, lacunarity, octaves, offset, gain, generator. */
static double ridged_mf(const void *data, const double *a)
{
	(void)data;
	double h = a[3], lacunarity = a[4], octaves = limit_octaves(a[5]), offset = a[6],
	       gain = a[7];
	Vec3 p = vec3(a[0], a[1], a[2]);
	double signal = ridge_signal(p, offset, a[8]), value = signal, frequency = 1;
	for (int i = 1; i < octaves; i++) {
		double weight = fmin(fmax(signal * gain, 0), 1);
		p = vec3_scale(p, lacunarity);
		frequency *= lacunarity;
		signal = ridge_signal(p, offset, a[8]) * weight;
		value += signal * pow(frequency, -h);
	}
	return value;
}

/* Noise folded at the ridge, where it is 1, and turned over: 1 where the fold gives 0, 0 where it
 * gives 1 - offset. */
static double folded(Vec3 p, double offset, double ridge, double generator)
{
	double n = noise_value(p, generator_number(generator));
	n = n < ridge ? n / ridge : (1 - n) / (1 - ridge);
	return (1 - offset - n) / fmax(offset, 1 - offset);
}

/* The weighted mean of octaves of folded noise. Parameters: lambda, octaves, omega, offset, ridge,
 * generator. */
static double ridge(const void *data, const double *a)
{
	(void)data;
	double lambda = a[3], octaves = limit_octaves(a[4]), omega = a[5];
	Vec3 p = vec3(a[0], a[1], a[2]);
	double sum = 0, weights = 0, weight = 1;
	for (int i = 0; i < octaves; i++) {
		double share = octaves - i < 1 ? octaves - i : 1;
		sum += share * weight * folded(p, a[6], a[7], a[8]);
		weights += share * weight;
		weight *= omega;
		p = vec3_scale(p, lambda);
	}
	return weights > 0 ? sum / weights : 0;
}

const InternalFunction function_internal_noise[] = {
	{29, 6, hetero_mf, false}, {58, 6, ridge, false},           {59, 6, ridged_mf, false},
	{76, 0, noise3d, false},   {78, 1, noise_generator, false}, {0, 0, NULL, false},
};
