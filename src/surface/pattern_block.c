/* Patterns of blocks: each point belongs to one of a few entries. Borders as measured through
 * function { pattern { } }. */
#include <math.h>

#include "surface/pattern_classes.h"
#include "surface/pattern_data.h"

/* POV-Ray's coordinate tolerance: faces of unit boxes at whole numbers do not flicker. */
static const double block_epsilon = 1e-10;

static double value_checker(const Pattern *pattern, const SurfacePoint *at)
{
	(void)pattern;
	double sum = floor(at->p.x + block_epsilon) + floor(at->p.y + block_epsilon) +
	             floor(at->p.z + block_epsilon);
	return fmod(sum, 2) != 0;
}

static double fraction(double v) { return v - floor(v); }

/* Courses along y; every other one is shifted by half a brick. Mortar, 0, ends a brick on each
 * axis. */
static double value_brick(const Pattern *pattern, const SurfacePoint *at)
{
	static const BrickData usual = {{8, 3, 4.5}, 0.5};
	const BrickData *brick = pattern->data ? pattern->data : &usual;
	double course = at->p.y / brick->size.y;
	if (fraction(course) >= 1 - brick->mortar / brick->size.y)
		return 0;
	bool odd = fmod(floor(course), 2) != 0;
	double x = at->p.x / brick->size.x, z = at->p.z / brick->size.z;
	if (fraction(odd ? x + 0.5 : x) >= 1 - brick->mortar / brick->size.x)
		return 0;
	return fraction(odd ? z : z + 0.5) >= 1 - brick->mortar / brick->size.z ? 0 : 1;
}

static double value_cubic(const Pattern *pattern, const SurfacePoint *at)
{
	(void)pattern;
	double ax = fabs(at->p.x), ay = fabs(at->p.y), az = fabs(at->p.z);
	if (ax > ay && ax > az)
		return at->p.x > 0 ? 0 : 3;
	if (ay > az)
		return at->p.y > 0 ? 1 : 4;
	return at->p.z > 0 ? 2 : 5;
}

/* Round the four squares that share a corner. */
static double value_square(const Pattern *pattern, const SurfacePoint *at)
{
	(void)pattern;
	bool x = fmod(floor(at->p.x), 2) != 0, z = fmod(floor(at->p.z), 2) != 0;
	return z ? (x ? 2 : 1) : (x ? 3 : 0);
}

/*
 * Hexagons with sides of one, a corner on each side of the x axis. Cube coordinates find the
 * hexagon: q counts columns along x, r rows along z; the colours go round with r + 2 q.
 */
static double value_hexagon(const Pattern *pattern, const SurfacePoint *at)
{
	(void)pattern;
	double q = at->p.x / 1.5, r = at->p.z / sqrt(3) - q / 2, s = -q - r;
	double nq = round(q), nr = round(r), ns = round(s);
	double dq = fabs(nq - q), dr = fabs(nr - r), ds = fabs(ns - s);
	if (dq > dr && dq > ds)
		nq = -nr - ns;
	else if (dr > ds)
		nr = -nq - ns;
	double entry = fmod(nr + 2 * nq, 3);
	return entry < 0 ? entry + 3 : entry;
}

/*
 * Triangles with sides of one and a side on the x axis, in rows along x. Every third triangle that
 * points up has the same colour, likewise the ones between them; each row is shifted by half of
 * that period.
 */
static double value_triangular(const Pattern *pattern, const SurfacePoint *at)
{
	static const int upward[3] = {0, 4, 2}, downward[3] = {3, 5, 1};
	(void)pattern;
	double z = at->p.z / (sqrt(3) / 2), row = floor(z), height = z - row;
	double x = at->p.x - height / 2 - (fmod(row, 2) != 0 ? 1.5 : 0);
	x -= floor(x / 3) * 3;
	int i = (int)x % 3;
	return x - floor(x) < 1 - height ? upward[i] : downward[i];
}

static double value_object(const Pattern *pattern, const SurfacePoint *at)
{
	const ObjectData *object = pattern->data;
	return object->inside(object->shape, at->p) ? 1 : 0;
}

const PatternClass pattern_checker = {"checker", value_checker, 2, NULL, 0};
const PatternClass pattern_brick = {"brick", value_brick, 2, NULL, 0};
const PatternClass pattern_hexagon = {"hexagon", value_hexagon, 3, NULL, 0};
const PatternClass pattern_cubic = {"cubic", value_cubic, 6, NULL, 0};
const PatternClass pattern_square = {"square", value_square, 4, NULL, 0};
const PatternClass pattern_triangular = {"triangular", value_triangular, 6, NULL, 0};
const PatternClass pattern_object = {"object", value_object, 2, NULL, PATTERN_NEEDS_DATA};
