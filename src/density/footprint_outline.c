/*
 * Stretches are chosen so that the sum of their costs is least: the squares of the nodes' distances
 * from the stretch's line, beside those that chance makes, and a price for each stretch (minimum
 * description length; Bellman's recursion). Then each line is moved outwards until there is room
 * for what its nodes miss.
 */
#include "density/footprint_outline.h"

#include <math.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

#include "base/arena.h"

/* Of a node across a straight border, in spaces. */
static const double variance = 0.1;
/* Of a stretch, where a node costs 1 on the average: two numbers more, for some twenty nodes, by
 * Schwarz's criterion 2 ln 20. */
static const double price = 6;
/* Longer ones are two in a line. */
enum { MOST_NODES = 128 };

/* Sums over the nodes before one: weight, weighted places, their products; and the way's length. */
typedef struct Sums { double w, x, y, xx, xy, yy, length; } Sums;

typedef struct Way {
	const OutlineNode **nodes; /* the last is the first again */
	Sums *sums;
	int *from;                 /* where the stretch that ends at a node starts */
	double *cost;
	int count;
} Way;

static double distance_of(const OutlineNode *a, const OutlineNode *b)
{
	return hypot(b->at[0] - a->at[0], b->at[1] - a->at[1]);
}

static void set_sums(Way *way)
{
	const double *origin = way->nodes[0]->at;
	way->sums[0] = (Sums){0, 0, 0, 0, 0, 0, 0};
	for (int i = 0; i < way->count; i++) {
		const OutlineNode *n = way->nodes[i];
		Sums s = way->sums[i];
		double x = n->at[0] - origin[0], y = n->at[1] - origin[1], w = 1 / n->space;
		double step = i + 1 < way->count ? distance_of(n, way->nodes[i + 1]) : 0;
		way->sums[i + 1] = (Sums){s.w + w,          s.x + w * x,      s.y + w * y,
					  s.xx + w * x * x, s.xy + w * x * y, s.yy + w * y * y,
					  s.length + step};
	}
}

/* The nodes' mean, and their squares and product about it. */
typedef struct Scatter { double x, y, xx, xy, yy; } Scatter;

static Scatter scatter_of(const Way *way, int first, int last)
{
	const Sums *a = &way->sums[first], *b = &way->sums[last + 1];
	double w = b->w - a->w, x = (b->x - a->x) / w, y = (b->y - a->y) / w;
	return (Scatter){x, y, b->xx - a->xx - w * x * x, b->xy - a->xy - w * x * y,
			 b->yy - a->yy - w * y * y};
}

/* Infinite where the way turns back. */
static double stretch_cost(const Way *way, int first, int last)
{
	static const double least_advance = 0.6; /* of the way's length */
	double length = way->sums[last].length - way->sums[first].length;
	if (last - first > 1 &&
	    distance_of(way->nodes[first], way->nodes[last]) < least_advance * length)
		return INFINITY;
	Scatter s = scatter_of(way, first, last);
	double across = 0.5 * (s.xx + s.yy - hypot(s.xx - s.yy, 2 * s.xy));
	return fmax(0, across) / variance + price;
}

static void find_stretches(Way *way)
{
	set_sums(way);
	way->cost[0] = 0;
	for (int last = 1; last < way->count; last++) {
		way->cost[last] = INFINITY;
		for (int first = last - 1; first >= 0 && last - first < MOST_NODES; first--) {
			double cost = way->cost[first] + stretch_cost(way, first, last);
			if (cost < way->cost[last]) {
				way->cost[last] = cost;
				way->from[last] = first;
			}
		}
	}
}

/* ---- lines ---- */

/* A stretch: the line normal . x = offset, outwards of its nodes. */
typedef struct Stretch {
	int first, last;
	double along[2], normal[2], offset;
} Stretch;

static double dot(const double a[2], const double b[2]) { return a[0] * b[0] + a[1] * b[1]; }

static void set_direction(const Way *way, Stretch *t)
{
	Scatter s = scatter_of(way, t->first, t->last);
	double angle = 0.5 * atan2(2 * s.xy, s.xx - s.yy);
	const double *a = way->nodes[t->first]->at, *b = way->nodes[t->last]->at;
	double sign = cos(angle) * (b[0] - a[0]) + sin(angle) * (b[1] - a[1]) < 0 ? -1 : 1;
	t->along[0] = sign * cos(angle);
	t->along[1] = sign * sin(angle);
	t->normal[0] = t->along[1];
	t->normal[1] = -t->along[0];
}

