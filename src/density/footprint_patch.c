/*
 * The share of a patch in the window: as its control points tell where it can be, it is outside,
 * inside, or flat enough to be clipped as a triangle, or is cut into four.
 */
#include "density/footprint_patch.h"

#include <math.h>
#include <stdbool.h>

#include "density/gather.h"

/* ---- Bézier's triangles ---- */

/* Number of the control point of corners i and j. */
static const int number_of[3][3] = {{0, 3, 5}, {3, 1, 4}, {5, 4, 2}};

/* The blossom: a quadratic is bilinear in two points' barycentric coordinates. */
static void blossom(const Patch *patch, const double u[3], const double v[3], double out[3])
{
	out[0] = out[1] = out[2] = 0;
	for (int i = 0; i < 3; i++)
		for (int j = 0; j < 3; j++)
			for (int k = 0; k < 3; k++)
				out[k] += u[i] * v[j] * patch->control[number_of[i][j]][k];
}

void footprint_patch_cut(const Patch *patch, const double corners[3][3], Patch *out)
{
	Patch result = *patch;
	for (int i = 0; i < 3; i++) {
		for (int j = i; j < 3; j++) {
			double at[3];
			blossom(patch, corners[i], corners[j], at);
			for (int k = 0; k < 3; k++)
				result.control[number_of[i][j]][k] = (float)at[k];
		}
	}
	*out = result;
}

double footprint_patch_extent(const Patch *patch)
{
	double most = 0;
	for (int i = 0; i < 3; i++) {
		const float *a = patch->control[i], *b = patch->control[(i + 1) % 3];
		double x = a[0] - b[0], y = a[1] - b[1], z = a[2] - b[2];
		most = fmax(most, x * x + y * y + z * z);
	}
	return sqrt(most);
}

Vec3 footprint_depth(double size, Vec3 normal)
{
	double depth = gather_thickness(size);
	return vec3(depth * fabs(normal.x), depth * fabs(normal.y), depth * fabs(normal.z));
}

Box3 footprint_patch_box(const Patch *patch, Vec3 normal)
{
	Box3 box = box3_empty();
	for (int i = 0; i < 6; i++) {
		Vec3 at = vec3_of_floats(patch->control[i]);
		box = box3_union(box, (Box3){at, at});
	}
	Vec3 s = vec3(0.5 * fabs(patch->sweep[0]), 0.5 * fabs(patch->sweep[1]),
		      0.5 * fabs(patch->sweep[2]));
	Vec3 more = vec3_add(s, footprint_depth(footprint_patch_extent(patch), normal));
	return (Box3){vec3_sub(box.lo, more), vec3_add(box.hi, more)};
}

/* ---- coverage ---- */

/* A patch in the window's coordinates, in which that is the unit square around the origin. */
typedef struct Piece { double x[6], y[6]; } Piece;

static double least_of(const double v[6])
{
	return real_min(real_min(real_min(v[0], v[1]), real_min(v[2], v[3])), real_min(v[4], v[5]));
}

static double most_of(const double v[6])
{
	return real_max(real_max(real_max(v[0], v[1]), real_max(v[2], v[3])), real_max(v[4], v[5]));
}

typedef enum Side { OUTSIDE, INSIDE, ACROSS } Side;

static Side axis_side(const double v[6])
{
	double lo = least_of(v), hi = most_of(v);
	if (lo >= 0.5 || hi <= -0.5)
		return OUTSIDE;
	return lo >= -0.5 && hi <= 0.5 ? INSIDE : ACROSS;
}

static Side piece_side(const Piece *p)
{
	Side x = axis_side(p->x);
	if (x == OUTSIDE)
		return OUTSIDE;
	Side y = axis_side(p->y);
	return y == OUTSIDE ? OUTSIDE : x == INSIDE && y == INSIDE ? INSIDE : ACROSS;
}

static double clamp_half(double x) { return real_max(-0.5, real_min(0.5, x)); }

/* Integral of clamp_half. */
static double clamped_integral(double x)
{
	double c = clamp_half(x);
	return 0.5 * c * c + (x - c) * c;
}

/* What the edge from a to b adds to the area of a polygon's part in the unit square: integral of
 * the clamped x over the y that it passes within the square. */
