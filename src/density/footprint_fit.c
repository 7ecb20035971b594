/*
 * Neighbours may lie on the far side of a crease of the map: on another facet, behind another
 * edge. So weights are taken again, twice, from how far each neighbour is from the fit beside the
 * median one (iteratively reweighted least squares with Cauchy's weights, Holland & Welsch 1977).
 * The first weights prefer what is near on the surface too.
 */
#include "density/footprint_fit.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Without hues the last two terms are 0, and so is what the ridge makes of them. */
enum { TERMS = 7, HUE = 5, LEAST_SAMPLES = 6, ROUNDS = 3 };

typedef struct Equations {
	double matrix[TERMS][TERMS], right[2][TERMS];
} Equations;

static void terms_of(const FitSample *sample, double terms[TERMS])
{
	const double *d = sample->d, hue = sample->hue;
	terms[0] = d[0];
	terms[1] = d[1];
	terms[2] = 0.5 * d[0] * d[0];
	terms[3] = d[0] * d[1];
	terms[4] = 0.5 * d[1] * d[1];
	terms[HUE] = hue;
	terms[HUE + 1] = 0.5 * hue * hue;
}

/* Curvature is drawn to zero a little, so that six samples don't make it wild. */
static const double ridge = 1e-4;

static void make_equations(const FitSample *samples, const double *weights, int count, Equations *e)
{
	memset(e, 0, sizeof *e);
	double total = 0;
	for (int s = 0; s < count; s++) {
		double terms[TERMS];
		terms_of(&samples[s], terms);
		total += weights[s];
		for (int i = 0; i < TERMS; i++) {
			for (int j = 0; j < TERMS; j++)
				e->matrix[i][j] += weights[s] * terms[i] * terms[j];
			for (int k = 0; k < 2; k++)
				e->right[k][i] += weights[s] * terms[i] * samples[s].x[k];
		}
	}
	for (int i = 2; i < TERMS; i++)
		e->matrix[i][i] += ridge * total;
}

/* Cholesky's factor, in the lower half; false when the matrix is singular. */
static bool factor(double m[TERMS][TERMS])
{
	for (int i = 0; i < TERMS; i++) {
		double before = m[i][i];
		for (int j = 0; j <= i; j++) {
			double sum = m[i][j];
			for (int k = 0; k < j; k++)
				sum -= m[i][k] * m[j][k];
			if (i == j && !(sum > 1e-9 * before))
				return false;
			m[i][j] = i == j ? sqrt(sum) : sum / m[j][j];
		}
	}
	return true;
}

static void solve(double m[TERMS][TERMS], double *x)
{
	for (int i = 0; i < TERMS; i++) {
		for (int k = 0; k < i; k++)
			x[i] -= m[i][k] * x[k];
		x[i] /= m[i][i];
	}
	for (int i = TERMS - 1; i >= 0; i--) {
		for (int k = i + 1; k < TERMS; k++)
			x[i] -= m[k][i] * x[k];
		x[i] /= m[i][i];
	}
}

static int compare_doubles(const void *a, const void *b)
{
	double x = *(const double *)a, y = *(const double *)b;
	return (x > y) - (x < y);
}

static double median(const double *values, int count)
{
	double sorted[FIT_MOST_SAMPLES];
	memcpy(sorted, values, sizeof *sorted * (size_t)count);
	qsort(sorted, (size_t)count, sizeof *sorted, compare_doubles);
	return sorted[count / 2];
}

/* Weights from squared distances, of which twice the median counts half. */
static void weigh(const FitSample *samples, const double *distance2, int count, double *weights)
{
	double scale = 2 * median(distance2, count);
	for (int i = 0; i < count; i++) {
		double d2 = samples[i].d[0] * samples[i].d[0] + samples[i].d[1] * samples[i].d[1];
		double near = exp(-d2);
		weights[i] = scale > 0 ? near * scale / (scale + distance2[i]) : near;
	}
}

