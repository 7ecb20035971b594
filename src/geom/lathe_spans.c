#include "geom/lathe_spans.h"

#include <stdlib.h>

#include "geom/polynomial.h"

enum {
	MOST_CUTS = 12,  /* in a segment: its two ends, 2 + 2 turning points, 3 on the axis */
	MOST_PARTS = 16, /* of what lies between two cuts */
	MOST_SPANS = (MOST_CUTS - 1) * MOST_PARTS,
};

/* A span bends off its chord by no more than this share of it: then a ray that comes near mostly
 * crosses it once or not at all. Measured. */
static const double FLATNESS = 0.05;

/* Rings are wider than their spans by this share of the profile's size. */
static const double MARGIN = 1e-12;

/* ---- spans ---- */

/* Coefficients of degree 6 of the product of two cubics' Bernstein forms. */
static void multiply(const double a[4], const double b[4], double product[LATHE_DEGREE + 1])
{
	static const double choose3[] = {1, 3, 3, 1}, choose6[] = {1, 6, 15, 20, 15, 6, 1};
	for (int i = 0; i <= LATHE_DEGREE; i++)
		product[i] = 0;
	for (int i = 0; i < 4; i++)
		for (int j = 0; j < 4; j++)
			product[i + j] += choose3[i] * choose3[j] / choose6[i + j] * a[i] * b[j];
}

static void to_powers(const double b[4], double c[4])
{
	c[0] = b[0];
	c[1] = 3 * (b[1] - b[0]);
	c[2] = 3 * (b[0] - 2 * b[1] + b[2]);
	c[3] = b[3] - 3 * b[2] + 3 * b[1] - b[0];
}

/* Bernstein form of a cubic between two parameters, its end values as given. */
static void cut_cubic(const double c[4], double from, double length, double first, double last,
		      double b[4])
{
	double to = from + length;
	b[0] = first;
	b[1] = first + length / 3 * (c[1] + from * (2 * c[2] + from * 3 * c[3]));
	b[2] = last - length / 3 * (c[1] + to * (2 * c[2] + to * 3 * c[3]));
	b[3] = last;
}

static LatheSpan make_span(const CurveSegment *g, double from, double length, Vec2 first, Vec2 last)
{
	static const double ones[4] = {1, 1, 1, 1};
	double u[4], v[4];
	LatheSpan span = {.start = from, .length = length};
	cut_cubic(g->u, from, length, first.u, last.u, u);
	cut_cubic(g->v, from, length, first.v, last.v, v);
	to_powers(u, span.u);
	to_powers(v, span.v);
	multiply(v, ones, span.height);
	multiply(v, v, span.height2);
	multiply(u, u, span.radius2);
	return span;
}

static int compare_numbers(const void *a, const void *b)
{
	double x = *(const double *)a, y = *(const double *)b;
	return (x > y) - (x < y);
}

static int turning_points(const double c[4], double *out)
{
	double all[2];
	int count = polynomial_quadratic(3 * c[3], 2 * c[2], c[1], all), kept = 0;
	for (int i = 0; i < count; i++)
		if (all[i] > 0 && all[i] < 1)
			out[kept++] = all[i];
	return kept;
}

/* Where radius or height turn and where the axis is crossed, with both ends, rising. */
static int find_cuts(const CurveSegment *g, double cuts[MOST_CUTS])
{
	int count = 0;
	cuts[count++] = 0;
	cuts[count++] = 1;
	count += turning_points(g->u, cuts + count);
	count += turning_points(g->v, cuts + count);
	count += polynomial_roots(g->u, 3, 0, 1, cuts + count);
	qsort(cuts, (size_t)count, sizeof *cuts, compare_numbers);
	return count;
}

/* In how many parts a piece is flat enough: each has a square as many times less of a bend. */
static int parts_of(const CurveSegment *g, double from, double to)
{
	Vec2 a = curve_point(g, from), b = curve_point(g, to),
	     middle = curve_point(g, 0.5 * (from + to));
	double bend = hypot(middle.u - 0.5 * (a.u + b.u), middle.v - 0.5 * (a.v + b.v));
	double parts = ceil(sqrt(bend / (FLATNESS * hypot(b.u - a.u, b.v - a.v))));
	return parts >= 1 ? (int)fmin(parts, MOST_PARTS) : 1;
}

static int cut_segment(const CurveSegment *g, double ends[MOST_SPANS + 1])
{
	double cuts[MOST_CUTS];
	int count = find_cuts(g, cuts), spans = 0;
	for (int i = 0; i + 1 < count; i++) {
		if (!(cuts[i + 1] > cuts[i]))
			continue;
		int parts = parts_of(g, cuts[i], cuts[i + 1]);
		for (int k = 0; k < parts; k++)
			ends[spans++] = cuts[i] + k * (cuts[i + 1] - cuts[i]) / parts;
	}
	ends[spans] = 1;
	return spans;
}

static Vec2 lowered(Vec2 p, double middle)
{
	return (Vec2){p.u, p.v - middle};
}

/* The end of a segment is the start of the next one where these are one but for rounding. */
static Vec2 end_of(const CurveSegment *g, const CurveSegment *next, double tiny)
{
	Vec2 end = curve_point(g, 1), start = next ? curve_point(next, 0) : end;
	return hypot(end.u - start.u, end.v - start.v) < tiny ? start : end;
}

