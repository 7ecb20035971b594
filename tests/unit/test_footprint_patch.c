/* What footprints are made of: the triangulation of emitter space, and patches of sheets. */
#include "density/footprint_patch.h"

#include <math.h>
#include <stdlib.h>

#include "base/random.h"
#include "density/footprint_delaunay.h"
#include "tests/unit/check.h"

/* ---- triangulation ---- */

enum { MOST = 400 };

static double cross(const double a[2], const double b[2], const double c[2])
{
	return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

static bool is_inside_circle(const double a[2], const double b[2], const double c[2],
                             const double p[2])
{
	const double *corners[3] = {a, b, c};
	double m[3][3], rounding = 1e-7;
	for (int i = 0; i < 3; i++) {
		m[i][0] = corners[i][0] - p[0];
		m[i][1] = corners[i][1] - p[1];
		m[i][2] = m[i][0] * m[i][0] + m[i][1] * m[i][1];
	}
	return m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]) -
		       m[1][2] * (m[0][0] * m[2][1] - m[0][1] * m[2][0]) +
		       m[2][2] * (m[0][0] * m[1][1] - m[0][1] * m[1][0]) >
	       rounding;
}

/* Triangles are anticlockwise, no circle holds a point, and areas add up. */
static void check_triangulation(const double (*points)[2], uint32_t count, double area)
{
	Triangulation t = footprint_triangulate(points, count);
	double sum = 0;
	for (uint32_t i = 0; i < t.count; i++) {
		const uint32_t *c = t.corners[i];
		CHECK(c[0] < count && c[1] < count && c[2] < count);
		double twice = cross(points[c[0]], points[c[1]], points[c[2]]);
		CHECK(twice > -1e-7);
		sum += 0.5 * twice;
		for (uint32_t p = 0; p < count; p++)
			CHECK(!is_inside_circle(points[c[0]], points[c[1]], points[c[2]],
						points[p]));
	}
	CHECK_NEAR(sum, area, 1e-6);
	free(t.corners);
}

static void test_triangulation(void)
{
	static double points[MOST][2];
	/* Corners of the unit square first, so that the hull is known. */
	for (uint32_t i = 0; i < MOST; i++)
		for (int k = 0; k < 2; k++)
			points[i][k] = i < 4 ? (k ? i / 2 : i % 2)
					     : random_uniform(3, i, (uint64_t)k);
	check_triangulation((const double (*)[2])points, MOST, 1);
	/* A lattice: four points on a circle everywhere, and each twice. */
	for (uint32_t i = 0; i < MOST; i++) {
		points[i][0] = i % 200 % 20 / 19.0;
		points[i][1] = i % 200 / 20 / 19.0;
	}
	check_triangulation((const double (*)[2])points, MOST, 9 / 19.0);
	/* On a line, and two points. */
	for (uint32_t i = 0; i < MOST; i++)
		points[i][0] = points[i][1] = i;
	check_triangulation((const double (*)[2])points, MOST, 0);
	check_triangulation((const double (*)[2])points, 2, 0);
}

/* ---- patches ---- */

/* A window of the plane y = 0. */
static Window window_at(double x, double z, double side)
{
	return (Window){
		{x, 0, z}, {1 / side, 0, 0}, {0, 0, 1 / side}, side * side, vec3_all(side / 2)};
}

static Patch make_patch(uint64_t seed, double bend)
{
	Patch patch = {.flux = {1, 1, 1}};
	for (int i = 0; i < 6; i++) {
		for (int k = 0; k < 3; k += 2) {
			double at = random_uniform(seed, (uint64_t)i, (uint64_t)k);
			int a = i - 3, b = (i - 2) % 3;
			patch.control[i][k] =
				i < 3 ? (float)at
				      : 0.5f * (patch.control[a][k] + patch.control[b][k]) +
						(float)(bend * (at - 0.5));
		}
	}
	return patch;
}

