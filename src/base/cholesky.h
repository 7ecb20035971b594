/*
 * Small symmetric positive definite systems M x = b by Cholesky's factor, M = L L'. Inline, so that
 * loops over a size known when compiled are unrolled. Matrices stand row by row, `stride` numbers
 * from one row to the next; only their lower half counts.
 */
#ifndef BASE_CHOLESKY_H
#define BASE_CHOLESKY_H

#include <math.h>
#include <stdbool.h>

/* Replaces M by L. False when M is as good as singular: when of a diagonal element no more than the
 * share `least` is left by the unknowns before it. */
static inline bool cholesky_factor(double *m, int stride, int size, double least)
{
	for (int i = 0; i < size; i++) {
		double *row = m + i * stride, before = row[i];
		for (int j = 0; j <= i; j++) {
			const double *other = m + j * stride;
			double sum = row[j];
			for (int k = 0; k < j; k++)
				sum -= row[k] * other[k];
			if (i == j && !(sum > least * before))
				return false;
			row[j] = i == j ? sqrt(sum) : sum / other[j];
		}
	}
	return true;
}

/* Replaces b by y, L y = b. In a fit by least squares y[i]^2 is what term i explains of the squares
 * beyond the terms before it. */
static inline void cholesky_forward(const double *factor, int stride, int size, double *b)
{
	for (int i = 0; i < size; i++) {
		const double *row = factor + i * stride;
		for (int k = 0; k < i; k++)
			b[i] -= row[k] * b[k];
		b[i] /= row[i];
	}
}

/* Replaces y by x, L' x = y. */
static inline void cholesky_back(const double *factor, int stride, int size, double *y)
{
	for (int i = size - 1; i >= 0; i--) {
		for (int k = i + 1; k < size; k++)
			y[i] -= factor[k * stride + i] * y[k];
		y[i] /= factor[i * stride + i];
	}
}

#endif
