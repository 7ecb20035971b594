/*
 * Where a function along a ray crosses zero: the Illinois form of the secant method (Dowell &
 * Jarratt 1971), which halves the value of an end that stays, so that both ends close in.
 */
#ifndef GEOM_SECANT_H
#define GEOM_SECANT_H

#include <math.h>

#include "base/vec.h"

typedef struct SecantSample {
	double t, value;
} SecantSample;

typedef double SecantFunction(const void *data, double t);

/* Between two samples of different sign, in any order; a value of 0 counts as below. Ends when they
 * are no farther apart than `stop`, or after sixty steps. Inlined: asking the function is no call
 * of a pointer. */
static inline __attribute__((always_inline)) double
secant_root(SecantFunction *function, const void *data, SecantSample a, SecantSample b, double stop)
{
	enum { STEPS = 60 };
	for (int i = 0; i < STEPS && fabs(b.t - a.t) > stop; i++) {
		double t = b.t - b.value * (b.t - a.t) / (b.value - a.value);
		if (!(t > real_min(a.t, b.t) && t < real_max(a.t, b.t)))
			t = 0.5 * (a.t + b.t);
		SecantSample next = {t, function(data, t)};
		if (next.value == 0)
			return t;
		if ((next.value > 0) != (b.value > 0))
			a = b;
		else
			a.value *= 0.5;
		b = next;
	}
	return b.t;
}

#endif
