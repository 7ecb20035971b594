#include "photon/photon.h"

#include <math.h>

/* ---- flux: 16-bit mantissas under one exponent, chosen by the largest channel; relative error of
 * that channel 2^-17 ---- */

static double power_of_two(int exponent)
{
	union {
		uint64_t bits;
		double value;
	} power = {.bits = (uint64_t)(1023 + exponent) << 52};
	return power.value;
}

static uint16_t to_mantissa(float value, double unit)
{
	double scaled = value * unit + 0.5;
	return scaled >= 65535 ? 65535 : scaled > 0 ? (uint16_t)scaled : 0;
}

/* value = fraction * 2^exponent with a fraction in [1/2, 1), for what is positive and finite. */
static int exponent_of(float value)
{
	union {
		float value;
		uint32_t bits;
	} parts = {value};
	return (int)(parts.bits >> 23) - 126;
}

void photon_set_flux(Photon *photon, Rgb flux)
{
	float most = rgb_max(flux);
	int exponent = most > 0 && isfinite(most) ? exponent_of(most) : 0;
	/* A value just under a power of two must not round up to 65536. */
	if (most * power_of_two(16 - exponent) + 0.5 >= 65536)
		exponent++;
	exponent = exponent < INT8_MIN ? INT8_MIN : exponent > INT8_MAX ? INT8_MAX : exponent;
	double unit = power_of_two(16 - exponent);
	photon->exponent = (int8_t)exponent;
	photon->mantissa[0] = to_mantissa(flux.r, unit);
	photon->mantissa[1] = to_mantissa(flux.g, unit);
	photon->mantissa[2] = to_mantissa(flux.b, unit);
}

Rgb photon_flux(const Photon *photon)
{
	float unit = ldexpf(1, photon->exponent - 16);
	return rgb(unit * photon->mantissa[0], unit * photon->mantissa[1],
		   unit * photon->mantissa[2]);
}

/* ---- unit vectors: the octahedral map (Cigolle et al. 2014), each coordinate rounded to the
 * nearest of `steps` + 1 ---- */

static double sign_of(double a) { return a < 0 ? -1 : 1; }

static void to_octahedron(Vec3 n, double *u, double *v)
{
	double sum = fabs(n.x) + fabs(n.y) + fabs(n.z), x = sum > 0 ? n.x / sum : 0,
	       y = sum > 0 ? n.y / sum : 0;
	*u = n.z >= 0 ? x : (1 - fabs(y)) * sign_of(x);
	*v = n.z >= 0 ? y : (1 - fabs(x)) * sign_of(y);
}

static Vec3 from_octahedron(double u, double v)
{
	double z = 1 - fabs(u) - fabs(v);
	if (z >= 0)
		return vec3_normalize(vec3(u, v, z));
	return vec3_normalize(vec3((1 - fabs(v)) * sign_of(u), (1 - fabs(u)) * sign_of(v), z));
}

/* steps is even, so that the axes come out exactly. */
static unsigned quantize(double u, int steps) { return (unsigned)((u + 1) * 0.5 * steps + 0.5); }
static double dequantize(unsigned q, int steps) { return 2.0 * q / steps - 1; }

enum { FINE = 65534, COARSE = 254 };

void photon_set_direction(Photon *photon, Vec3 unit)
{
	double u, v;
	to_octahedron(unit, &u, &v);
	photon->direction[0] = (uint16_t)quantize(u, FINE);
	photon->direction[1] = (uint16_t)quantize(v, FINE);
}

Vec3 photon_direction(const Photon *photon)
{
	return from_octahedron(dequantize(photon->direction[0], FINE),
			       dequantize(photon->direction[1], FINE));
}

void photon_set_normal(Photon *photon, Vec3 unit)
{
	double u, v;
	to_octahedron(unit, &u, &v);
	photon->normal[0] = (uint8_t)quantize(u, COARSE);
	photon->normal[1] = (uint8_t)quantize(v, COARSE);
}

Vec3 photon_normal(const Photon *photon)
{
	return from_octahedron(dequantize(photon->normal[0], COARSE),
			       dequantize(photon->normal[1], COARSE));
}
