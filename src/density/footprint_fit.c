/*
 * Neighbours may lie on the far side of a crease of the map: on another facet, behind another
 * edge. So weights are taken again from how far each neighbour is from the fit beside the
 * median one (iteratively reweighted least squares with Cauchy's weights, Holland & Welsch 1977).
 * The first weights prefer what is near on the surface too.
 */
#include "density/footprint_fit.h"

#include <math.h>
#include <string.h>

#include "base/cholesky.h"
#include "base/median.h"
#include "base/pair.h"

/* Without hues the last two terms are left out. */
enum { TERMS = 7, HUE = 5, LEAST_SAMPLES = 6, ROUNDS = 2 };

/* A sample's terms and, after them, its two places on the surface: one row of the system, in pairs,
 * filled with zeros. */
enum { PLAIN_PAIRS = 4, PAIRS = 5, WIDTH = 2 * PAIRS };

typedef union Row {
	double at[WIDTH];
	Pair pairs[PAIRS];
} Row;

typedef struct Equations {
	int terms;
	Row matrix[TERMS]; /* the right sides stand where a row has the places */
	double solution[2][TERMS];
} Equations;

static void set_row(const FitSample *sample, int terms, Row *row)
{
	const double *d = sample->d, hue = sample->hue;
	*row = (Row){{d[0], d[1], 0.5 * d[0] * d[0], d[0] * d[1], 0.5 * d[1] * d[1]}};
	if (terms > HUE) {
		row->at[HUE] = hue;
		row->at[HUE + 1] = 0.5 * hue * hue;
	}
	row->at[terms] = sample->x[0];
	row->at[terms + 1] = sample->x[1];
}

/* Curvature is drawn to zero a little, so that six samples don't make it wild. */
static const double ridge = 1e-4;

/* Sums over the samples of a row times one of its terms; pairs is a constant where this is
 * inlined. */
static inline void add_rows(const Row *rows, const double *weights, int count, int term, int pairs,
			    Row *sums)
{
	Pair sum[PAIRS] = {{0}};
	for (int s = 0; s < count; s++) {
		double weighted = weights[s] * rows[s].at[term];
		Pair both = {weighted, weighted};
#pragma GCC unroll 5
		for (int i = 0; i < pairs; i++)
			sum[i] += both * rows[s].pairs[i];
	}
	memcpy(sums->pairs, sum, sizeof sum);
}

/* The upper half comes with the rows and is not used. */
static void make_equations(const Row *rows, const double *weights, int count, Equations *e)
{
	double total = 0;
	for (int i = 0; i < e->terms; i++) {
		if (e->terms == HUE)
			add_rows(rows, weights, count, i, PLAIN_PAIRS, &e->matrix[i]);
		else
			add_rows(rows, weights, count, i, PAIRS, &e->matrix[i]);
	}
	for (int s = 0; s < count; s++)
		total += weights[s];
	for (int i = 2; i < e->terms; i++)
		e->matrix[i].at[i] += ridge * total;
}

/* Of a term, the least share that those before it must leave. */
static const double singular = 1e-9;

static inline bool solve_some(Equations *e, int terms)
{
	if (!cholesky_factor(e->matrix[0].at, WIDTH, terms, singular))
		return false;
	for (int k = 0; k < 2; k++) {
		for (int i = 0; i < terms; i++)
			e->solution[k][i] = e->matrix[i].at[terms + k];
		cholesky_forward(e->matrix[0].at, WIDTH, terms, e->solution[k]);
		cholesky_back(e->matrix[0].at, WIDTH, terms, e->solution[k]);
	}
	return true;
}

static bool solve(Equations *e)
{
	return e->terms == HUE ? solve_some(e, HUE) : solve_some(e, TERMS);
}

/* Weights from squared distances, of which twice the median counts half, and from nearness in the
 * parameters. */
static void weigh(const double *near, const double *distance2, int count, double *weights)
{
	double scale = 2 * median(distance2, count);
	for (int i = 0; i < count; i++)
		weights[i] = scale > 0 ? near[i] * scale / (scale + distance2[i]) : near[i];
}

static void set_residuals(const Row *rows, int count, const Equations *e,
			  double *residual2)
{
	for (int s = 0; s < count; s++) {
		const double *row = rows[s].at;
		double x = row[e->terms], y = row[e->terms + 1];
		for (int i = 0; i < e->terms; i++) {
			x -= e->solution[0][i] * row[i];
			y -= e->solution[1][i] * row[i];
		}
		residual2[s] = x * x + y * y;
	}
}

static double square_of(const double v[2]) { return v[0] * v[0] + v[1] * v[1]; }

static double roughness_of(const FitSample *samples, const double *weights, int count,
			   const double *residual2)
{
	double all = 0, left = 0;
	for (int s = 0; s < count; s++) {
		all += weights[s] * square_of(samples[s].x);
		left += weights[s] * residual2[s];
	}
	return all > 0 ? fmin(1, left / all) : 0;
}

static int terms_of(const FitSample *samples, int count)
{
	for (int s = 0; s < count; s++)
		if (samples[s].hue != 0)
			return TERMS;
	return HUE;
}

bool footprint_fit(const FitSample *samples, int count, FootprintFit *fit)
{
	Row rows[FIT_MOST_SAMPLES];
	double near[FIT_MOST_SAMPLES], weights[FIT_MOST_SAMPLES], distance2[FIT_MOST_SAMPLES];
	if (count < LEAST_SAMPLES || count > FIT_MOST_SAMPLES)
		return false;
	Equations e = {.terms = terms_of(samples, count)};
	for (int s = 0; s < count; s++) {
		set_row(&samples[s], e.terms, &rows[s]);
		near[s] = exp(-square_of(samples[s].d));
		distance2[s] = square_of(samples[s].x);
	}
	for (int round = 0; round < ROUNDS; round++) {
		weigh(near, distance2, count, weights);
		make_equations(rows, weights, count, &e);
		if (!solve(&e))
			return false;
		set_residuals(rows, count, &e, distance2);
	}
	for (int k = 0; k < 2; k++) {
		fit->jacobian[k][0] = e.solution[k][0];
		fit->jacobian[k][1] = e.solution[k][1];
		fit->hue[k] = e.solution[k][HUE];
	}
	fit->roughness = roughness_of(samples, weights, count, distance2);
	return true;
}
