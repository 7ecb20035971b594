/*
 * Splines as values: `spline { cubic_spline -1, <0,0>, 0, <1,1>, ... }`, called like a function of
 * one float. Points carry 1 to 5 components. Immutable; `spline { Other  2, <..> }` makes a copy
 * with more points.
 */
#ifndef LANG_SPLINE_H
#define LANG_SPLINE_H

#include "base/arena.h"
#include "lang/build.h"
#include "lang/value.h"

typedef enum SplineKind {
	SPLINE_LINEAR,
	SPLINE_QUADRATIC,
	SPLINE_CUBIC,
	SPLINE_NATURAL
} SplineKind;

typedef struct SplinePoint {
	double at;
	double value[5];
	double second[5]; /* the second derivative if the spline is natural */
} SplinePoint;

struct Spline {
	SplineKind kind;
	int size;         /* components, 1 to 5 */
	int count;
	const SplinePoint *points; /* by rising `at` */
};

/* The nodes inside `spline { ... }`. VALUE_NONE after a reported error. */
Value spline_build(Context *context, const Node *block);
/* The spline with its points joined in another way, as `S(t, cubic_spline)` asks; reports when it
 * is none or the word no kind of spline, and gives back the value. */
Value spline_as(Context *context, Value spline, Word kind, Location where);
/* Components beyond size are 0. */
void spline_eval(const Spline *spline, double at, double out[5]);

#endif