static double edge_area(double ax, double ay, double bx, double by)
{
	double from = clamp_half(ay), to = clamp_half(by), height = to - from;
	if (height == 0)
		return 0;
	double slope = (bx - ax) / (by - ay);
	double x0 = ax + slope * (from - ay), x1 = ax + slope * (to - ay), width = x1 - x0;
	if (fabs(width) < 1e-6)
		return height * clamp_half(0.5 * (x0 + x1));
	return height * (clamped_integral(x1) - clamped_integral(x0)) / width;
}

/* Of a flat triangle, the share of its area in the square. Too thin a one counts by its middle. */
static double triangle_share(const double x[3], const double y[3])
{
	double area = 0.5 * ((x[1] - x[0]) * (y[2] - y[0]) - (x[2] - x[0]) * (y[1] - y[0]));
	if (fabs(area) < 1e-9) {
		double mx = (x[0] + x[1] + x[2]) / 3, my = (y[0] + y[1] + y[2]) / 3;
		return fabs(mx) < 0.5 && fabs(my) < 0.5;
	}
	double inside = 0;
	for (int i = 0; i < 3; i++) {
		int next = (i + 1) % 3;
		inside += edge_area(x[i], y[i], x[next], y[next]);
	}
	return real_max(0, real_min(1, inside / area));
}

/* The square of how far the edges' control points are from the middles. */
static double bend2_of(const Piece *p)
{
	double most = 0;
	for (int i = 0; i < 3; i++) {
		int next = (i + 1) % 3;
		double x = p->x[3 + i] - 0.5 * (p->x[i] + p->x[next]);
		double y = p->y[3 + i] - 0.5 * (p->y[i] + p->y[next]);
		most = real_max(most, x * x + y * y);
	}
	return most;
}

static void split_axis(const double c[6], int axis, Piece parts[4])
{
	double half[6]; /* of corners and edges, on the way round */
	for (int i = 0; i < 3; i++) {
		half[2 * i] = 0.5 * (c[i] + c[3 + i]);
		half[2 * i + 1] = 0.5 * (c[3 + i] + c[(i + 1) % 3]);
	}
	double middle[3], inner[3]; /* of the edges; between the two middles next to a corner */
	for (int i = 0; i < 3; i++) {
		middle[i] = 0.5 * (half[2 * i] + half[2 * i + 1]);
		inner[i] = 0.25 * (c[i] + c[3] + c[4] + c[5]);
	}
	double *center = axis ? parts[3].y : parts[3].x;
	for (int i = 0; i < 3; i++) {
		int last = (i + 2) % 3;
		double *o = axis ? parts[i].y : parts[i].x;
		o[0] = c[i];
		o[1] = middle[i];
		o[2] = middle[last];
		o[3] = half[2 * i];
		o[4] = inner[i];
		o[5] = half[2 * last + 1];
		center[i] = middle[i];
		center[3 + i] = inner[(i + 1) % 3];
	}
}

/* True when all control points are beyond a line along a side and so is the window: a sliver that
 * passes by. */
static bool passes_by(const Piece *p)
{
	for (int i = 0; i < 3; i++) {
		int next = (i + 1) % 3;
		double nx = p->y[next] - p->y[i], ny = p->x[i] - p->x[next], off[6];
		for (int k = 0; k < 6; k++)
			off[k] = nx * p->x[k] + ny * p->y[k];
		double reach = 0.5 * (fabs(nx) + fabs(ny));
		if (least_of(off) >= reach || most_of(off) <= -reach)
			return true;
	}
	return false;
}

enum { MOST_DEPTH = 6, SWEPT_DEPTH = 3 };
/* Bends up to this, in sides of the window, are taken for straight. */
static const double flat = 0.08;

static double piece_share(const Piece *piece, int depth)
{
	Side side = piece_side(piece);
	if (side != ACROSS)
		return side == INSIDE;
	if (depth == 0 || bend2_of(piece) < flat * flat)
		return triangle_share(piece->x, piece->y);
	if (passes_by(piece))
		return 0;
	Piece parts[4];
	bool meets[4];
	double sum = 0;
	split_axis(piece->x, 0, parts);
	for (int i = 0; i < 4; i++)
		meets[i] = axis_side(parts[i].x) != OUTSIDE;
	if (!(meets[0] | meets[1] | meets[2] | meets[3]))
		return 0;
	split_axis(piece->y, 1, parts);
	for (int i = 0; i < 4; i++)
		if (meets[i])
			sum += 0.25 * piece_share(&parts[i], depth - 1);
	return sum;
}

