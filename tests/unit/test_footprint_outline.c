/* Outlines of jagged ways along known polygons. */
#include "density/footprint_outline.h"

#include <math.h>
#include <stdint.h>

#include "base/random.h"
#include "tests/unit/check.h"

enum { CORNERS = 5, A_SIDE = 25, COUNT = CORNERS * A_SIDE };

/* One corner is a hollow. Sides of 25 to 40. */
static const double corners[CORNERS][2] = {{0, 0}, {40, 5}, {20, 20}, {30, 45}, {-5, 35}};

static double length_of(int side)
{
	const double *a = corners[side], *b = corners[(side + 1) % CORNERS];
	return hypot(b[0] - a[0], b[1] - a[1]);
}

/* How far a place is inside a side's line. */
static double depth_of(int side, const double at[2])
{
	const double *a = corners[side], *b = corners[(side + 1) % CORNERS];
	return ((b[0] - a[0]) * (at[1] - a[1]) - (b[1] - a[1]) * (at[0] - a[0])) / length_of(side);
}

/* Points within 0 to 1 of the sides, one for each piece of them. */
static void make_nodes(OutlineNode *nodes)
{
	for (int i = 0; i < COUNT; i++) {
		int side = i / A_SIDE;
		const double *a = corners[side], *b = corners[(side + 1) % CORNERS];
		double along = (i % A_SIDE + 0.5) / A_SIDE;
		double depth = random_uniform(5, (uint64_t)i, 0);
		for (int k = 0; k < 2; k++)
			nodes[i].at[k] = a[k] + along * (b[k] - a[k]);
		nodes[i].at[0] -= depth * (b[1] - a[1]) / length_of(side);
		nodes[i].at[1] += depth * (b[0] - a[0]) / length_of(side);
		nodes[i].space = 1;
		nodes[i].missing = depth * length_of(side) / A_SIDE;
	}
}

/* Sides are found to a small part of what points are apart, and corners where they meet. */
static void test_polygon(void)
{
	OutlineNode nodes[COUNT];
	double out[COUNT][2], squares = 0;
	make_nodes(nodes);
	footprint_outline(nodes, COUNT, out);
	for (int side = 0; side < CORNERS; side++) {
		double nearest = INFINITY;
		for (int i = 1; i < A_SIDE - 1; i++)
			squares += pow(depth_of(side, out[side * A_SIDE + i]), 2);
		for (int i = 0; i < COUNT; i++)
			nearest = fmin(nearest, hypot(out[i][0] - corners[side][0],
						      out[i][1] - corners[side][1]));
		CHECK(nearest < 0.6);
	}
	CHECK(sqrt(squares / (CORNERS * (A_SIDE - 2))) < 0.15); /* the nodes' own: 0.58 */
}

/* Also of a ring of points: as a polygon that is near. */
static void test_round(void)
{
	static const double radius = 20;
	OutlineNode nodes[COUNT];
	double out[COUNT][2], squares = 0;
	for (int i = 0; i < COUNT; i++) {
		double angle = 2 * M_PI * i / COUNT, depth = random_uniform(6, (uint64_t)i, 0);
		nodes[i] = (OutlineNode){{(radius - depth) * cos(angle),
					  (radius - depth) * sin(angle)},
		                         1, depth * 2 * M_PI * radius / COUNT};
	}
	footprint_outline(nodes, COUNT, out);
	for (int i = 0; i < COUNT; i++)
		squares += pow(hypot(out[i][0], out[i][1]) - radius, 2);
	CHECK(sqrt(squares / COUNT) < 0.25);
}

/* Three points are a triangle with room around. */
static void test_least(void)
{
	const OutlineNode nodes[3] = {{{0, 0}, 1, 0.8}, {{1, 0}, 1, 0.8}, {{0.5, 1}, 1, 0.8}};
	double out[3][2];
	footprint_outline(nodes, 3, out);
	CHECK(out[0][0] < 0 && out[0][1] < 0 && out[1][0] > 1 && out[1][1] < 0 && out[2][1] > 1);
}

int main(void)
{
	test_polygon();
	test_round();
	test_least();
	return CHECK_RESULT();
}
