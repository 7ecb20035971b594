/*
 * Closed plane curves made of polynomial segments of degree 3 or less: what prisms and letters are
 * swept from, and whose halves lathes are turned from.
 */
#ifndef GEOM_OUTLINE_H
#define GEOM_OUTLINE_H

#include "base/arena.h"
#include "base/vec.h"

/* p(s) = a[0] + a[1] s + a[2] s^2 + a[3] s^3 for s in [0, 1]. */
typedef struct CurveSegment {
	double u[4], v[4];
	Vec2 lo, hi; /* bounds */
} CurveSegment;

typedef struct Outline {
	const CurveSegment *segments;
	int count;
	Vec2 lo, hi;
} Outline;

typedef enum CurveKind { CURVE_LINEAR, CURVE_QUADRATIC, CURVE_CUBIC, CURVE_BEZIER } CurveKind;

/* p(s), and its derivative. */
Vec2 curve_point(const CurveSegment *segment, double s);
Vec2 curve_tangent(const CurveSegment *segment, double s);

/* Segments through points as POV-Ray's prism and lathe read them: linear: from each point to the
 * next; quadratic: the first point is a control point only; cubic: the first and the last; bezier:
 * four points a segment. Returns the segments, *count of them; NULL with *error set when there are
 * too few points. */
CurveSegment *curve_from_points(Arena *arena, CurveKind kind, const Vec2 *points, int point_count,
				int *count, const char **error);
void curve_finish(CurveSegment *segment); /* computes the bounds */
/* Around finished segments, which must outlive it. */
Outline outline_create(const CurveSegment *segments, int count);

/* Parameters s in [0, 1) where c0 + c1 u(s) + c2 v(s) = 0; at most 3, returns how many. */
int curve_cross_line(const CurveSegment *segment, const double c[3], double s[3]);
/* Even-odd rule. */
bool outline_inside(const Outline *outline, Vec2 p);

#endif
