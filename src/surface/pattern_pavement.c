/*
 * The pattern `pavement`: tiles made of a few triangles, squares or hexagons fill the x-z plane,
 * with bevelled edges. Plans of the tiles are in pavement_plan.c; the bevel's shapes were measured
 * from POV-Ray's pictures.
 *
 * The value is 1 on a tile's border and falls to 0 at the distance of a triangle's inner circle, or
 * of a square's, inside. A cell, one of the polygons, sees its own edges that are borders, and
 * corners: inner ones, where the tile bends round a corner of the cell (interior), and outer ones,
 * a tile's pointed ends (exterior) and its turns (form). Style 0 of a corner is as the edges make
 * it, 1 breaks it in two, 2 rounds it.
 */
#include <math.h>

#include "surface/pattern_classes.h"
#include "surface/pattern_data.h"
#include "surface/pavement_plan.h"

/* The height of a triangle with sides of 1, the radius of a hexagon's inner circle. */
static const double pavement_height = 0.86602540378443864676;

enum { PAVEMENT_CORNERS = 6 };

/* The edges at a corner that are borders: a bit each, counter-clockwise from the cell's own two. */
enum { OWN_FIRST = 1, OWN_LAST = 2, OWN_BOTH = 3, SECOND = 4, SIXTH = 32 };

typedef struct PavementCell {
	int sides;
	double width;                   /* of the bevel */
	Vec2 at;                        /* the point, from the cell's centre; v is z */
	Vec2 corner[PAVEMENT_CORNERS];  /* from the centre, counter-clockwise */
	unsigned rays[PAVEMENT_CORNERS]; /* borders at the corner; OWN_FIRST is the edge to the next
					    corner */
} PavementCell;

static double dot(Vec2 a, Vec2 b) { return a.u * b.u + a.v * b.v; }
static Vec2 from_to(Vec2 a, Vec2 b) { return (Vec2){b.u - a.u, b.v - a.v}; }
static double length(Vec2 a) { return sqrt(dot(a, a)); }

/* ---- the cell that holds a point ---- */

/* Bit by bit from the edge numbered first. */
static unsigned turn_rays(unsigned rays, int first, int count)
{
	return (rays >> first | rays << (count - first)) & ((1u << count) - 1);
}

/* The edges at the corner of squares i, j that are borders, from the one along x. */
static unsigned square_rays(const PavementPlan *plan, int64_t i, int64_t j)
{
	unsigned here = pavement_plan_borders(plan, i, j),
		 left = pavement_plan_borders(plan, i - 1, j),
		 below = pavement_plan_borders(plan, i, j - 1);
	return here >> 1 | (here & 1) << 1 | (left & 2) << 1 | (below & 1) << 3;
}

static PavementCell square_cell(const PavementPlan *plan, double x, double z)
{
	static const int di[] = {0, 1, 1, 0}, dj[] = {0, 0, 1, 1};
	int64_t i = (int64_t)floor(x), j = (int64_t)floor(z);
	PavementCell cell = {.sides = 4, .width = 0.5, .at = {x - i - 0.5, z - j - 0.5}};
	for (int k = 0; k < 4; k++) {
		cell.corner[k] = (Vec2){di[k] - 0.5, dj[k] - 0.5};
		cell.rays[k] = turn_rays(square_rays(plan, i + di[k], j + dj[k]), k, 4);
	}
	return cell;
}

/* The same for triangles. */
static unsigned triangle_rays(const PavementPlan *plan, int64_t i, int64_t j)
{
	unsigned here = pavement_plan_borders(plan, i, j),
		 left = pavement_plan_borders(plan, i - 1, j),
		 below = pavement_plan_borders(plan, i, j - 1);
	return (here & 3) | (left & 4) | (left & 1) << 3 | (below & 2) << 3 | (below & 4) << 3;
}

static PavementCell triangle_cell(const PavementPlan *plan, double x, double z)
{
	/* Upright, then upside down: the corners of the rhomb of both, and the number of the
	 * triangle's first edge at each. */
	static const int di[2][3] = {{0, 1, 0}, {1, 1, 0}}, dj[2][3] = {{0, 0, 1}, {0, 1, 1}},
			 first[2][3] = {{0, 2, 4}, {1, 3, 5}};
	double row = z / pavement_height, column = x - row / 2;
	int64_t i = (int64_t)floor(column), j = (int64_t)floor(row);
	int down = column - i + row - j >= 1;
	Vec2 center = {i + j * 0.5 + (down ? 1 : 0.5),
		       (j + (down ? 2.0 : 1.0) / 3) * pavement_height};
	PavementCell cell = {.sides = 3, .width = pavement_height / 3};
	cell.at = from_to(center, (Vec2){x, z});
	for (int k = 0; k < 3; k++) {
		int64_t ci = i + di[down][k], cj = j + dj[down][k];
		cell.corner[k] = from_to(center, (Vec2){ci + cj * 0.5, cj * pavement_height});
		cell.rays[k] = turn_rays(triangle_rays(plan, ci, cj), first[down][k], 6);
	}
	return cell;
}

