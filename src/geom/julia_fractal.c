/*
 * A ray in three dimensions is one in four: w follows from the slice's plane. Outside, an estimate
 * of the distance to the set gives the step, never less than 1 / precision; where the set is met,
 * the step is bisected. The estimate is the classic |z| log |z| / 2 |z'| of Julia sets of
 * polynomials (Hart, Sandin, Kauffman 1989); hypercomplex numbers go by the least step alone. The
 * normal is the gradient of the last iterate's length, by the chain rule.
 *
 * Hypercomplex numbers are pairs of complex ones: with a = (x - w) + i (y + z) and b = (x + w) + i
 * (y - z) every function acts on a and b alone.
 */
#include "geom/julia_fractal.h"

#include <complex.h>
#include <float.h>

#include "geom/sphere.h"

enum { BISECTIONS = 12 };

/* What is done for each iterate is too small for a call. */
#define INLINE static inline __attribute__((always_inline))

/* Iterates beyond this squared length have escaped. */
static const double ESCAPE = 16;
/* Gradients stop at iterates so long, before anything overflows. */
static const double FAR = 1e10;

typedef struct Vec4 {
	double x, y, z, w;
} Vec4;

typedef struct Pair {
	double complex a, b;
} Pair;

typedef struct JuliaFractal {
	JuliaDesc desc;
	Vec4 parameter;
	Pair pair;       /* the parameter as a pair */
	Vec3 tilt;       /* w = offset + dot(tilt, p) */
	double offset;
	double radius;   /* of the ball that holds the set */
	double least;    /* 1 / precision */
	int iterations;  /* looked at after the point itself */
} JuliaFractal;

JuliaDesc julia_default(void)
{
	return (JuliaDesc){.max_iteration = 20, .precision = 20, .slice_normal = {0, 0, 0, 1}};
}

const void *julia_create(Arena *arena, const JuliaDesc *desc, const char **error)
{
	const double *n = desc->slice_normal;
	JuliaFractal *julia = ARENA_NEW(arena, JuliaFractal);
	if (n[3] == 0) {
		*error = "the fourth component of the slice's normal must not be zero";
		return NULL;
	}
	bool polynomial = desc->function == JULIA_SQR || desc->function == JULIA_CUBE;
	if (!desc->hypercomplex && !polynomial) {
		*error = "quaternions know sqr and cube only";
		return NULL;
	}
	julia->desc = *desc;
	/* POV-Ray's images show the square's set for the hypercomplex cube. */
	if (desc->hypercomplex && desc->function == JULIA_CUBE)
		julia->desc.function = JULIA_SQR;
	julia->parameter = (Vec4){desc->parameter[0], desc->parameter[1], desc->parameter[2],
				  desc->parameter[3]};
	Vec4 p = julia->parameter;
	julia->pair = (Pair){CMPLX(p.x - p.w, p.y + p.z), CMPLX(p.x + p.w, p.y - p.z)};
	julia->tilt = vec3(-n[0] / n[3], -n[1] / n[3], -n[2] / n[3]);
	julia->offset = desc->slice_distance *
			sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2] + n[3] * n[3]) / n[3];
	julia->least = 1 / fmax(1, desc->precision);
	/* POV-Ray's images show that the point itself counts as the first hypercomplex number,
	 * but not as the first quaternion. */
	julia->iterations = desc->hypercomplex ? desc->max_iteration - 1 : desc->max_iteration;
	double length = 1 + sqrt(p.x * p.x + p.y * p.y + p.z * p.z + p.w * p.w);
	julia->radius = desc->hypercomplex ? 4 : fmin(2, length);
	return julia;
}

static bool julia_bounds(const void *data, Box3 *box)
{
	double radius = ((const JuliaFractal *)data)->radius;
	*box = (Box3){vec3_all(-radius), vec3_all(radius)};
	return true;
}

static Vec4 into_slice(const JuliaFractal *julia, Vec3 p)
{
	return (Vec4){p.x, p.y, p.z, julia->offset + vec3_dot(julia->tilt, p)};
}

INLINE double length2(Vec4 q)
{
	return q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w;
}

/* ---- quaternions ---- */

INLINE Vec4 multiply(Vec4 p, Vec4 q)
{
	return (Vec4){p.x * q.x - p.y * q.y - p.z * q.z - p.w * q.w,
		      p.x * q.y + p.y * q.x + p.z * q.w - p.w * q.z,
		      p.x * q.z - p.y * q.w + p.z * q.x + p.w * q.y,
		      p.x * q.w + p.y * q.z - p.z * q.y + p.w * q.x};
}

INLINE Vec4 add(Vec4 p, Vec4 q)
{
	return (Vec4){p.x + q.x, p.y + q.y, p.z + q.z, p.w + q.w};
}

INLINE Vec4 square(Vec4 q)
{
	return (Vec4){q.x * q.x - q.y * q.y - q.z * q.z - q.w * q.w, 2 * q.x * q.y, 2 * q.x * q.z,
		      2 * q.x * q.w};
}

