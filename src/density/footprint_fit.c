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

/* Without hues the last two terms are left out. */
enum { TERMS = 7, HUE = 5, LEAST_SAMPLES = 6, ROUNDS = 2 };

typedef struct Equations {
	int terms;
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
	*e = (Equations){.terms = e->terms};
	double total = 0;
	for (int s = 0; s < count; s++) {
		double terms[TERMS];
		terms_of(&samples[s], terms);
		total += weights[s];
		for (int i = 0; i < e->terms; i++) {
			for (int j = 0; j <= i; j++)
				e->matrix[i][j] += weights[s] * terms[i] * terms[j];
			for (int k = 0; k < 2; k++)
				e->right[k][i] += weights[s] * terms[i] * samples[s].x[k];
		}
	}
	for (int i = 2; i < e->terms; i++)
		e->matrix[i][i] += ridge * total;
}

/* Of a term, the least share that those before it must leave. */
static const double singular = 1e-9;

static bool solve(Equations *e)
{
	if (!cholesky_factor(e->matrix[0], TERMS, e->terms, singular))
		return false;
	for (int k = 0; k < 2; k++) {
		cholesky_forward(e->matrix[0], TERMS, e->terms, e->right[k]);
		cholesky_back(e->matrix[0], TERMS, e->terms, e->right[k]);
	}
	return true;
}

double footprint_median(const double *values, int count)
{
	double v[FIT_MOST_SAMPLES];
	memcpy(v, values, sizeof *v * (size_t)count);
	int low = 0, high = count - 1, middle = count / 2;
	while (low < high) { /* Hoare's selection */
		double pivot = v[middle];
		int i = low, j = high;
		while (i <= j) {
			while (v[i] < pivot)
				i++;
			while (pivot < v[j])
				j--;
			if (i > j)
				break;
			double swapped = v[i];
			v[i++] = v[j];
			v[j--] = swapped;
		}
		low = j < middle ? i : low;
		high = middle < i ? j : high;
	}
	return v[middle];
}

/* Weights from squared distances, of which twice the median counts half. */
static void weigh(const FitSample *samples, const double *distance2, int count, double *weights)
{
	double scale = 2 * footprint_median(distance2, count);
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

static double roughness_of(const FitSample *samples, const double *weights, int count,
                           double residuals[][2])
{
	double all = 0, left = 0;
	for (int s = 0; s < count; s++) {
		const double *x = samples[s].x, *e = residuals[s], w = weights[s];
		all += w * (x[0] * x[0] + x[1] * x[1]);
		left += w * (e[0] * e[0] + e[1] * e[1]);
	}
	return all > 0 ? fmin(1, left / all) : 0;
}

bool footprint_fit(const FitSample *samples, int count, FootprintFit *fit)
{
	double weights[FIT_MOST_SAMPLES], distance2[FIT_MOST_SAMPLES],
		residuals[FIT_MOST_SAMPLES][2];
	Equations e = {.terms = HUE};
	if (count < LEAST_SAMPLES || count > FIT_MOST_SAMPLES)
		return false;
	for (int s = 0; s < count; s++) {
		distance2[s] = samples[s].x[0] * samples[s].x[0] +
			       samples[s].x[1] * samples[s].x[1];
		if (samples[s].hue != 0)
			e.terms = TERMS;
	}
	for (int round = 0; round < ROUNDS; round++) {
		weigh(samples, distance2, count, weights);
		make_equations(samples, weights, count, &e);
		if (!solve(&e))
			return false;
		set_residuals(samples, count, e.right, residuals, distance2);
	}
	for (int k = 0; k < 2; k++) {
		fit->jacobian[k][0] = e.right[k][0];
		fit->jacobian[k][1] = e.right[k][1];
		fit->hue[k] = e.right[k][HUE];
	}
	fit->roughness = roughness_of(samples, weights, count, residuals);
	return true;
}