static Vec2 hexagon_center(int64_t i, int64_t j)
{
	return (Vec2){1 + 1.5 * i, (i + 2 * j) * pavement_height};
}

/* The nearest centre's i and j. */
static void find_hexagon(Vec2 p, int64_t *i, int64_t *j)
{
	int64_t middle = (int64_t)rint((p.u - 1) / 1.5);
	double least = HUGE_VAL;
	for (int64_t column = middle - 1; column <= middle + 1; column++) {
		int64_t row = (int64_t)rint((p.v / pavement_height - column) / 2);
		double distance = length(from_to(hexagon_center(column, row), p));
		if (distance < least) {
			least = distance;
			*i = column;
			*j = row;
		}
	}
}

static PavementCell hexagon_cell(const PavementPlan *plan, double x, double z)
{
	/* Where edge k, from corner k to the next, and the third edge at corner k are kept. */
	static const struct {
		int di, dj;
		unsigned bit;
	} own[] = {{1, 0, 2}, {0, 1, 1}, {-1, 1, 4}, {0, 0, 2}, {0, 0, 1}, {0, 0, 4}},
	  third[] = {{1, 0, 1}, {0, 1, 4}, {0, 1, 2}, {-1, 1, 1}, {-1, 0, 4}, {1, -1, 2}};
	static const double corner_x[] = {1, 0.5, -0.5, -1, -0.5, 0.5},
			    corner_z[] = {0, 1, 1, 0, -1, -1};
	int64_t i = 0, j = 0;
	find_hexagon((Vec2){x, z}, &i, &j);
	PavementCell cell = {.sides = 6, .width = pavement_height / 3};
	cell.at = from_to(hexagon_center(i, j), (Vec2){x, z});
	for (int k = 0; k < 6; k++) {
		cell.corner[k] = (Vec2){corner_x[k], corner_z[k] * pavement_height};
		if (pavement_plan_borders(plan, i + own[k].di, j + own[k].dj) & own[k].bit) {
			cell.rays[k] |= OWN_FIRST;
			cell.rays[(k + 1) % 6] |= OWN_LAST;
		}
		if (pavement_plan_borders(plan, i + third[k].di, j + third[k].dj) & third[k].bit)
			cell.rays[k] |= SECOND;
	}
	return cell;
}

/* ---- the bevel ---- */

static int next(const PavementCell *cell, int k) { return (k + 1) % cell->sides; }

static double edge_value(const PavementCell *cell, int k)
{
	Vec2 edge = from_to(cell->corner[k], cell->corner[next(cell, k)]),
	     to_point = from_to(cell->corner[k], cell->at);
	return 1 - (edge.u * to_point.v - edge.v * to_point.u) / cell->width;
}

/* Some border ends here, but none of the cell's own. */
static bool only_touched(unsigned rays) { return rays && !(rays & OWN_BOTH); }

/* In a square where the tile turns round a corner, form shapes that corner, but for form 3. */
static int inner_style(const PavementCell *cell, int k, const PavementData *data)
{
	bool turns = cell->sides == 4 && (cell->rays[(k + 2) % 4] & OWN_BOTH) == OWN_BOTH;
	return turns && data->form != 3 ? data->form : data->interior;
}

static double inner_square(Vec2 r, int style)
{
	if (style == 2)
		return 1 - 2 * length(r);
	return 1 - 2 * (style == 1 ? fabs(r.u) + fabs(r.v) : fmax(fabs(r.u), fabs(r.v)));
}

/* The value at a corner round which the tile bends, of a cell of three or six sides. */
static double inner_polygon(const PavementCell *cell, int k, Vec2 r, int style)
{
	int before = (k + cell->sides - 1) % cell->sides;
	Vec2 corner = cell->corner[k], inwards = {-corner.u, -corner.v};
	double middle = dot(r, inwards) / length(inwards);
	double along = fmax(dot(r, from_to(corner, cell->corner[next(cell, k)])),
			    dot(r, from_to(corner, cell->corner[before])));
	if (style == 2)
		return 1 - 3 * length(r);
	if (cell->sides == 6)
		return style == 1 ? 1 - 3 * fmax(along, middle) : 0;
	return style == 1 ? 1 - 3 * along : 1 - middle / cell->width;
}