INLINE Vec4 quaternion_next(const JuliaFractal *julia, Vec4 q, bool cube)
{
	Vec4 power = square(q);
	return add(cube ? multiply(power, q) : power, julia->parameter);
}

/* The derivative of q^2 along v: q v + v q. */
static Vec4 square_slope(Vec4 q, Vec4 v)
{
	return (Vec4){2 * (q.x * v.x - q.y * v.y - q.z * v.z - q.w * v.w),
		      2 * (q.x * v.y + q.y * v.x), 2 * (q.x * v.z + q.z * v.x),
		      2 * (q.x * v.w + q.w * v.x)};
}

static Vec4 quaternion_slope(const JuliaFractal *julia, Vec4 q, Vec4 v)
{
	Vec4 slope = square_slope(q, v);
	if (julia->desc.function == JULIA_SQR)
		return slope;
	return add(multiply(slope, q), multiply(square(q), v));
}

/* Distance to the set, 0 inside. */
INLINE double distance_by(const JuliaFractal *julia, Vec4 q, bool cube)
{
	double growth2 = 1, r2 = length2(q);
	for (int i = 0; i < julia->iterations; i++) {
		growth2 *= cube ? 9 * r2 * r2 : 4 * r2;
		q = quaternion_next(julia, q, cube);
		r2 = length2(q);
		if (r2 > ESCAPE)
			return real_max(DBL_MIN, 0.25 * log(r2) * sqrt(r2 / growth2));
	}
	return 0;
}

static double quaternion_distance(const JuliaFractal *julia, Vec4 q)
{
	return julia->desc.function == JULIA_CUBE ? distance_by(julia, q, true)
						  : distance_by(julia, q, false);
}

static double dot(Vec4 p, Vec4 q)
{
	return p.x * q.x + p.y * q.y + p.z * q.z + p.w * q.w;
}

static Vec3 quaternion_gradient(const JuliaFractal *julia, Vec4 q)
{
	Vec4 x = {1, 0, 0, julia->tilt.x}, y = {0, 1, 0, julia->tilt.y},
	     z = {0, 0, 1, julia->tilt.z};
	for (int i = 0; i < julia->iterations && length2(q) <= FAR; i++) {
		x = quaternion_slope(julia, q, x);
		y = quaternion_slope(julia, q, y);
		z = quaternion_slope(julia, q, z);
		q = quaternion_next(julia, q, julia->desc.function == JULIA_CUBE);
	}
	return vec3(dot(q, x), dot(q, y), dot(q, z));
}

/* ---- hypercomplex numbers ---- */

static Pair to_pair(Vec4 q)
{
	return (Pair){CMPLX(q.x - q.w, q.y + q.z), CMPLX(q.x + q.w, q.y - q.z)};
}

static double norm2(double complex c)
{
	return creal(c) * creal(c) + cimag(c) * cimag(c);
}

static double complex julia_function(const JuliaDesc *desc, double complex c)
{
	switch (desc->function) {
	case JULIA_SQR: return c * c;
	case JULIA_CUBE: return c * c * c;
	case JULIA_EXP: return cexp(c);
	case JULIA_RECIPROCAL: return 1 / c;
	case JULIA_SIN: return csin(c);
	case JULIA_ASIN: return casin(c);
	case JULIA_SINH: return csinh(c);
	case JULIA_ASINH: return casinh(c);
	case JULIA_COS: return ccos(c);
	case JULIA_ACOS: return cacos(c);
	case JULIA_COSH: return ccosh(c);
	case JULIA_ACOSH: return cacosh(c);
	case JULIA_TAN: return ctan(c);
	case JULIA_ATAN: return catan(c);
	case JULIA_TANH: return ctanh(c);
	case JULIA_ATANH: return catanh(c);
	case JULIA_LN: return clog(c);
	case JULIA_PWR: return cpow(c, CMPLX(desc->exponent.u, desc->exponent.v));
	}
	return 0;
}

static double complex julia_derivative(const JuliaDesc *desc, double complex c)
{
	double complex e;
	switch (desc->function) {
	case JULIA_SQR: return 2 * c;
	case JULIA_CUBE: return 3 * c * c;
	case JULIA_EXP: return cexp(c);
	case JULIA_RECIPROCAL: return -1 / (c * c);
	case JULIA_SIN: return ccos(c);
	case JULIA_ASIN: return 1 / csqrt(1 - c * c);
	case JULIA_SINH: return ccosh(c);
	case JULIA_ASINH: return 1 / csqrt(1 + c * c);
	case JULIA_COS: return -csin(c);
	case JULIA_ACOS: return -1 / csqrt(1 - c * c);
	case JULIA_COSH: return csinh(c);
	case JULIA_ACOSH: return 1 / (csqrt(c - 1) * csqrt(c + 1));
	case JULIA_TAN: return e = ccos(c), 1 / (e * e);
	case JULIA_ATAN: return 1 / (1 + c * c);
	case JULIA_TANH: return e = ccosh(c), 1 / (e * e);
	case JULIA_ATANH: return 1 / (1 - c * c);
	case JULIA_LN: return 1 / c;
	case JULIA_PWR: return e = CMPLX(desc->exponent.u, desc->exponent.v), e * cpow(c, e - 1);
	}
	return 0;
}

