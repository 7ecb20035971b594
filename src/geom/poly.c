/*
 * A ray turns the polynomial in x, y, z into one in t: Horner's scheme over the three variables,
 * each a linear polynomial of t. Coefficients stand in the order that the scheme needs them: x^i
 * falling, within it y^j, within it z^k. The ray's origin is first moved to the point nearest to
 * the shape's own origin, where algebraic surfaces usually live.
 */
#include "geom/poly.h"

#include "geom/polynomial.h"

static double shift_to_origin(const Ray *ray)
{
	return -vec3_dot(ray->origin, ray->direction) / vec3_length2(ray->direction);
}

/* ---- quadric ---- */

typedef struct Quadric {
	Vec3 square, mixed, linear; /* of x^2 y^2 z^2; xy xz yz; x y z */
	double constant;
} Quadric;

const void *quadric_create(Arena *arena, const double c[10])
{
	Quadric *quadric = ARENA_NEW(arena, Quadric);
	*quadric = (Quadric){{c[0], c[1], c[2]}, {c[3], c[4], c[5]}, {c[6], c[7], c[8]}, c[9]};
	return quadric;
}

static bool unbounded(const void *data, Box3 *box)
{
	(void)data;
	(void)box;
	return false;
}

/* Half the gradient of the quadratic part: the symmetric matrix times p. */
static Vec3 quadric_times(const Quadric *quadric, Vec3 p)
{
	Vec3 s = quadric->square, m = vec3_scale(quadric->mixed, 0.5);
	return vec3(s.x * p.x + m.x * p.y + m.y * p.z, m.x * p.x + s.y * p.y + m.z * p.z,
	            m.y * p.x + m.z * p.y + s.z * p.z);
}

static int quadric_cross(const Quadric *quadric, const Ray *ray, double t[2])
{
	double shift = shift_to_origin(ray);
	Vec3 o = ray_at(ray, shift), d = ray->direction;
	Vec3 along = quadric_times(quadric, d), at = quadric_times(quadric, o);
	int count = polynomial_quadratic(vec3_dot(d, along), 2 * vec3_dot(d, at) + vec3_dot(quadric->linear, d),
	                                 vec3_dot(o, vec3_add(at, quadric->linear)) + quadric->constant, t);
	for (int i = 0; i < count; i++)
		t[i] += shift;
	return count;
}

static void quadric_intersect(const Shape *self, const Ray *ray, HitList *out)
{
	double t[2];
	int count = quadric_cross(self->data, ray, t);
	for (int i = 0; i < count; i++)
		hit_list_add(out, ray, self, t[i], 0);
}

static bool quadric_nearest(const Shape *self, const Ray *ray, Hit *out)
{
	double t[2];
	int count = quadric_cross(self->data, ray, t);
	for (int i = 0; i < count; i++)
		if (hit_take(out, ray, self, t[i], 0))
			return true;
	return false;
}

static bool quadric_inside(const void *data, Vec3 p)
{
	const Quadric *quadric = data;
	return vec3_dot(p, vec3_add(quadric_times(quadric, p), quadric->linear)) + quadric->constant <= 0;
}

static Vec3 quadric_normal(const void *data, const Hit *hit, Vec3 p)
{
	const Quadric *quadric = data;
	(void)hit;
	Vec3 n = vec3_mad(quadric->linear, 2, quadric_times(quadric, p));
	return vec3_length2(n) > 0 ? n : vec3(1, 0, 0);
}

const ShapeClass quadric_class = {
	.name = "quadric",
	.bounds = unbounded,
	.intersect = quadric_intersect,
	.inside = quadric_inside,
	.normal = quadric_normal,
	.nearest = quadric_nearest,
};

/* ---- polynomials of any order ---- */

typedef struct Poly {
	int order;
	const double *coefficients;
} Poly;

int poly_term_count(int order)
{
	return (order + 1) * (order + 2) * (order + 3) / 6;
}

int poly_term_index(int order, int i, int j, int k)
{
	if (i < 0 || j < 0 || k < 0 || i + j + k > order)
		return -1;
	int below_x = order - i, below_y = below_x - j, below_z = below_y - k;
	return below_x * (below_x + 1) * (below_x + 2) / 6 + below_y * (below_y + 1) / 2 + below_z;
}