/* Narrows from..to to the ts for which lo..hi, moved by t times way, meets the square. */
static void meet_axis(double lo, double hi, double way, double *from, double *to)
{
	double a = (-0.5 - hi) / way, b = (0.5 - lo) / way;
	if (way == 0) {
		if (lo >= 0.5 || hi <= -0.5)
			*to = *from;
		return;
	}
	*from = real_max(*from, real_min(a, b));
	*to = real_min(*to, real_max(a, b));
}

static Piece piece_moved(const Piece *piece, double x, double y)
{
	Piece result = *piece;
	for (int i = 0; i < 6; i++) {
		result.x[i] += x;
		result.y[i] += y;
	}
	return result;
}

/* The mean over places along the sweep, at most a window apart. */
static double small_swept_share(const Piece *piece, double x, double y)
{
	enum { MOST_STEPS = 32 };
	double from = -0.5, to = 0.5, sum = 0;
	meet_axis(least_of(piece->x), most_of(piece->x), x, &from, &to);
	meet_axis(least_of(piece->y), most_of(piece->y), y, &from, &to);
	if (!(to > from))
		return 0;
	double steps = ceil(real_min(MOST_STEPS, (to - from) * real_max(fabs(x), fabs(y))));
	for (int s = 0; s < steps; s++) {
		double t = from + (s + 0.5) / steps * (to - from);
		Piece at = piece_moved(piece, t * x, t * y);
		sum += piece_share(&at, SWEPT_DEPTH);
	}
	return sum / steps * (to - from);
}

/* How much of the line at this y lies in a flat triangle, within half a reach of the middle. */
static double chord(const double x[3], const double y[3], double at, double reach)
{
	double lo = INFINITY, hi = -INFINITY;
	for (int i = 0; i < 3; i++) {
		int next = (i + 1) % 3;
		if ((y[i] < at) == (y[next] < at))
			continue;
		double cross = x[i] + (at - y[i]) / (y[next] - y[i]) * (x[next] - x[i]);
		lo = real_min(lo, cross);
		hi = real_max(hi, cross);
	}
	return real_max(0, real_min(hi, 0.5 * reach) - real_max(lo, -0.5 * reach));
}

/* A piece much larger than the window, swept along x: how long the window's lines are in it. */
static double large_swept_share(const Piece *piece, double reach, int depth)
{
	const double *x = piece->x, *y = piece->y;
	if (least_of(x) > 0.5 * reach || most_of(x) < -0.5 * reach || least_of(y) > 0.25 ||
	    most_of(y) < -0.25)
		return 0;
	if (depth == 0 || bend2_of(piece) < flat * flat) {
		double area = 0.5 * fabs((x[1] - x[0]) * (y[2] - y[0]) -
					 (x[2] - x[0]) * (y[1] - y[0]));
		double inside = chord(x, y, -0.25, reach) + chord(x, y, 0.25, reach);
		return 0.5 * inside / (reach * real_max(area, 1e-3));
	}
	Piece parts[4];
	double sum = 0;
	split_axis(x, 0, parts);
	split_axis(y, 1, parts);
	for (int i = 0; i < 4; i++)
		sum += 0.25 * large_swept_share(&parts[i], reach, depth - 1);
	return sum;
}

static double swept_share(const Piece *piece, double x, double y)
{
	static const double large = 2; /* windows across the sweep */
	double length = sqrt(x * x + y * y);
	Piece turned; /* so that the sweep is along x */
	for (int i = 0; i < 6; i++) {
		turned.x[i] = (piece->x[i] * x + piece->y[i] * y) / length;
		turned.y[i] = (piece->y[i] * x - piece->x[i] * y) / length;
	}
	if (length < 1 || most_of(turned.y) - least_of(turned.y) < large)
		return small_swept_share(piece, x, y);
	/* The window's own length adds a twelfth to the variance of the way. */
	return large_swept_share(&turned, sqrt(length * length + 1), SWEPT_DEPTH);
}

double footprint_patch_share(const Patch *patch, const Window *window)
{
	static const double origin[3] = {0, 0, 0};
	Piece piece;
	double x, y;
	for (int i = 0; i < 6; i++)
		window_measure(window, window->at, patch->control[i], &piece.x[i], &piece.y[i]);
	window_measure(window, origin, patch->sweep, &x, &y);
	return x == 0 && y == 0 ? piece_share(&piece, MOST_DEPTH) : swept_share(&piece, x, y);
}
