#include "photon/photon.h"

#include <float.h>
#include <math.h>

/* ---- flux: 16-bit mantissas under one exponent, chosen by the largest channel; relative error of
 * that channel 2^-17 ---- */

static inline double power_of_two(int exponent)
{
	union {
		uint64_t bits;
		double value;
	} power = {.bits = (uint64_t)(1023 + exponent) << 52};
	return power.value;
}

static inline uint16_t to_mantissa(float value, double unit)
{
	return (uint16_t)(int)real_min(real_max(value * unit + 0.5, 0), 65535);
}

/* value = fraction * 2^exponent with a fraction in [1/2, 1 - 2^-17), for what is positive and
 * finite: a fraction that would round up to 65536 is carried over. */
static inline int exponent_of(float value)
{
	union {
		float value;
		uint32_t bits;
	} parts = {value};
	int exponent = (int)((parts.bits + (1 << 7)) >> 23) - 126;
	return exponent > INT8_MAX ? INT8_MAX : exponent;
}

static inline void set_flux(Photon *photon, Rgb flux)
{
	float most = rgb_max(flux);
	int exponent = most > 0 && most <= FLT_MAX ? exponent_of(most) : 0;
	double unit = power_of_two(16 - exponent);
	photon->exponent = (int8_t)exponent;
	photon->mantissa[0] = to_mantissa(flux.r, unit);
	photon->mantissa[1] = to_mantissa(flux.g, unit);
	photon->mantissa[2] = to_mantissa(flux.b, unit);
}

void photon_set_flux(Photon *photon, Rgb flux) { set_flux(photon, flux); }

Rgb photon_flux(const Photon *photon)
{
	float unit = ldexpf(1, photon->exponent - 16);
	return rgb(unit * photon->mantissa[0], unit * photon->mantissa[1],
		   unit * photon->mantissa[2]);
}

/* ---- unit vectors: the octahedral map (Cigolle et al. 2014), each coordinate rounded to the
 * nearest of `steps` + 1 ---- */

static double sign_of(double a) { return a < 0 ? -1 : 1; }

/* The lower half is folded outward over the edges of the upper one. */
static inline void to_octahedron(const Vec3 *n, double *u, double *v)
{
	double sum = fabs(n->x) + fabs(n->y) + fabs(n->z), inverse = sum > 0 ? 1 / sum : 0;
	double x = n->x * inverse, y = n->y * inverse;
	*u = n->z >= 0 ? x : copysign(1 - fabs(y), x);
	*v = n->z >= 0 ? y : copysign(1 - fabs(x), y);
}

static Vec3 from_octahedron(double u, double v)
{
	double z = 1 - fabs(u) - fabs(v);
	if (z >= 0)
		return vec3_normalize(vec3(u, v, z));
	return vec3_normalize(vec3((1 - fabs(v)) * sign_of(u), (1 - fabs(u)) * sign_of(v), z));
}

/* steps is even, so that the axes come out exactly. */
static inline int quantize(double u, int steps)
{
	return (int)(u * (0.5 * steps) + (0.5 * steps + 0.5));
}

static double dequantize(unsigned q, int steps) { return 2.0 * q / steps - 1; }

enum { FINE = 65534, COARSE = 254 };

static inline void set_direction(Photon *photon, const Vec3 *unit)
{
	double u, v;
	to_octahedron(unit, &u, &v);
	photon->direction[0] = (uint16_t)quantize(u, FINE);
	photon->direction[1] = (uint16_t)quantize(v, FINE);
}

void photon_set_direction(Photon *photon, Vec3 unit) { set_direction(photon, &unit); }

Vec3 photon_direction(const Photon *photon)
{
	return from_octahedron(dequantize(photon->direction[0], FINE),
			       dequantize(photon->direction[1], FINE));
}

static inline void set_normal(Photon *photon, const Vec3 *unit)
{
	double u, v;
	to_octahedron(unit, &u, &v);
	photon->normal[0] = (uint8_t)quantize(u, COARSE);
	photon->normal[1] = (uint8_t)quantize(v, COARSE);
}

void photon_set_normal(Photon *photon, Vec3 unit) { set_normal(photon, &unit); }

Vec3 photon_normal(const Photon *photon)
{
	return from_octahedron(dequantize(photon->normal[0], COARSE),
			       dequantize(photon->normal[1], COARSE));
}

/* ---- all at once ---- */

void photon_set_arrival(Photon *photon, Rgb flux, const Vec3 *direction, const Vec3 *normal)
{
	set_flux(photon, flux);
	set_direction(photon, direction);
	set_normal(photon, normal);
}