/* The mean of the way's edges, and outwards from there. */
static void set_offset(const Way *way, Stretch *t)
{
	static const double most = 0.8; /* spaces of a node */
	double length = 0, level = 0, missing = 0, space = 0;
	for (int i = t->first; i <= t->last; i++) {
		const OutlineNode *a = way->nodes[i], *b = way->nodes[i < t->last ? i + 1 : i];
		double step = dot(t->along, b->at) - dot(t->along, a->at);
		length += step;
		level += 0.5 * step * (dot(t->normal, a->at) + dot(t->normal, b->at));
		missing += a->missing * (i == t->first || i == t->last ? 0.5 : 1);
		space += a->space / (t->last - t->first + 1);
	}
	t->offset = level / length + fmin(missing / length, most * sqrt(space));
}

/* Where the line is at a node. */
static void foot_of(const Stretch *t, const OutlineNode *node, double out[2])
{
	double off = t->offset - dot(t->normal, node->at);
	for (int k = 0; k < 2; k++)
		out[k] = node->at[k] + off * t->normal[k];
}

/* Two stretches' lines meet, or come as near as may be to the node that they share. */
static void corner_of(const Stretch *a, const Stretch *b, const OutlineNode *node, double out[2])
{
	static const double most = 3; /* points' distances from the node */
	double sine = a->along[0] * b->along[1] - a->along[1] * b->along[0], one[2], two[2];
	foot_of(a, node, one);
	foot_of(b, node, two);
	double way = (b->offset - dot(b->normal, one)) / dot(b->normal, a->along);
	for (int k = 0; k < 2; k++)
		out[k] = one[k] + way * a->along[k];
	if (!(fabs(sine) > 0.1) ||
	    hypot(out[0] - node->at[0], out[1] - node->at[1]) > most * sqrt(node->space))
		for (int k = 0; k < 2; k++)
			out[k] = 0.5 * (one[k] + two[k]);
}

/* Nodes between the corners: on the line, none before the last. */
static void set_inner(const Way *way, const Stretch *t, double (*out)[2])
{
	double last = dot(t->along, out[t->first]), end = dot(t->along, out[t->last]);
	for (int i = t->first + 1; i < t->last; i++) {
		double at = fmin(fmax(dot(t->along, way->nodes[i]->at), last), fmax(end, last));
		for (int k = 0; k < 2; k++)
			out[i][k] = at * t->along[k] + t->offset * t->normal[k];
		last = at;
	}
}

/* Stretches from the last node back to the first. */
static int take_stretches(const Way *way, Stretch *stretches)
{
	int count = 0;
	for (int last = way->count - 1; last > 0; last = way->from[last]) {
		Stretch *t = &stretches[count++];
		t->first = way->from[last];
		t->last = last;
		set_direction(way, t);
		set_offset(way, t);
	}
	return count;
}

/* ---- the whole ---- */

static Way make_way(int count)
{
	size_t room = (size_t)count + 2;
	return (Way){memory_alloc(sizeof(OutlineNode *) * room), memory_alloc(sizeof(Sums) * room),
		     memory_alloc(sizeof(int) * room), memory_alloc(sizeof(double) * room),
		     count + 1};
}

static void start_at(Way *way, const OutlineNode *nodes, int start)
{
	int count = way->count - 1;
	for (int i = 0; i <= count; i++)
		way->nodes[i] = &nodes[(start + i) % count];
}

/* An end of a stretch that hardly depends on where the way was taken to start. */
static int far_end(const Way *way)
{
	int last = way->count - 1;
	while (way->from[last] > way->count / 2)
		last = way->from[last];
	return way->from[last] > 0 ? way->from[last] : last % (way->count - 1);
}

void footprint_outline(const OutlineNode *nodes, int count, double (*out)[2])
{
	Way way = make_way(count);
	start_at(&way, nodes, 0);
	find_stretches(&way);
	int start = far_end(&way);
	start_at(&way, nodes, start);
	find_stretches(&way);
	Stretch *stretches = memory_alloc(sizeof *stretches * ((size_t)count + 1));
	double (*places)[2] = memory_alloc(sizeof *places * ((size_t)count + 1));
	int found = take_stretches(&way, stretches);
	for (int i = 0; i < found; i++) { /* the next on the way is the one before */
		const Stretch *t = &stretches[i], *next = &stretches[(i + found - 1) % found];
		corner_of(t, next, way.nodes[t->last], places[t->last]);
		memcpy(places[t->last % count], places[t->last], sizeof *places);
	}
	for (int i = 0; i < found; i++)
		set_inner(&way, &stretches[i], places);
	for (int i = 0; i < count; i++)
		memcpy(out[(start + i) % count], places[i], sizeof *out);
	free(places);
	free(stretches);
	free(way.nodes);
	free(way.sums);
	free(way.from);
	free(way.cost);
}
