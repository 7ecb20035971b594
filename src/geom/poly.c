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
	Vec3 center; /* x y z are counted from here */
	Vec3 square, mixed, linear; /* of x^2 y^2 z^2; xy xz yz; x y z */
	double constant;
} Quadric;

const void *quadric_create(Arena *arena, const double c[10])
{
	Quadric *quadric = ARENA_NEW(arena, Quadric);
	*quadric = (Quadric){
		vec3_all(0), {c[0], c[1], c[2]}, {c[3], c[4], c[5]}, {c[6], c[7], c[8]}, c[9]};
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
	Ray own = {vec3_sub(ray->origin, quadric->center), ray->direction, ray->tmin, ray->tmax};
	double shift = shift_to_origin(&own);
	Vec3 o = ray_at(&own, shift), d = ray->direction;
	Vec3 along = quadric_times(quadric, d), at = quadric_times(quadric, o);
	int count = polynomial_quadratic(
		vec3_dot(d, along), 2 * vec3_dot(d, at) + vec3_dot(quadric->linear, d),
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
	return hit_take_first(out, ray, self, t, quadric_cross(self->data, ray, t));
}

static bool quadric_inside(const void *data, Vec3 p)
{
	const Quadric *quadric = data;
	p = vec3_sub(p, quadric->center);
	return vec3_dot(p, vec3_add(quadric_times(quadric, p), quadric->linear)) +
		       quadric->constant <=
	       0;
}

static Vec3 quadric_normal(const void *data, const Hit *hit, Vec3 p)
{
	const Quadric *quadric = data;
	(void)hit;
	Vec3 n = vec3_mad(quadric->linear, 2, quadric_times(quadric, vec3_sub(p, quadric->center)));
	return vec3_length2(n) > 0 ? n : vec3(1, 0, 0);
}

/* The symmetric matrix seen from the world: inverse transposed, matrix, inverse; its centre is the
 * image of the old one. */
static const void *quadric_placed(Arena *arena, const void *data, const Transform *transform)
{
	const Quadric *quadric = data;
	Quadric *placed = ARENA_NEW(arena, Quadric);
	Vec3 rows[3];
	for (int i = 0; i < 3; i++) {
		Vec3 axis = vec3(i == 0, i == 1, i == 2);
		rows[i] = transform_normal(
			transform,
			quadric_times(quadric, transform_vector_inverse(transform, axis)));
	}
	*placed = (Quadric){
		.center = transform_point(transform, quadric->center),
		.square = {rows[0].x, rows[1].y, rows[2].z},
		.mixed = {2 * rows[0].y, 2 * rows[0].z, 2 * rows[1].z},
		.linear = transform_normal(transform, quadric->linear),
		.constant = quadric->constant,
	};
	return placed;
}

static double square_and_linear(double a, double b, double x)
{
	if (isinf(x))
		return a != 0 ? a * INFINITY : b != 0 ? b * x : 0;
	return (a * x + b) * x;
}

/* The least of a x^2 + b x over an interval. */
static double least_square_and_linear(double a, double b, double lo, double hi)
{
	double x = -b / (2 * a);
	if (a > 0 && x > lo && x < hi)
		return square_and_linear(a, b, x);
	double low = square_and_linear(a, b, lo), high = square_and_linear(a, b, hi);
	return low < high ? low : high;
}

/* Cuts the interval to where a x^2 + b x <= most. A region of two parts (a < 0) cuts nothing. */
static void cut_interval(double a, double b, double most, double *lo, double *hi)
{
	double roots[2];
	if (a < 0 || (a == 0 && b == 0) || !isfinite(most))
		return;
	int count = polynomial_quadratic(a, b, -most, roots);
	if (count == 0)
		*hi = -INFINITY;
	if ((count == 2 || (count == 1 && b < 0)) && roots[0] > *lo)
		*lo = roots[0];
	if ((count == 2 || (count == 1 && b > 0)) && roots[count - 1] < *hi)
		*hi = roots[count - 1];
}

static bool quadric_is_mixed(const Quadric *quadric)
{
	Vec3 s = quadric->square, m = quadric->mixed;
	return !(vec3_length2(m) <= 1e-24 * vec3_length2(s));
}

/* Axis by axis: what the two others leave. A quadric that is turned cuts nothing. */
static Box3 quadric_cut(const void *data, bool outside, Box3 box)
{
	const Quadric *quadric = data;
	if (quadric_is_mixed(quadric))
		return box;
	double sign = outside ? -1 : 1;
	Vec3 square = vec3_scale(quadric->square, sign), linear = vec3_scale(quadric->linear, sign);
	Box3 own = {vec3_sub(box.lo, quadric->center), vec3_sub(box.hi, quadric->center)};
	double *lo = &own.lo.x, *hi = &own.hi.x;
	const double *a = &square.x, *b = &linear.x;
	for (int i = 0; i < 3; i++) {
		int j = (i + 1) % 3, k = (i + 2) % 3;
		double most = -sign * quadric->constant -
			      least_square_and_linear(a[j], b[j], lo[j], hi[j]) -
			      least_square_and_linear(a[k], b[k], lo[k], hi[k]);
		cut_interval(a[i], b[i], most, &lo[i], &hi[i]);
	}
	return (Box3){vec3_add(own.lo, quadric->center), vec3_add(own.hi, quadric->center)};
}

const ShapeClass quadric_class = {
	.name = "quadric",
	.bounds = unbounded,
	.intersect = quadric_intersect,
	.inside = quadric_inside,
	.normal = quadric_normal,
	.nearest = quadric_nearest,
	.cut = quadric_cut,
	.placed = quadric_placed,
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
	poly->coefficients = arena_copy(arena, coefficients,
					sizeof(double) * (size_t)poly_term_count(order));
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
static const double *substitute_z(const double *c, int degree, double origin, double step,
				  double *out)
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
		slope = vec3(slope.x * p.x + value, slope.y * p.x + y_slope,
			     slope.z * p.x + yz_slope);
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