static double inner_value(const PavementCell *cell, int k, const PavementData *data)
{
	unsigned rays = cell->rays[k], mine = rays & OWN_BOTH;
	Vec2 r = from_to(cell->corner[k], cell->at);
	if (cell->sides == 6)
		return mine == OWN_FIRST || mine == OWN_LAST
			       ? inner_polygon(cell, k, r, data->interior)
			       : 0;
	if (!only_touched(rays))
		return 0;
	return cell->sides == 4 ? inner_square(r, inner_style(cell, k, data))
				: inner_polygon(cell, k, r, data->interior);
}

/* A turn of the tile about a point, whose outer corner is at the distance of 1 from it. */
static double turn_value(Vec2 at, Vec2 about, Vec2 corner, int style)
{
	Vec2 r = from_to(about, at);
	if (style == 2)
		return 1 - (pavement_height - length(r)) * 3 / pavement_height;
	return style == 1 ? 4 * dot(r, from_to(about, corner)) - 2 : 0;
}

/* The same in a square, about the opposite corner. */
static double turn_square(const PavementCell *cell, int k, int style)
{
	Vec2 about = cell->corner[(k + 2) % 4], r = from_to(about, cell->at);
	if (style == 2)
		return 2 * length(r) - 1;
	return style == 1 ? 2 * dot(r, from_to(about, cell->corner[k])) - 1 : 0;
}

static double tip_value(const PavementCell *cell, int k, int style)
{
	if (style == 2)
		return length(cell->at) / cell->width;
	double along = dot(cell->at, cell->corner[k]) / length(cell->corner[k]);
	return style == 1 ? along / cell->width * (cell->sides == 4 ? sqrt(2) : 1) : 0;
}

static double outer_triangle(const PavementCell *cell, int k, const PavementData *data)
{
	unsigned rays = cell->rays[k], mine = rays & OWN_BOTH;
	Vec2 corner = cell->corner[k];
	if (mine == OWN_BOTH)
		return tip_value(cell, k, data->exterior);
	if (mine == OWN_FIRST && rays & SECOND)
		return turn_value(cell->at, cell->corner[(k + 2) % 3], corner, data->form);
	if (mine == OWN_LAST && rays & SIXTH)
		return turn_value(cell->at, cell->corner[(k + 1) % 3], corner, data->form);
	return 0;
}

/* The corner of a square at which the tile turns round the opposite one, or -1. */
static int turning_corner(const PavementCell *cell)
{
	for (int k = 0; k < 4; k++)
		if ((cell->rays[k] & OWN_BOTH) == OWN_BOTH && only_touched(cell->rays[(k + 2) % 4]))
			return k;
	return -1;
}

/* A turn fills the whole square. */
static double outer_square(const PavementCell *cell, int k, const PavementData *data)
{
	int turning = turning_corner(cell);
	if (turning >= 0 && data->form != 3)
		return turn_square(cell, turning, data->form);
	return (cell->rays[k] & OWN_BOTH) == OWN_BOTH ? tip_value(cell, k, data->exterior) : 0;
}

/* What the corner that is nearest to the point adds. */
static double outer_value(const PavementCell *cell, int k, const PavementData *data)
{
	if (cell->sides == 3)
		return outer_triangle(cell, k, data);
	if (cell->sides == 4)
		return outer_square(cell, k, data);
	if ((cell->rays[k] & OWN_BOTH) != OWN_BOTH)
		return 0;
	return turn_value(cell->at, (Vec2){0, 0}, cell->corner[k], data->form);
}

static int nearest_corner(const PavementCell *cell)
{
	int nearest = 0;
	for (int k = 1; k < cell->sides; k++)
		if (dot(cell->at, cell->corner[k]) > dot(cell->at, cell->corner[nearest]))
			nearest = k;
	return nearest;
}

static double value_pavement(const Pattern *pattern, const SurfacePoint *at)
{
	const PavementData *data = pattern->data;
	double x = at->p.x, z = at->p.z;
	if (!(fabs(x) < 1e15 && fabs(z) < 1e15))
		return 0;
	PavementCell cell = data->sides == 3   ? triangle_cell(data->plan, x, z)
			    : data->sides == 4 ? square_cell(data->plan, x, z)
					       : hexagon_cell(data->plan, x, z);
	double value = outer_value(&cell, nearest_corner(&cell), data);
	for (int k = 0; k < cell.sides; k++) {
		value = fmax(value, inner_value(&cell, k, data));
		if (cell.rays[k] & OWN_FIRST)
			value = fmax(value, edge_value(&cell, k));
	}
	return fmin(fmax(value, 0), 1);
}

const PatternClass pattern_pavement = {"pavement", value_pavement, 0, NULL, PATTERN_NEEDS_DATA};