static void add_spans(LatheSpans *out, LatheSpan *spans, const CurveSegment *g,
		      const double *ends, int count, Vec2 last)
{
	Vec2 from = lowered(curve_point(g, 0), out->middle);
	for (int i = 0; i < count; i++) {
		Vec2 to = lowered(i + 1 < count ? curve_point(g, ends[i + 1]) : last, out->middle);
		spans[out->count++] = make_span(g, ends[i], ends[i + 1] - ends[i], from, to);
		from = to;
	}
}

/* ---- the tree ---- */

typedef struct Sorted {
	double key;
	int span;
} Sorted;

typedef struct Builder {
	const LatheSpan *spans;
	LatheNode *nodes;
	int count;
	Sorted *order;
	double size;
} Builder;

static LatheRing ring_of(const LatheSpan *span)
{
	double a = span->height[0], b = span->height[LATHE_DEGREE], c = span->radius2[0],
	       d = span->radius2[LATHE_DEGREE];
	return (LatheRing){fmin(a, b), fmax(a, b), fmin(c, d), fmax(c, d)};
}

static LatheRing ring_around(const Builder *builder, int first, int count)
{
	LatheRing all = {INFINITY, -INFINITY, INFINITY, -INFINITY};
	for (int i = first; i < first + count; i++) {
		LatheRing ring = ring_of(&builder->spans[builder->order[i].span]);
		all = (LatheRing){fmin(all.low, ring.low), fmax(all.high, ring.high),
				  fmin(all.inner, ring.inner), fmax(all.outer, ring.outer)};
	}
	return all;
}

static int compare_sorted(const void *a, const void *b)
{
	const Sorted *left = a, *right = b;
	if (left->key != right->key)
		return left->key < right->key ? -1 : 1;
	return (left->span > right->span) - (left->span < right->span);
}

static double radius_of(const LatheRing *ring)
{
	return 0.5 * (sqrt(ring->inner) + sqrt(ring->outer));
}

/* By radius or by height, where they spread more. */
static bool sort_spans(Builder *builder, int first, int count)
{
	LatheRing all = ring_around(builder, first, count);
	bool by_radius = sqrt(all.outer) - sqrt(all.inner) > all.high - all.low;
	for (int i = first; i < first + count; i++) {
		LatheRing ring = ring_of(&builder->spans[builder->order[i].span]);
		builder->order[i].key = by_radius ? radius_of(&ring) : ring.low + ring.high;
	}
	qsort(builder->order + first, (size_t)count, sizeof(Sorted), compare_sorted);
	return by_radius;
}

static LatheRing widened(LatheRing ring, double size)
{
	double by = MARGIN * size;
	return (LatheRing){ring.low - by, ring.high + by, ring.inner - by * size,
			   ring.outer + by * size};
}

static void build_node(Builder *builder, int first, int count)
{
	LatheNode *node = &builder->nodes[builder->count++];
	LatheRing ring = ring_around(builder, first, count);
	*node = (LatheNode){.ring = widened(ring, builder->size),
			    .span = builder->order[first].span};
	if (count == 1)
		return;
	node->by_radius = sort_spans(builder, first, count);
	int half = count / 2;
	double border = builder->order[first + half].key;
	node->border2 = node->by_radius ? border * border : 0;
	build_node(builder, first, half);
	node->second = builder->count;
	build_node(builder, first + half, count - half);
}

static const LatheNode *build_tree(Arena *arena, const LatheSpan *spans, int count, double size)
{
	Builder builder = {
		.spans = spans,
		.nodes = ARENA_ARRAY(arena, LatheNode, 2 * count),
		.order = ARENA_ARRAY(arena, Sorted, count),
		.size = size,
	};
	for (int i = 0; i < count; i++)
		builder.order[i].span = i;
	build_node(&builder, 0, count);
	return builder.nodes;
}

LatheSpans lathe_spans_create(Arena *arena, const CurveSegment *segments, int count)
{
	Outline outline = outline_create(segments, count);
	double size = fmax(fmax(fabs(outline.lo.u), fabs(outline.hi.u)),
			   outline.hi.v - outline.lo.v),
	       ends[MOST_SPANS + 1];
	int total = 0;
	for (int i = 0; i < count; i++)
		total += cut_segment(&segments[i], ends);
	LatheSpan *spans = ARENA_ARRAY(arena, LatheSpan, total);
	LatheSpans out = {.spans = spans, .middle = 0.5 * (outline.lo.v + outline.hi.v)};
	for (int i = 0; i < count; i++) {
		int first = out.count, some = cut_segment(&segments[i], ends);
		Vec2 last = end_of(&segments[i], i + 1 < count ? &segments[i + 1] : NULL,
				   1e-12 * size);
		add_spans(&out, spans, &segments[i], ends, some, last);
		for (int k = first; k < out.count; k++)
			spans[k].segment = i;
	}
	out.nodes = build_tree(arena, spans, out.count, size);
	return out;
}

double lathe_span_at_height(const LatheSpan *span, double y)
{
	double lo = 0, hi = 1, s = 0.5;
	bool rises = span->height[LATHE_DEGREE] > span->height[0];
	const double *v = span->v;
	for (int i = 0; i < 60; i++) {
		double value = v[0] - y + s * (v[1] + s * (v[2] + s * v[3])),
		       slope = v[1] + s * (2 * v[2] + s * 3 * v[3]);
		*((value > 0) == rises ? &hi : &lo) = s;
		double next = s - value / slope;
		if (!(next >= lo && next <= hi))
			next = 0.5 * (lo + hi);
		double step = fabs(next - s);
		s = next;
		if (step < 1e-9)
			break;
	}
	return s;
}
