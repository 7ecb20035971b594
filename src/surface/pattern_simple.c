/* Patterns of plain geometry: distances, angles, spirals, quilts. Formulas by POV-Ray's manual,
 * details as measured. */
#include <math.h>

#include "surface/pattern_classes.h"
#include "surface/pattern_data.h"
#include "surface/warp.h"

static double value_solid(const Pattern *pattern, const SurfacePoint *at)
{
	(void)pattern;
	(void)at;
	return 0;
}

static double value_gradient(const Pattern *pattern, const SurfacePoint *at)
{
	const GradientData *data = pattern->data;
	double v = vec3_dot(at->p, vec3_normalize(data->direction));
	return v > 1 ? fmod(v, 1) : v;
}

static double falling(double distance) { return distance < 1 ? 1 - distance : 0; }

static double value_planar(const Pattern *pattern, const SurfacePoint *at)
{
	(void)pattern;
	return falling(fabs(at->p.y));
}

static double value_spherical(const Pattern *pattern, const SurfacePoint *at)
{
	(void)pattern;
	return falling(vec3_length(at->p));
}

static double value_cylindrical(const Pattern *pattern, const SurfacePoint *at)
{
	(void)pattern;
	return falling(sqrt(at->p.x * at->p.x + at->p.z * at->p.z));
}

static double value_boxed(const Pattern *pattern, const SurfacePoint *at)
{
	(void)pattern;
	return falling(fmax(fabs(at->p.x), fmax(fabs(at->p.y), fabs(at->p.z))));
}

static double value_radial(const Pattern *pattern, const SurfacePoint *at)
{
	(void)pattern;
	if (fabs(at->p.x) < 0.001 && fabs(at->p.z) < 0.001)
		return 0.25;
	return 0.25 + (atan2(at->p.x, at->p.z) + M_PI) / (2 * M_PI);
}

static double value_onion(const Pattern *pattern, const SurfacePoint *at)
{
	(void)pattern;
	return fmod(vec3_length(at->p), 1);
}

static double value_leopard(const Pattern *pattern, const SurfacePoint *at)
{
	(void)pattern;
	double v = (sin(at->p.x) + sin(at->p.y) + sin(at->p.z)) / 3;
	return v * v;
}

/* Distance from the z axis, turns about it from -y through +x, and the pattern's own turbulence. */
typedef struct Screw {
	double radius, turn, turbulence;
} Screw;

static Screw screw_at(const Pattern *pattern, Vec3 p)
{
	Screw s = {sqrt(p.x * p.x + p.y * p.y), 0, 0};
	if (s.radius > 0)
		s.turn = atan2(p.y, p.x) / (2 * M_PI) + 0.25;
	if (s.turn < 0)
		s.turn += 1;
	const Turbulence *turbulence = warp_find_classic(pattern->warps);
	if (turbulence)
		s.turbulence = turbulence->amount.x *
		               turbulence_value(p, turbulence, pattern_generator(pattern));
	return s;
}

static double value_spiral1(const Pattern *pattern, const SurfacePoint *at)
{
	const SpiralData *data = pattern->data;
	Screw s = screw_at(pattern, at->p);
	return at->p.z + s.radius + data->arms * s.turn + s.turbulence;
}

static double value_spiral2(const Pattern *pattern, const SurfacePoint *at)
{
	const SpiralData *data = pattern->data;
	Screw s = screw_at(pattern, at->p);
	double screw = at->p.z + s.radius + data->arms * s.turn + s.turbulence;
	return pattern_triangle_wave(s.radius) + pattern_triangle_wave(screw);
}

/* The gouge between quilts: a cubic whose ends the two controls bend. */
static double quilt_slope(double t, double control0, double control1)
{
	double u = 1 - t;
	return 3 * t * u * u * control0 + 3 * t * t * u * control1 + t * t * t;
}

/* Where in its unit cube the point lies, from the middle, as a share of half the diagonal, scaled
 * by the gouge. */
static Vec3 quilt_vector(const Pattern *pattern, Vec3 p)
{
	const QuiltedData *data = pattern->data;
	Vec3 v = vec3(p.x - floor(p.x) - 0.5, p.y - floor(p.y) - 0.5, p.z - floor(p.z) - 0.5);
	const double half_diagonal = 1 / 1.154700538; /* POV-Ray's figure for sqrt(3) / 2 */
	double t = quilt_slope(vec3_length(v), data ? (float)data->control0 : 1,
	                       data ? (float)data->control1 : 1);
	return vec3_scale(v, t / half_diagonal);
}

static double value_quilted(const Pattern *pattern, const SurfacePoint *at)
{
	Vec3 v = quilt_vector(pattern, at->p);
	return (fabs(v.x) + fabs(v.y) + fabs(v.z)) / 3;
}

static void bump_quilted(const Pattern *pattern, const SurfacePoint *at, double amount,
                         Vec3 *normal)
{
	*normal = vec3_mad(*normal, amount, quilt_vector(pattern, at->p));
}

const PatternClass pattern_solid = {"solid", value_solid, 0, NULL, PATTERN_STILL};
const PatternClass pattern_gradient = {"gradient", value_gradient, 0, NULL, PATTERN_NEEDS_DATA};
const PatternClass pattern_planar = {"planar", value_planar, 0, NULL, 0};
const PatternClass pattern_spherical = {"spherical", value_spherical, 0, NULL, 0};
const PatternClass pattern_cylindrical = {"cylindrical", value_cylindrical, 0, NULL, 0};
const PatternClass pattern_boxed = {"boxed", value_boxed, 0, NULL, 0};
const PatternClass pattern_radial = {"radial", value_radial, 0, NULL, 0};
const PatternClass pattern_onion = {"onion", value_onion, 0, NULL, 0};
const PatternClass pattern_leopard = {"leopard", value_leopard, 0, NULL, 0};
const PatternClass pattern_spiral1 = {"spiral1", value_spiral1, 0, NULL,
                                      PATTERN_TRIANGLE | PATTERN_NEEDS_DATA};
const PatternClass pattern_spiral2 = {"spiral2", value_spiral2, 0, NULL,
                                      PATTERN_TRIANGLE | PATTERN_NEEDS_DATA};
const PatternClass pattern_quilted = {"quilted", value_quilted, 0, bump_quilted, 0};