/* Where the point u, v, w (barycentric) of the emitter's triangle goes. */
static void patch_point(const Patch *patch, const double b[3], double at[2])
{
	for (int k = 0; k < 2; k++) {
		at[k] = 0;
		for (int i = 0; i < 3; i++) {
			int next = (i + 1) % 3;
			at[k] += b[i] * b[i] * patch->control[i][2 * k] +
				 2 * b[i] * b[next] * patch->control[3 + i][2 * k];
		}
	}
}

/* By counting points of the triangle; moved by up to half the sweep. */
static double counted_share(const Patch *patch, double x, double z, double side)
{
	enum { POINTS = 200000 };
	int inside = 0;
	for (uint64_t i = 1; i <= POINTS; i++) {
		double u = random_halton(i, 0), v = random_halton(i, 1),
		       t = random_halton(i, 2) - 0.5, at[2];
		if (u + v > 1) {
			u = 1 - u;
			v = 1 - v;
		}
		patch_point(patch, (double[3]){u, v, 1 - u - v}, at);
		inside += fabs(at[0] + t * patch->sweep[0] - x) < 0.5 * side &&
			  fabs(at[1] + t * patch->sweep[2] - z) < 0.5 * side;
	}
	return (double)inside / POINTS;
}

static void test_share(void)
{
	for (uint64_t seed = 0; seed < 12; seed++) {
		Patch patch = make_patch(seed, seed % 3 * 0.4);
		Window window = window_at(0.45, 0.5, 0.3);
		CHECK_NEAR(footprint_patch_share(&patch, &window),
			   counted_share(&patch, 0.45, 0.5, 0.3), 0.007);
	}
}

/* Windows side by side take all of the light, of folded patches as well. */
static void test_all(double sweep, double tolerance)
{
	for (uint64_t seed = 20; seed < 26; seed++) {
		Patch patch = make_patch(seed, 0.6);
		patch.sweep[0] = (float)sweep;
		patch.sweep[2] = (float)(0.5 * sweep);
		double sum = 0;
		for (double x = -0.975; x < 2; x += 0.05) {
			for (double z = -0.975; z < 2; z += 0.05) {
				Window window = window_at(x, z, 0.05);
				sum += footprint_patch_share(&patch, &window);
			}
		}
		CHECK_NEAR(sum, 1, tolerance);
	}
}

/* Sweeps are sampled in steps of a window. */
static void test_swept(void)
{
	for (uint64_t seed = 40; seed < 46; seed++) {
		Patch patch = make_patch(seed, 0.2);
		patch.sweep[0] = 0.3f;
		patch.sweep[2] = -0.2f;
		Window window = window_at(0.45, 0.5, 0.1);
		CHECK_NEAR(footprint_patch_share(&patch, &window),
			   counted_share(&patch, 0.45, 0.5, 0.1), 0.01);
	}
}

/* A part of a part is where it is said to be. */
static void test_cut(void)
{
	static const double corners[3][3] = {{0.5, 0.5, 0}, {0.2, 0.6, 0.2}, {1.2, -0.4, 0.2}};
	Patch patch = make_patch(60, 0.5), part;
	footprint_patch_cut(&patch, corners, &part);
	for (int i = 0; i < 20; i++) {
		double b[3] = {random_uniform(9, 0, (uint64_t)i),
		               random_uniform(9, 1, (uint64_t)i)};
		double of[3] = {0}, in_part[2], in_patch[2];
		b[2] = 1 - b[0] - b[1];
		for (int k = 0; k < 3; k++)
			for (int c = 0; c < 3; c++)
				of[c] += b[k] * corners[k][c];
		patch_point(&part, b, in_part);
		patch_point(&patch, of, in_patch);
		CHECK_NEAR(in_part[0], in_patch[0], 1e-5);
		CHECK_NEAR(in_part[1], in_patch[1], 1e-5);
	}
}

int main(void)
{
	test_triangulation();
	test_share();
	test_all(0, 1e-3);
	test_all(0.4, 0.05);
	test_swept();
	test_cut();
	return CHECK_RESULT();
}
