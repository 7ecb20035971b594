/*
 * The map from the light to the surface, fitted to second order about the photon by least squares:
 * x = C c + J e + H(e, e) / 2, with x the place in the tangent plane, e where they left the light
 * and c their colour, as parted light of other hues falls elsewhere. Then rho ~ 1 / det J, and
 * grad rho / rho = -J^-T (d det J / de) / det J.
 *
 * Near a fold density is no line over the disc of those that push, and may end within it. There
 * what all places of the sheet together would push is summed up: those that the map, folds and
 * all, takes into the disc, of a pattern over the part of the light where neighbours come from.
 *
 * How far the curvature H is trusted is Stein's: one less the inverse of how much more of the
 * neighbours' places it explains than as many terms of chance would.
 */
#include "photon/relax_gradient.h"

#include <math.h>

#include "base/cholesky.h"

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__SANITIZE_ADDRESS__)
#define CLONES __attribute__((target_clones("avx2", "default")))
#else
#define CLONES
#endif

/* Columns of the fit: colour, first order, second order; then the places. */
enum {
	RED, BLUE, A, B, AA, AB, BB, TERMS,
	X = TERMS, Y, COLUMNS,
	COLORS = 2, CURVED = 3,
	LEAST = TERMS + 6, /* neighbours: so many more than terms that chance is seen */
};

/* More neighbours than there is room for add nothing. */
enum { ROOM = 256 };

typedef struct Columns {
	float at[COLUMNS][ROOM];
	int count;
} Columns;

typedef struct Fit {
	double matrix[TERMS][TERMS]; /* lower half; Cholesky's factor in the end */
	double map[2][TERMS];        /* of x, of y */
	double squares;              /* of all places; in the end what the fit leaves of them */
} Fit;

/* Colour without brightness; its differences are what counts. */
static void color_of(const RelaxPoint *point, float color[COLORS])
{
	const float *f = point->flux;
	float all = f[0] + f[1] + f[2];
	color[0] = all > 0 ? f[0] / all : 0;
	color[1] = all > 0 ? f[2] / all : 0;
}

/* v between two places, per `unit`, along both axes. */
static void difference(const float to[3], const float from[3], const Vec3 axes[2], double unit,
		       float out[2])
{
	Vec3 d = vec3((double)to[0] - from[0], (double)to[1] - from[1], (double)to[2] - from[2]);
	for (int k = 0; k < 2; k++)
		out[k] = (float)(vec3_dot(d, axes[k]) / unit);
}

/* Places per radius, emitter coordinates per search range: numbers about one. */
static void fill_columns(const RelaxPiece *piece, Columns *columns)
{
	const RelaxPoint *points = piece->set->points, *p = &points[piece->point];
	double range = sqrt((double)p->range2);
	Vec3 own[2];
	float color[COLORS], other[COLORS], e[2], x[2];
	relax_emitter_axes(p->emitter, p->on_plane, own);
	color_of(p, color);
	columns->count = piece->found < ROOM ? piece->found : ROOM;
	for (int n = 0; n < columns->count; n++) {
		const RelaxPoint *q = &points[piece->near[n].index];
		difference(q->emitter, p->emitter, own, range, e);
		difference(q->position, p->position, piece->axes, piece->radius, x);
		color_of(q, other);
		const float row[COLUMNS] = {
			other[0] - color[0], other[1] - color[1], e[0], e[1], 0.5f * e[0] * e[0],
			e[0] * e[1], 0.5f * e[1] * e[1], x[0], x[1]};
		for (int c = 0; c < COLUMNS; c++)
			columns->at[c][n] = row[c];
	}
}

static inline double product(const Columns *columns, int a, int b)
{
	float sum = 0;
#pragma omp simd reduction(+ : sum)
	for (int n = 0; n < columns->count; n++)
		sum += columns->at[a][n] * columns->at[b][n];
	return (double)sum;
}

/* Light of one colour has nothing in the first columns: a touch of a ridge keeps them apart. */
static const double RIDGE = 1e-6;
/* Of a term, the least share that those before it must leave. */
static const double SINGULAR = 1e-6;

CLONES static void make_equations(const Columns *columns, Fit *fit)
{
	for (int a = 0; a < TERMS; a++) {
		for (int b = 0; b <= a; b++)
			fit->matrix[a][b] = product(columns, a, b);
		fit->map[0][a] = product(columns, a, X);
		fit->map[1][a] = product(columns, a, Y);
	}
	for (int c = 0; c < COLORS; c++)
		fit->matrix[c][c] += RIDGE * columns->count;
	fit->squares = product(columns, X, X) + product(columns, Y, Y);
}

/* Solves for one side; what each term explains beyond those before it is taken from the squares.
 * Returns what the curvature explains. */
static double solve(Fit *fit, double x[TERMS])
{
	double curved = 0;
	cholesky_forward(fit->matrix[0], TERMS, TERMS, x);
	for (int i = 0; i < TERMS; i++) {
		fit->squares -= x[i] * x[i];
		curved += i >= AA ? x[i] * x[i] : 0;
	}
	cholesky_back(fit->matrix[0], TERMS, TERMS, x);
	return curved;
}

/* -J^-T (d det J / de) / det J */
static void gradient_of(const Fit *fit, double g[2])
{
	const double *x = fit->map[0], *y = fit->map[1];
	double det = x[A] * y[B] - x[B] * y[A];
	double by_a = x[AA] * y[B] + x[A] * y[AB] - x[AB] * y[A] - x[B] * y[AA],
	       by_b = x[AB] * y[B] + x[A] * y[BB] - x[BB] * y[A] - x[B] * y[AB];
	g[0] = -(by_a * y[B] - y[A] * by_b) / (det * det);
	g[1] = -(x[A] * by_b - x[B] * by_a) / (det * det);
}

