/*
 * Colours: linear, in the scene's working space, single precision. Rgbft is POV-Ray's five-part
 * colour: filter is the share of light that passes tinted by the colour, transmit the share that
 * passes untinted.
 */
#ifndef BASE_COLOR_H
#define BASE_COLOR_H

#include <stdbool.h>

typedef struct Rgb { float r, g, b; } Rgb;
typedef struct Rgbft { float r, g, b, filter, transmit; } Rgbft;

static inline Rgb rgb(float r, float g, float b) { return (Rgb){r, g, b}; }
static inline Rgb rgb_all(float s) { return (Rgb){s, s, s}; }
static inline Rgb rgb_add(Rgb a, Rgb b) { return (Rgb){a.r + b.r, a.g + b.g, a.b + b.b}; }
static inline Rgb rgb_sub(Rgb a, Rgb b) { return (Rgb){a.r - b.r, a.g - b.g, a.b - b.b}; }
static inline Rgb rgb_mul(Rgb a, Rgb b) { return (Rgb){a.r * b.r, a.g * b.g, a.b * b.b}; }
static inline Rgb rgb_scale(Rgb a, float s) { return (Rgb){a.r * s, a.g * s, a.b * s}; }
/* a + s b */
static inline Rgb rgb_mad(Rgb a, float s, Rgb b)
{
	return (Rgb){a.r + s * b.r, a.g + s * b.g, a.b + s * b.b};
}
static inline Rgb rgb_lerp(Rgb a, Rgb b, float s) { return rgb_mad(a, s, rgb_sub(b, a)); }
static inline bool rgb_is_black(Rgb a) { return a.r == 0 && a.g == 0 && a.b == 0; }
static inline float rgb_max(Rgb a)
{
	float m = a.r > a.g ? a.r : a.g;
	return m > a.b ? m : a.b;
}
/* POV-Ray's grey value of a colour. */
static inline Rgb rgb_gray_parts(Rgb a) { return (Rgb){0.297f * a.r, 0.589f * a.g, 0.114f * a.b}; }
static inline float rgb_gray(Rgb a) { return 0.297f * a.r + 0.589f * a.g + 0.114f * a.b; }

static inline Rgbft rgbft(float r, float g, float b, float filter, float transmit)
{
	return (Rgbft){r, g, b, filter, transmit};
}
static inline Rgb rgbft_rgb(Rgbft c) { return (Rgb){c.r, c.g, c.b}; }
static inline Rgbft rgbft_opaque(Rgb c) { return (Rgbft){c.r, c.g, c.b, 0, 0}; }
static inline Rgbft rgbft_lerp(Rgbft a, Rgbft b, float s)
{
	return (Rgbft){a.r + s * (b.r - a.r), a.g + s * (b.g - a.g), a.b + s * (b.b - a.b),
		       a.filter + s * (b.filter - a.filter),
		       a.transmit + s * (b.transmit - a.transmit)};
}
/* Share of light that the surface itself reflects diffusely: 1 - filter - transmit, at least 0. */
static inline float rgbft_opacity(Rgbft c)
{
	float o = 1 - c.filter - c.transmit;
	return o > 0 ? o : 0;
}
/* What light passing through the surface is multiplied with: filter * colour + transmit. */
static inline Rgb rgbft_transmittance(Rgbft c)
{
	return (Rgb){c.filter * c.r + c.transmit, c.filter * c.g + c.transmit,
		     c.filter * c.b + c.transmit};
}

#endif
