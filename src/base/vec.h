/* Vectors and boxes in double precision: the renderer's geometry. Points and directions share one
 * type. */
#ifndef BASE_VEC_H
#define BASE_VEC_H

#include <math.h>
#include <stdbool.h>

typedef struct Vec2 { double u, v; } Vec2;
typedef struct Vec3 { double x, y, z; } Vec3;

/* An axis-aligned box; empty when any lo exceeds its hi. */
typedef struct Box3 { Vec3 lo, hi; } Box3;

/* The lesser and the greater of two numbers in one instruction each; for a NaN the second. */
static inline double real_min(double a, double b) { return a < b ? a : b; }
static inline double real_max(double a, double b) { return a > b ? a : b; }

static inline Vec3 vec3(double x, double y, double z) { return (Vec3){x, y, z}; }
/* Where numbers are kept in single precision. */
static inline Vec3 vec3_of_floats(const float v[3])
{
	return (Vec3){(double)v[0], (double)v[1], (double)v[2]};
}
static inline void vec3_to_floats(Vec3 a, float out[3])
{
	out[0] = (float)a.x;
	out[1] = (float)a.y;
	out[2] = (float)a.z;
}
static inline Vec3 vec3_all(double s) { return (Vec3){s, s, s}; }
static inline Vec3 vec3_add(Vec3 a, Vec3 b) { return (Vec3){a.x + b.x, a.y + b.y, a.z + b.z}; }
static inline Vec3 vec3_sub(Vec3 a, Vec3 b) { return (Vec3){a.x - b.x, a.y - b.y, a.z - b.z}; }
static inline Vec3 vec3_mul(Vec3 a, Vec3 b) { return (Vec3){a.x * b.x, a.y * b.y, a.z * b.z}; }
static inline Vec3 vec3_scale(Vec3 a, double s) { return (Vec3){a.x * s, a.y * s, a.z * s}; }
static inline Vec3 vec3_neg(Vec3 a) { return (Vec3){-a.x, -a.y, -a.z}; }
/* a + s b */
static inline Vec3 vec3_mad(Vec3 a, double s, Vec3 b)
{
	return (Vec3){a.x + s * b.x, a.y + s * b.y, a.z + s * b.z};
}
static inline double vec3_dot(Vec3 a, Vec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
static inline Vec3 vec3_cross(Vec3 a, Vec3 b)
{
	return (Vec3){a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
static inline double vec3_length2(Vec3 a) { return vec3_dot(a, a); }
static inline double vec3_length(Vec3 a) { return sqrt(vec3_dot(a, a)); }
static inline double vec3_distance(Vec3 a, Vec3 b) { return vec3_length(vec3_sub(a, b)); }
/* The zero vector stays zero. */
static inline Vec3 vec3_normalize(Vec3 a)
{
	double length = vec3_length(a);
	return length > 0 ? vec3_scale(a, 1 / length) : a;
}
/* For what is a unit vector but for rounding: a step of Newton's towards 1 / length. */
static inline Vec3 vec3_unit_again(Vec3 a)
{
	return vec3_scale(a, 1.5 - 0.5 * vec3_length2(a));
}
static inline Vec3 vec3_lerp(Vec3 a, Vec3 b, double s) { return vec3_mad(a, s, vec3_sub(b, a)); }
static inline Vec3 vec3_min(Vec3 a, Vec3 b)
{
	return (Vec3){fmin(a.x, b.x), fmin(a.y, b.y), fmin(a.z, b.z)};
}
static inline Vec3 vec3_max(Vec3 a, Vec3 b)
{
	return (Vec3){fmax(a.x, b.x), fmax(a.y, b.y), fmax(a.z, b.z)};
}
/* The angle about the y axis, from x towards z, as a share of a turn: 0..1. */
static inline double vec3_turn(Vec3 a)
{
	double turn = atan2(a.z, a.x) / (2 * M_PI);
	return turn < 0 ? turn + 1 : turn;
}
static inline double vec3_axis(Vec3 a, int axis) { return axis == 0 ? a.x : axis == 1 ? a.y : a.z; }
/* Mirror of the direction d at a plane with unit normal n. */
static inline Vec3 vec3_reflect(Vec3 d, Vec3 n) { return vec3_mad(d, -2 * vec3_dot(d, n), n); }
static inline bool vec3_is_finite(Vec3 a)
{
	return isfinite(a.x) && isfinite(a.y) && isfinite(a.z);
}

/* Two unit tangents u, v such that (u, v, n) is a right-handed orthonormal frame; n is a unit
 * vector. */
static inline void vec3_frame(Vec3 n, Vec3 *u, Vec3 *v)
{
	double sign = copysign(1.0, n.z);
	double a = -1.0 / (sign + n.z), b = n.x * n.y * a;
	*u = vec3(1 + sign * n.x * n.x * a, sign * b, -sign * n.x);
	*v = vec3(b, sign + n.y * n.y * a, -n.y);
}

static inline Box3 box3_empty(void)
{
	return (Box3){{INFINITY, INFINITY, INFINITY}, {-INFINITY, -INFINITY, -INFINITY}};
}
static inline Box3 box3_add(Box3 b, Vec3 p) { return (Box3){vec3_min(b.lo, p), vec3_max(b.hi, p)}; }
static inline Box3 box3_union(Box3 a, Box3 b)
{
	return (Box3){vec3_min(a.lo, b.lo), vec3_max(a.hi, b.hi)};
}
static inline Box3 box3_intersect(Box3 a, Box3 b)
{
	return (Box3){vec3_max(a.lo, b.lo), vec3_min(a.hi, b.hi)};
}
static inline bool box3_is_empty(Box3 b)
{
	return b.lo.x > b.hi.x || b.lo.y > b.hi.y || b.lo.z > b.hi.z;
}
static inline bool box3_contains(Box3 b, Vec3 p)
{
	return p.x >= b.lo.x && p.x <= b.hi.x && p.y >= b.lo.y && p.y <= b.hi.y && p.z >= b.lo.z &&
	       p.z <= b.hi.z;
}

#endif