static Pair pair_next(const JuliaFractal *julia, Pair h)
{
	return (Pair){julia_function(&julia->desc, h.a) + julia->pair.a,
		      julia_function(&julia->desc, h.b) + julia->pair.b};
}

/* Squared length of the four numbers. */
static double pair_length2(Pair h)
{
	return 0.5 * (norm2(h.a) + norm2(h.b));
}

static double hypercomplex_distance(const JuliaFractal *julia, Vec4 q)
{
	Pair h = to_pair(q);
	for (int i = 0; i < julia->iterations; i++) {
		h = pair_next(julia, h);
		/* Not a number counts as escaped. */
		if (!(pair_length2(h) <= ESCAPE))
			return julia->least;
	}
	return 0;
}

/* Of the iterate that comes nearest to escaping: it decides where the surface is. */
static Vec3 hypercomplex_gradient(const JuliaFractal *julia, Vec4 q)
{
	Pair h = to_pair(q), slope = {1, 1}, gradient = {0, 0};
	double largest = 0;
	for (int i = 0; i < julia->iterations && pair_length2(h) <= FAR; i++) {
		slope.a *= julia_derivative(&julia->desc, h.a);
		slope.b *= julia_derivative(&julia->desc, h.b);
		h = pair_next(julia, h);
		if (!(pair_length2(h) > largest))
			continue;
		largest = pair_length2(h);
		gradient = (Pair){conj(slope.a) * h.a, conj(slope.b) * h.b};
	}
	Vec3 g = vec3(creal(gradient.a) + creal(gradient.b), cimag(gradient.a) + cimag(gradient.b),
	              cimag(gradient.a) - cimag(gradient.b));
	return vec3_mad(g, creal(gradient.b) - creal(gradient.a), julia->tilt);
}

/* ---- the ray ---- */

static double julia_distance(const JuliaFractal *julia, Vec3 p)
{
	Vec4 q = into_slice(julia, p);
	return julia->desc.hypercomplex ? hypercomplex_distance(julia, q)
					: quaternion_distance(julia, q);
}

static bool julia_inside(const void *data, Vec3 p)
{
	const JuliaFractal *julia = data;
	return vec3_length2(p) <= julia->radius * julia->radius && julia_distance(julia, p) == 0;
}

/* Between an outer and an inner place of the ray: the end of the outer part. */
static double julia_bisect(const JuliaFractal *julia, const Ray *ray, double outer, double inner)
{
	for (int i = 0; i < BISECTIONS; i++) {
		double middle = 0.5 * (outer + inner);
		if (julia_distance(julia, ray_at(ray, middle)) > 0)
			outer = middle;
		else
			inner = middle;
	}
	return outer;
}

/* Crossings in rising order until the list has `most`. */
static void julia_cross(const Shape *self, const Ray *ray, int most, HitList *out)
{
	const JuliaFractal *julia = self->data;
	double t[2], lean = vec3_dot(julia->tilt, ray->direction);
	double speed = vec3_length(ray->direction), speed4 = sqrt(speed * speed + lean * lean);
	if (!sphere_cross(vec3_all(0), julia->radius, ray, t))
		return;
	double at = fmax(t[0], ray->tmin), end = fmin(t[1], ray->tmax), last = at;
	bool was_inside = at < end && julia_distance(julia, ray_at(ray, at)) == 0;
	while (at < end && out->count < most) {
		double distance = julia_distance(julia, ray_at(ray, at));
		bool inside = distance == 0;
		if (inside != was_inside) {
			double crossing =
				julia_bisect(julia, ray, inside ? last : at, inside ? at : last);
			hit_list_add(out, ray, self, crossing, 0);
		}
		was_inside = inside;
		last = at;
		at += real_max(distance / speed4, julia->least / speed);
	}
}

static void julia_intersect(const Shape *self, const Ray *ray, HitList *out)
{
	julia_cross(self, ray, 1 << 20, out);
}

static bool julia_nearest(const Shape *self, const Ray *ray, Hit *out)
{
	return hit_nearest_by(julia_cross, self, ray, out);
}

static Vec3 julia_normal(const void *data, const Hit *hit, Vec3 p)
{
	const JuliaFractal *julia = data;
	(void)hit;
	Vec4 q = into_slice(julia, p);
	Vec3 n = julia->desc.hypercomplex ? hypercomplex_gradient(julia, q)
					  : quaternion_gradient(julia, q);
	return vec3_is_finite(n) && vec3_length2(n) > 0 ? n : p;
}

const ShapeClass julia_fractal_class = {
	.name = "julia_fractal",
	.bounds = julia_bounds,
	.intersect = julia_intersect,
	.inside = julia_inside,
	.normal = julia_normal,
	.nearest = julia_nearest,
};