/* ---- near folds ---- */

RelaxPattern relax_pattern(void)
{
	const double golden_angle = M_PI * (3 - sqrt(5));
	RelaxPattern pattern;
	for (int n = 0; n < RELAX_PATTERN / 2; n++) {
		double radius = sqrt((2 * n + 1.0) / RELAX_PATTERN), angle = golden_angle * n;
		int opposite = n + RELAX_PATTERN / 2;
		pattern.a[n] = (float)(radius * cos(angle));
		pattern.b[n] = (float)(radius * sin(angle));
		pattern.a[opposite] = -pattern.a[n];
		pattern.b[opposite] = -pattern.b[n];
	}
	return pattern;
}

/* Of the ellipse in emitter space from where those come that push: what takes the disc there. */
typedef struct Source { float aa, ba, bb; } Source;

/* From the second moments of where neighbours start, as a disc's are a quarter of its square. */
static Source find_source(const Columns *columns, double radius)
{
	/* Wider than it may seem: chance, and ways back over the fold. */
	const double margin = 1.6;
	double per = 1.0 / columns->count, scale = 2 * margin * radius;
	double aa = per * product(columns, A, A), ab = per * product(columns, A, B),
	       bb = per * product(columns, B, B);
	double first = sqrt(aa), second = first > 0 ? ab / first : 0;
	return (Source){(float)(scale * first), (float)(scale * second),
			(float)(scale * sqrt(fmax(bb - second * second, 0)))};
}

typedef struct Sheet { float a, b, aa, ab, bb; } Sheet; /* terms along one axis */

static Sheet sheet_along(const double map[TERMS])
{
	return (Sheet){(float)map[A], (float)map[B], 0.5f * (float)map[AA], (float)map[AB],
		       0.5f * (float)map[BB]};
}

/* SJ13 eq. 8 over the sheet, places for photons. */
CLONES static void push_of_sheet(const Fit *fit, const Source *source, const RelaxPattern *pattern,
				 float radius, double push[2])
{
	const Sheet sx = sheet_along(fit->map[0]), sy = sheet_along(fit->map[1]);
	const float tiny = 1e-9f;
	float px = 0, py = 0, inside = 0;
#pragma omp simd reduction(+ : px, py, inside)
	for (int n = 0; n < RELAX_PATTERN; n++) {
		float a = source->aa * pattern->a[n],
		      b = source->ba * pattern->a[n] + source->bb * pattern->b[n];
		float x = sx.a * a + sx.b * b + sx.aa * a * a + sx.ab * a * b + sx.bb * b * b,
		      y = sy.a * a + sy.b * b + sy.aa * a * a + sy.ab * a * b + sy.bb * b * b;
		float distance = sqrtf(x * x + y * y);
		float in = distance < radius && a * a + b * b < 1 ? 1 : 0; /* within the range */
		float strength = in * (radius / (distance + tiny) - 1);
		px -= x * strength;
		py -= y * strength;
		inside += in;
	}
	push[0] = inside > 0 ? (double)(px / inside) : 0;
	push[1] = inside > 0 ? (double)(py / inside) : 0;
}

/* The gradient whose mean push -g r^2 / 12 is that of the sheet. */
static void gradient_near_fold(const Fit *fit, const Columns *columns, double radius,
			       const RelaxPattern *pattern, double g[2])
{
	Source source = find_source(columns, radius);
	push_of_sheet(fit, &source, pattern, (float)radius, g);
	for (int k = 0; k < 2; k++)
		g[k] *= -12 / (radius * radius);
}

/* ---- all ---- */

/* Density that changes by more than this over the radius of those that push is a fold's. */
static const double STEEP = 0.5;
/* And more than this, over that of all neighbours, is nothing that the fit could know. */
static const double STEEPEST = 4;

Vec3 relax_gradient(const RelaxPiece *piece, const RelaxPattern *pattern)
{
	Columns columns;
	Fit fit;
	double g[2], pushing = sqrt(fmin(1, piece->pushing));
	if (piece->found < LEAST || !(piece->radius > 0) ||
	    !(piece->set->points[piece->point].range2 < INFINITY))
		return vec3(0, 0, 0);
	fill_columns(piece, &columns);
	make_equations(&columns, &fit);
	if (!cholesky_factor(fit.matrix[0], TERMS, TERMS, SINGULAR))
		return vec3(0, 0, 0);
	double curved = solve(&fit, fit.map[0]) + solve(&fit, fit.map[1]);
	double chance = 2 * CURVED * fmax(fit.squares, 0) / (2 * (columns.count - TERMS));
	if (!(curved > chance))
		return vec3(0, 0, 0);
	gradient_of(&fit, g);
	if (!(hypot(g[0], g[1]) * pushing < STEEP))
		gradient_near_fold(&fit, &columns, pushing, pattern, g);
	double steep = hypot(g[0], g[1]);
	double scale = (1 - chance / curved) * fmin(1, STEEPEST / fmax(steep, STEEPEST)) /
		       piece->radius;
	return vec3_add(vec3_scale(piece->axes[0], scale * g[0]),
			vec3_scale(piece->axes[1], scale * g[1]));
}

void relax_gradient_resist(const float gradient[3], float radius, float force[3])
{
	/* The push at the edge of a half disc, per radius: 2 / (3 pi). No gradient pushes more. */
	const float most = 0.2122f;
	float steep = sqrtf(gradient[0] * gradient[0] + gradient[1] * gradient[1] +
			    gradient[2] * gradient[2]);
	if (!(steep * radius > 0))
		return;
	float scale = fminf(steep * radius / 12, most) * radius / steep;
	for (int k = 0; k < 3; k++)
		force[k] += scale * gradient[k];
}
