/*
 * Plans of pavements: a net of cells, repeated after so many columns, and after so many rows with a
 * shift to the right, each with those of its edges that part two tiles.
 *
 * Squares: cell i, j is the unit square with its least corner at x = i, z = j; 1 is its edge of
 * least x, 2 that of least z. Triangles: i, j stands for the corner at x = i + j / 2, z = j H, H
 * the height of a triangle with sides of 1; 1 is the edge from there along x, 2 the one that rises
 * 60 degrees from it, 4 the third one of the triangle that they make. Hexagons with sides of 1:
 * i, j is the one round x = 1 + 1.5 i, z = (i + 2 j) H; 1 is its edge of least z, 2 and 4 are the
 * ones to the left and right of that.
 */
#ifndef SURFACE_PAVEMENT_PLAN_H
#define SURFACE_PAVEMENT_PLAN_H

#include <stdint.h>

typedef struct PavementPlan {
	int columns, shift, rows;
	const char *borders; /* row by row, a digit a cell: the sum of its edges that are borders */
} PavementPlan;

/* How many plans there are for tiles of so many polygons of 3, 4 or 6 sides; 0: no such tiles. */
int pavement_plan_count(int sides, int tiles);
/* pattern from 1; NULL when there is none. */
const PavementPlan *pavement_plan_find(int sides, int tiles, int pattern);
/* The borders of cell i, j. */
unsigned pavement_plan_borders(const PavementPlan *plan, int64_t i, int64_t j);

#endif