static void set_residuals(const FitSample *samples, int count, double solution[2][TERMS],
                          double residuals[][2], double *residual2)
{
	for (int s = 0; s < count; s++) {
		double terms[TERMS];
		terms_of(&samples[s], terms);
		for (int k = 0; k < 2; k++) {
			residuals[s][k] = samples[s].x[k];
			for (int i = 0; i < TERMS; i++)
				residuals[s][k] -= solution[k][i] * terms[i];
		}
		residual2[s] = residuals[s][0] * residuals[s][0] +
			       residuals[s][1] * residuals[s][1];
	}
}

static void finish(const FitSample *samples, const double *weights, int count,
                   double residuals[][2], FootprintFit *fit)
{
	double total = 0, all = 0, misfit = 0;
	Symmetric r = {0, 0, 0};
	for (int s = 0; s < count; s++) {
		const double *x = samples[s].x, *e = residuals[s], w = weights[s];
		total += w;
		misfit += e[0] * e[0] + e[1] * e[1];
		all += w * (x[0] * x[0] + x[1] * x[1]);
		r = (Symmetric){r.uu + w * e[0] * e[0], r.uv + w * e[0] * e[1],
				r.vv + w * e[1] * e[1]};
	}
	fit->residual = (Symmetric){r.uu / total, r.uv / total, r.vv / total};
	fit->misfit = misfit / count;
	fit->roughness = all > 0 ? fmin(1, (r.uu + r.vv) / all) : 0;
}

bool footprint_fit(const FitSample *samples, int count, FootprintFit *fit)
{
	double weights[FIT_MOST_SAMPLES], distance2[FIT_MOST_SAMPLES],
		residuals[FIT_MOST_SAMPLES][2];
	Equations e;
	if (count < LEAST_SAMPLES || count > FIT_MOST_SAMPLES)
		return false;
	for (int s = 0; s < count; s++)
		distance2[s] = samples[s].x[0] * samples[s].x[0] +
			       samples[s].x[1] * samples[s].x[1];
	for (int round = 0; round < ROUNDS; round++) {
		weigh(samples, distance2, count, weights);
		make_equations(samples, weights, count, &e);
		if (!factor(e.matrix))
			return false;
		solve(e.matrix, e.right[0]);
		solve(e.matrix, e.right[1]);
		set_residuals(samples, count, e.right, residuals, distance2);
	}
	for (int k = 0; k < 2; k++) {
		fit->jacobian[k][0] = e.right[k][0];
		fit->jacobian[k][1] = e.right[k][1];
		fit->hue[k] = e.right[k][HUE];
		fit->hue_curve[k] = e.right[k][HUE + 1];
		fit->hessian[k] = (Symmetric){e.right[k][2], e.right[k][3], e.right[k][4]};
	}
	finish(samples, weights, count, residuals, fit);
	return true;
}

static double product_trace(Symmetric a, Symmetric b)
{
	return a.uu * b.uu + 2 * a.uv * b.uv + a.vv * b.vv;
}

FootprintSpread footprint_spread(const FootprintFit *fit, double s2)
{
	const double (*j)[2] = fit->jacobian;
	const Symmetric *h = fit->hessian;
	double s4 = 0.5 * s2 * s2;
	return (FootprintSpread){
		.mean = {0.5 * s2 * (h[0].uu + h[0].vv), 0.5 * s2 * (h[1].uu + h[1].vv)},
		.linear = {s2 * (j[0][0] * j[0][0] + j[0][1] * j[0][1]),
		           s2 * (j[0][0] * j[1][0] + j[0][1] * j[1][1]),
		           s2 * (j[1][0] * j[1][0] + j[1][1] * j[1][1])},
		.curved = {s4 * product_trace(h[0], h[0]), s4 * product_trace(h[0], h[1]),
		           s4 * product_trace(h[1], h[1])},
	};
}
