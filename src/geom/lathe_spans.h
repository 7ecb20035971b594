/*
 * A lathe's profile cut into short spans on which radius and height are monotone, in a tree of the
 * rings around them. Heights are counted from the profile's middle.
 */
#ifndef GEOM_LATHE_SPANS_H
#define GEOM_LATHE_SPANS_H

#include "geom/outline.h"

enum { LATHE_DEGREE = 6 };

typedef struct LatheSpan {
	double u[4], v[4]; /* signed radius and height, as cubics of a parameter in [0, 1] */
	/* Bernstein coefficients of degree 6 of height, its square and the radius' square. Where
	 * spans join, one's last are the next one's first, bit for bit. */
	double height[LATHE_DEGREE + 1], height2[LATHE_DEGREE + 1], radius2[LATHE_DEGREE + 1];
	int segment;
	double start, length; /* in the segment's parameter */
} LatheSpan;

/* What lies between two heights and two squared radii. */
typedef struct LatheRing {
	double low, high, inner, outer;
} LatheRing;

/* In preorder: the first child follows its parent. */
typedef struct LatheNode {
	LatheRing ring;   /* a little wider than its spans */
	int second;       /* the other child; of a leaf 0 */
	int span;         /* of a leaf */
	bool by_radius;   /* the first child holds the smaller radii, else the smaller heights */
	double border2;   /* about the squared radius between the two */
} LatheNode;

typedef struct LatheSpans {
	const LatheSpan *spans;
	const LatheNode *nodes;
	int count;     /* of spans */
	double middle; /* height */
} LatheSpans;

/* Of finished segments, count > 0. In the arena. */
LatheSpans lathe_spans_create(Arena *arena, const CurveSegment *segments, int count);

/* Where the span's height is y, between the heights of its ends. */
double lathe_span_at_height(const LatheSpan *span, double y);

#endif