const void *poly_create(Arena *arena, int order, const double *coefficients, const char **error)
{
	if (order < POLY_MIN_ORDER || order > POLY_MAX_ORDER) {
		*error = "the order must be from 2 to 35";
		return NULL;
	}
	Poly *poly = ARENA_NEW(arena, Poly);
	poly->order = order;
	poly->coefficients = arena_copy(arena, coefficients, sizeof(double) * (size_t)poly_term_count(order));
	return poly;
}

/* sum = sum * (origin + t step) + extra, where sum has the degree `degree` - 1 and extra at most
 * `degree`. */
static void multiply_add(double *sum, int degree, double origin, double step, const double *extra)
{
	sum[degree] = 0;
	for (int i = degree; i > 0; i--)
		sum[i] = sum[i] * origin + sum[i - 1] * step + extra[i];
	sum[0] = sum[0] * origin + extra[0];
}

/* The polynomial of z alone: the next degree + 1 coefficients, highest first. */
static const double *substitute_z(const double *c, int degree, double origin, double step, double *out)
{
	out[0] = *c++;
	for (int n = 1; n <= degree; n++) {
		out[n] = out[n - 1] * step;
		for (int i = n - 1; i > 0; i--)
			out[i] = out[i] * origin + out[i - 1] * step;
		out[0] = out[0] * origin + *c++;
	}
	return c;
}

static const double *substitute_yz(const double *c, int degree, const Ray *ray, double *out)
{
	double inner[POLY_MAX_ORDER + 1];
	c = substitute_z(c, 0, ray->origin.z, ray->direction.z, out);
	for (int n = 1; n <= degree; n++) {
		c = substitute_z(c, n, ray->origin.z, ray->direction.z, inner);
		multiply_add(out, n, ray->origin.y, ray->direction.y, inner);
	}
	return c;
}

static void substitute_ray(const Poly *poly, const Ray *ray, double *out)
{
	double inner[POLY_MAX_ORDER + 1];
	const double *c = substitute_yz(poly->coefficients, 0, ray, out);
	for (int n = 1; n <= poly->order; n++) {
		c = substitute_yz(c, n, ray, inner);
		multiply_add(out, n, ray->origin.x, ray->direction.x, inner);
	}
}

static int poly_cross(const Poly *poly, const Ray *ray, double *t)
{
	double c[POLY_MAX_ORDER + 1], shift = shift_to_origin(ray);
	Ray moved = {ray_at(ray, shift), ray->direction, ray->tmin - shift, ray->tmax - shift};
	substitute_ray(poly, &moved, c);
	int count = polynomial_roots(c, poly->order, moved.tmin, moved.tmax, t);
	for (int i = 0; i < count; i++)
		t[i] += shift;
	return count;
}

static void poly_intersect(const Shape *self, const Ray *ray, HitList *out)
{
	double t[POLY_MAX_ORDER];
	int count = poly_cross(self->data, ray, t);
	for (int i = 0; i < count; i++)
		hit_list_add(out, ray, self, t[i], 0);
}

/* Value and gradient by the same scheme. */
static double poly_eval(const Poly *poly, Vec3 p, Vec3 *gradient)
{
	const double *c = poly->coefficients;
	double value = 0;
	Vec3 slope = vec3_all(0);
	for (int i = poly->order; i >= 0; i--) {
		double y_value = 0, y_slope = 0, yz_slope = 0;
		for (int j = poly->order - i; j >= 0; j--) {
			double z_value = 0, z_slope = 0;
			for (int k = poly->order - i - j; k >= 0; k--) {
				z_slope = z_slope * p.z + z_value;
				z_value = z_value * p.z + *c++;
			}
			y_slope = y_slope * p.y + y_value;
			y_value = y_value * p.y + z_value;
			yz_slope = yz_slope * p.y + z_slope;
		}
		slope = vec3(slope.x * p.x + value, slope.y * p.x + y_slope, slope.z * p.x + yz_slope);
		value = value * p.x + y_value;
	}
	*gradient = slope;
	return value;
}

static bool poly_inside(const void *data, Vec3 p)
{
	Vec3 gradient;
	return poly_eval(data, p, &gradient) <= 0;
}

static Vec3 poly_normal(const void *data, const Hit *hit, Vec3 p)
{
	Vec3 gradient;
	(void)hit;
	poly_eval(data, p, &gradient);
	return vec3_length2(gradient) > 0 ? gradient : vec3(1, 0, 0);
}

const ShapeClass poly_class = {
	.name = "poly",
	.bounds = unbounded,
	.intersect = poly_intersect,
	.inside = poly_inside,
	.normal = poly_normal,
};
