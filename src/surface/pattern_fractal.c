/*
 * Fractals in the x-y plane: Mandelbrot and Julia sets of integer exponents and the two magnet
 * fractals (the iterations are in POV-Ray's manual and in any book on fractals). The iteration
 * counts, bail-outs and colourings are as measured.
 */
#include <math.h>

#include "surface/pattern_classes.h"
#include "surface/pattern_data.h"

typedef struct Complex {
	double r, i;
} Complex;

static Complex complex_add(Complex a, Complex b) { return (Complex){a.r + b.r, a.i + b.i}; }
static Complex complex_mul(Complex a, Complex b)
{
	return (Complex){a.r * b.r - a.i * b.i, a.r * b.i + a.i * b.r};
}
static double complex_norm(Complex a) { return a.r * a.r + a.i * a.i; }

static Complex complex_div(Complex a, Complex b)
{
	double n = complex_norm(b);
	return (Complex){(a.r * b.r + a.i * b.i) / n, (a.i * b.r - a.r * b.i) / n};
}

static Complex complex_power(Complex z, int n)
{
	Complex result = z;
	while (--n > 0)
		result = complex_mul(result, z);
	return result;
}

static const FractalData fractal_usual = {
	.iterations = 20, .exponent = 2, .exterior = 1, .exterior_factor = 1, .interior_factor = 1};

/* One of the orbit's coordinates, squared or not, that colourings 2 to 6 take. */
static double orbit_part(int type, Complex z)
{
	switch (type) {
	case 2:
		return z.r;
	case 3:
		return z.i;
	case 4:
		return z.r * z.r;
	case 5:
		return z.i * z.i;
	default:
		return sqrt(complex_norm(z));
	}
}

static double exterior_value(const FractalData *f, int count, Complex z)
{
	int whole = (int)fmin(fmax(f->exterior_factor, -1), 1e9); /* counts go round by this */
	switch (f->exterior) {
	case 0:
		return f->exterior_factor;
	case 1:
		return (double)count / f->iterations;
	case 7:
		return whole >= 1 ? count % whole / f->exterior_factor : 0;
	case 8:
		return whole >= 0 ? count % (whole + 1) / f->exterior_factor : 0;
	default:
		return orbit_part(f->exterior, z) * f->exterior_factor;
	}
}

static double interior_value(const FractalData *f, double nearest, Complex z)
{
	switch (f->interior) {
	case 0:
		return f->interior_factor;
	case 1:
		return sqrt(nearest) * f->interior_factor;
	case 6: /* not what the manual says */
		return z.r * z.r + z.i * z.i * f->interior_factor;
	default:
		return orbit_part(f->interior, z) * f->interior_factor;
	}
}

/* z -> z^n + c, left when |z| > 2. The orbit starts at z; a Julia set's c is fixed. */
static double power_fractal(const FractalData *f, Complex z, Complex c)
{
	double nearest = complex_norm(z);
	for (int n = 0; n < f->iterations; n++) {
		z = complex_add(complex_power(z, f->exponent), c);
		double norm = complex_norm(z);
		if (norm < nearest)
			nearest = norm;
		if (norm > 4)
			return exterior_value(f, n, z);
	}
	return interior_value(f, nearest, z);
}

static double value_mandel(const Pattern *pattern, const SurfacePoint *at)
{
	const FractalData *f = pattern->data ? pattern->data : &fractal_usual;
	Complex c = {at->p.x, at->p.y};
	return power_fractal(f, c, c);
}

static double value_julia(const Pattern *pattern, const SurfacePoint *at)
{
	const FractalData *f = pattern->data;
	return power_fractal(f, (Complex){at->p.x, at->p.y}, (Complex){f->real, f->imaginary});
}

static Complex magnet1_step(Complex z, Complex c)
{
	Complex above = complex_add(complex_mul(z, z), (Complex){c.r - 1, c.i});
	Complex below = {2 * z.r + c.r - 2, 2 * z.i + c.i};
	return complex_power(complex_div(above, below), 2);
}

static Complex magnet2_step(Complex z, Complex c)
{
	Complex c1 = {c.r - 1, c.i}, c2 = {c.r - 2, c.i}, product = complex_mul(c1, c2),
			square = complex_mul(z, z);
	Complex above = complex_add(complex_mul(z, square), product);
	above = complex_add(above, complex_mul((Complex){3 * c1.r, 3 * c1.i}, z));
	Complex below = {3 * square.r + product.r + 1, 3 * square.i + product.i};
	below = complex_add(below, complex_mul((Complex){3 * c2.r, 3 * c2.i}, z));
	return complex_power(complex_div(above, below), 2);
}

/* Left when |z| > 100, or when the orbit comes to the attractor 1. */
static double magnet_fractal(const FractalData *f, Complex (*step)(Complex, Complex), Complex z,
                             Complex c)
{
	double nearest = z.r == 0 && z.i == 0 ? HUGE_VAL : complex_norm(z);
	for (int n = 0; n < f->iterations; n++) {
		z = step(z, c);
		double norm = complex_norm(z);
		if (norm < nearest)
			nearest = norm;
		if (norm > 10000 || complex_norm((Complex){z.r - 1, z.i}) < 1e-4 || !isfinite(norm))
			return exterior_value(f, n, z);
	}
	return interior_value(f, nearest, z);
}

static double magnet_mandel(const Pattern *pattern, const SurfacePoint *at,
                            Complex (*step)(Complex, Complex))
{
	const FractalData *f = pattern->data ? pattern->data : &fractal_usual;
	return magnet_fractal(f, step, (Complex){0, 0}, (Complex){at->p.x, at->p.y});
}

static double magnet_julia(const Pattern *pattern, const SurfacePoint *at,
                           Complex (*step)(Complex, Complex))
{
	const FractalData *f = pattern->data;
	return magnet_fractal(f, step, (Complex){at->p.x, at->p.y},
			      (Complex){f->real, f->imaginary});
}

static double value_magnet1m(const Pattern *p, const SurfacePoint *at)
{
	return magnet_mandel(p, at, magnet1_step);
}
static double value_magnet2m(const Pattern *p, const SurfacePoint *at)
{
	return magnet_mandel(p, at, magnet2_step);
}
static double value_magnet1j(const Pattern *p, const SurfacePoint *at)
{
	return magnet_julia(p, at, magnet1_step);
}
static double value_magnet2j(const Pattern *p, const SurfacePoint *at)
{
	return magnet_julia(p, at, magnet2_step);
}

const PatternClass pattern_mandel = {"mandel", value_mandel, 0, NULL, 0};
const PatternClass pattern_julia = {"julia", value_julia, 0, NULL, PATTERN_NEEDS_DATA};
const PatternClass pattern_magnet1m = {"magnet1m", value_magnet1m, 0, NULL, 0};
const PatternClass pattern_magnet1j = {"magnet1j", value_magnet1j, 0, NULL, PATTERN_NEEDS_DATA};
const PatternClass pattern_magnet2m = {"magnet2m", value_magnet2m, 0, NULL, 0};
const PatternClass pattern_magnet2j = {"magnet2j", value_magnet2j, 0, NULL, PATTERN_NEEDS_DATA};
