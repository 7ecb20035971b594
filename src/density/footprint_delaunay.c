/*
 * Points are put in one after another; each is looked for by a walk from the last one's triangle,
 * splits the triangle it falls into, and edges are flipped until circumcircles are empty again
 * (Lawson 1977). All lies in one triangle far larger than the points' square. Whether a point is in
 * a circumcircle is settled in whole numbers where double precision leaves it open.
 */
#include "density/footprint_delaunay.h"

#include <math.h>
#include <stdbool.h>
#include <stdlib.h>

#include "base/arena.h"

enum { NONE = -1 };
/* Grid of the points, and how far out the corners of the triangle around them are. */
static const double grid = 1 << 22;
static const int64_t far_out = 1 << 28;

typedef struct Place { int64_t x, y; } Place;

/* beside[i] is the triangle across from corner i. */
typedef struct Cell {
	uint32_t corner[3];
	int32_t beside[3];
} Cell;

typedef struct Mesh {
	Place *places;
	Cell *cells;
	int32_t count;
	int32_t last;      /* where the next walk starts */
	int32_t *doubtful; /* cells whose edge across from corner 0 is to be looked at */
	int32_t doubts, room;
} Mesh;

/* ---- predicates ---- */

/* Over 0: c is left of the way from a to b. */
static int64_t turn(Place a, Place b, Place c)
{
	return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

__extension__ typedef __int128 Wide;

static bool in_circle_exactly(Place a, Place b, Place c)
{
	Wide la = (Wide)(a.x * a.x + a.y * a.y), lb = (Wide)(b.x * b.x + b.y * b.y),
	     lc = (Wide)(c.x * c.x + c.y * c.y);
	Wide sum = la * (b.x * c.y - b.y * c.x) + lb * (c.x * a.y - c.y * a.x) +
		   lc * (a.x * b.y - a.y * b.x);
	return sum > 0;
}

/* Whether d is inside the circle through a, b and c, anticlockwise. */
static bool in_circle(Place a, Place b, Place c, Place d)
{
	static const double rounding = 4e-15; /* of the sum of the terms' sizes */
	a = (Place){a.x - d.x, a.y - d.y};
	b = (Place){b.x - d.x, b.y - d.y};
	c = (Place){c.x - d.x, c.y - d.y};
	double ax = (double)a.x, ay = (double)a.y, bx = (double)b.x, by = (double)b.y,
	       cx = (double)c.x, cy = (double)c.y;
	double la = ax * ax + ay * ay, lb = bx * bx + by * by, lc = cx * cx + cy * cy;
	double sum = la * (bx * cy - by * cx) + lb * (cx * ay - cy * ax) + lc * (ax * by - ay * bx);
	double size = la * (fabs(bx * cy) + fabs(by * cx)) + lb * (fabs(cx * ay) + fabs(cy * ax)) +
		      lc * (fabs(ax * by) + fabs(ay * bx));
	return fabs(sum) > rounding * size ? sum > 0 : in_circle_exactly(a, b, c);
}

/* ---- changes ---- */

static void put_beside(Mesh *mesh, int32_t cell, int32_t old, int32_t new)
{
	if (cell == NONE)
		return;
	int32_t *beside = mesh->cells[cell].beside;
	beside[beside[0] == old ? 0 : beside[1] == old ? 1 : 2] = new;
}

static void doubt(Mesh *mesh, int32_t cell)
{
	if (mesh->doubts == mesh->room) {
		mesh->room *= 2;
		mesh->doubtful = memory_resize(mesh->doubtful,
					       sizeof *mesh->doubtful * (size_t)mesh->room);
	}
	mesh->doubtful[mesh->doubts++] = cell;
}

/* A cell becomes three around point p, which is corner 0 of each. */
static void split(Mesh *mesh, int32_t cell, uint32_t p)
{
	Cell old = mesh->cells[cell];
	const int32_t all[3] = {cell, mesh->count, mesh->count + 1};
	mesh->count += 2;
	for (int i = 0; i < 3; i++) {
		int next = (i + 1) % 3, last = (i + 2) % 3;
		mesh->cells[all[i]] = (Cell){{p, old.corner[next], old.corner[last]},
		                             {old.beside[i], all[next], all[last]}};
		put_beside(mesh, old.beside[i], cell, all[i]);
		doubt(mesh, all[i]);
	}
	mesh->last = cell;
}

/* Of a cell p b c and the one beyond b c, whose corner `away` is d, makes p b d and p d c. */
static void flip(Mesh *mesh, int32_t cell, int32_t beyond, int away)
{
	Cell one = mesh->cells[cell], two = mesh->cells[beyond];
	uint32_t p = one.corner[0], b = one.corner[1], c = one.corner[2], d = two.corner[away];
	int32_t past_b = two.beside[(away + 1) % 3], past_c = two.beside[(away + 2) % 3];
	mesh->cells[cell] = (Cell){{p, b, d}, {past_b, beyond, one.beside[2]}};
	mesh->cells[beyond] = (Cell){{p, d, c}, {past_c, one.beside[1], cell}};
	put_beside(mesh, past_b, beyond, cell);
	put_beside(mesh, one.beside[1], cell, beyond);
	doubt(mesh, cell);
	doubt(mesh, beyond);
}

/* Flips until no circle around a cell holds a corner of the cell beyond. */
static void mend(Mesh *mesh)
{
	while (mesh->doubts > 0) {
		int32_t number = mesh->doubtful[--mesh->doubts];
		const Cell *cell = &mesh->cells[number];
		int32_t beyond = cell->beside[0];
		if (beyond == NONE)
			continue;
		const Cell *other = &mesh->cells[beyond];
		int away = other->beside[0] == number ? 0 : other->beside[1] == number ? 1 : 2;
		const Place *at = mesh->places;
		if (in_circle(at[cell->corner[0]], at[cell->corner[1]], at[cell->corner[2]],
			      at[other->corner[away]]))
			flip(mesh, number, beyond, away);
	}
}

/* ---- points ---- */

/* The cell that a place is in or on the edge of. */
static int32_t walk(const Mesh *mesh, Place to)
{
	int32_t at = mesh->last;
	for (;;) {
		const Cell *cell = &mesh->cells[at];
		int32_t next = NONE;
		for (int i = 0; i < 3 && next == NONE; i++) {
			Place a = mesh->places[cell->corner[(i + 1) % 3]];
			Place b = mesh->places[cell->corner[(i + 2) % 3]];
			if (turn(a, b, to) < 0)
				next = cell->beside[i];
		}
		if (next == NONE)
			return at;
		at = next;
	}
}

static bool is_corner(const Mesh *mesh, int32_t cell, Place place)
{
	for (int i = 0; i < 3; i++) {
		Place corner = mesh->places[mesh->cells[cell].corner[i]];
		if (corner.x == place.x && corner.y == place.y)
			return true;
	}
	return false;
}

static void insert(Mesh *mesh, uint32_t point)
{
	Place place = mesh->places[point];
	int32_t cell = walk(mesh, place);
	if (is_corner(mesh, cell, place))
		return;
	split(mesh, cell, point);
	mend(mesh);
}

/* The points on the grid, and the three corners around all. */
static Place *make_places(const double (*points)[2], uint32_t count)
{
	Place *places = memory_alloc(sizeof *places * ((size_t)count + 3));
	double lo[2] = {INFINITY, INFINITY}, hi[2] = {-INFINITY, -INFINITY};
	for (uint32_t i = 0; i < count; i++) {
		for (int k = 0; k < 2; k++) {
			lo[k] = fmin(lo[k], points[i][k]);
			hi[k] = fmax(hi[k], points[i][k]);
		}
	}
	double side = fmax(hi[0] - lo[0], hi[1] - lo[1]), scale = side > 0 ? grid / side : 0;
	for (uint32_t i = 0; i < count; i++)
		places[i] = (Place){(int64_t)((points[i][0] - lo[0]) * scale),
		                    (int64_t)((points[i][1] - lo[1]) * scale)};
	places[count] = (Place){-far_out, -far_out};
	places[count + 1] = (Place){2 * far_out, -far_out};
	places[count + 2] = (Place){-far_out, 2 * far_out};
	return places;
}

static Triangulation take_result(const Mesh *mesh, uint32_t count)
{
	Triangulation result = {memory_alloc(sizeof *result.corners * (size_t)mesh->count), 0};
	for (int32_t i = 0; i < mesh->count; i++) {
		const uint32_t *c = mesh->cells[i].corner;
		const Place *at = mesh->places;
		if (c[0] < count && c[1] < count && c[2] < count &&
		    turn(at[c[0]], at[c[1]], at[c[2]]) > 0) {
			for (int k = 0; k < 3; k++)
				result.corners[result.count][k] = c[k];
			result.count++;
		}
	}
	return result;
}

Triangulation footprint_triangulate(const double (*points)[2], uint32_t count)
{
	if (count < 3)
		return (Triangulation){NULL, 0};
	Mesh mesh = {.places = make_places(points, count), .count = 1, .room = 64};
	mesh.cells = memory_alloc_wide(sizeof *mesh.cells * (2 * (size_t)count + 1));
	mesh.cells[0] = (Cell){{count, count + 1, count + 2}, {NONE, NONE, NONE}};
	mesh.doubtful = memory_alloc(sizeof *mesh.doubtful * (size_t)mesh.room);
	for (uint32_t i = 0; i < count; i++)
		insert(&mesh, i);
	Triangulation result = take_result(&mesh, count);
	free(mesh.doubtful);
	free(mesh.cells);
	free(mesh.places);
	return result;
}
