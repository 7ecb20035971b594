/*
 * Four kinds of interpolation, by components, as POV-Ray gives them (measured):
 *
 *     linear     between neighbours;
 *     quadratic  the parabola through the ends of the interval and the point before it (the first
 * interval: after it); cubic      Hermite's cubic whose tangents are the mean of the two secants'
 * slopes at a point; it is defined between the second and the last point but one only; natural the
 * cubic with continuous second derivative, which is 0 at both ends.
 *
 * Outside its range every spline keeps the value at that end.
 */
#include "lang/spline.h"

#include <string.h>

#include "lang/cursor.h"

/* The last point at or before `at`, limited so that another follows. */
static int interval_of(const Spline *spline, double at)
{
	int low = 0, high = spline->count - 1;
	while (high - low > 1) {
		int middle = (low + high) / 2;
		if (spline->points[middle].at <= at)
			low = middle;
		else
			high = middle;
	}
	return low;
}

static double linear_value(const SplinePoint *p, double at, int k)
{
	double s = (at - p[0].at) / (p[1].at - p[0].at);
	return p[0].value[k] + s * (p[1].value[k] - p[0].value[k]);
}

/* The parabola through p[0], p[1], p[2] (Lagrange). */
static double quadratic_value(const SplinePoint *p, double at, int k)
{
	double a = at - p[0].at, b = at - p[1].at, c = at - p[2].at;
	double ab = p[0].at - p[1].at, bc = p[1].at - p[2].at, ac = p[0].at - p[2].at;
	return p[0].value[k] * b * c / (ab * ac) - p[1].value[k] * a * c / (ab * bc) +
	       p[2].value[k] * a * b / (ac * bc);
}

static double secant(const SplinePoint *p, int k)
{
	return (p[1].value[k] - p[0].value[k]) / (p[1].at - p[0].at);
}

/* Between p[0] and p[1]; p[-1] and p[2] exist. */
static double cubic_value(const SplinePoint *p, double at, int k)
{
	double h = p[1].at - p[0].at, s = (at - p[0].at) / h;
	double start = h * (secant(p - 1, k) + secant(p, k)) / 2,
	       end = h * (secant(p, k) + secant(p + 1, k)) / 2;
	double rise = p[1].value[k] - p[0].value[k];
	return p[0].value[k] +
	       s * (start + s * (3 * rise - 2 * start - end + s * (start + end - 2 * rise)));
}

static double natural_value(const SplinePoint *p, double at, int k)
{
	double h = p[1].at - p[0].at, a = (p[1].at - at) / h, b = (at - p[0].at) / h;
	return a * p[0].value[k] + b * p[1].value[k] +
	       ((a * a * a - a) * p[0].second[k] + (b * b * b - b) * p[1].second[k]) * h * h / 6;
}

static double interval_value(const Spline *spline, int i, double at, int k)
{
	const SplinePoint *p = &spline->points[i];
	switch (spline->kind) {
	case SPLINE_QUADRATIC:
		return spline->count < 3 ? linear_value(p, at, k)
					 : quadratic_value(i > 0 ? p - 1 : p, at, k);
	case SPLINE_CUBIC:
		return cubic_value(p, at, k);
	case SPLINE_NATURAL:
		return natural_value(p, at, k);
	default:
		return linear_value(p, at, k);
	}
}

void spline_eval(const Spline *spline, double at, double out[5])
{
	int first = 0, last = spline->count - 1;
	if (spline->kind == SPLINE_CUBIC && last > 0) {
		first = 1;
		last = last > 1 ? last - 1 : last;
	}
	const SplinePoint *points = spline->points;
	const SplinePoint *end = !(at > points[first].at) ? &points[first]
				 : at >= points[last].at  ? &points[last]
							  : NULL;
	int i = end ? 0 : interval_of(spline, at);
	for (int k = 0; k < 5; k++)
		out[k] = k >= spline->size ? 0
			 : end             ? end->value[k]
					   : interval_value(spline, i, at, k);
}

/* Second derivatives of the natural spline: a tridiagonal system, 0 at both ends, solved forward
 * and back. */
static void solve_natural(SplinePoint *p, int count, int k, double *factor)
{
	p[0].second[k] = factor[0] = 0;
	for (int i = 1; i < count - 1; i++) {
		double before = p[i].at - p[i - 1].at, after = p[i + 1].at - p[i].at;
		double pivot = 2 * (before + after) - before * factor[i - 1];
		factor[i] = after / pivot;
		p[i].second[k] = (6 * (secant(&p[i], k) - secant(&p[i - 1], k)) -
				  before * p[i - 1].second[k]) /
				 pivot;
	}
	p[count - 1].second[k] = 0;
	for (int i = count - 2; i > 0; i--)
		p[i].second[k] -= factor[i] * p[i + 1].second[k];
}

/* Points as they are read. */
typedef struct SplineDraft {
	Context *context;
	SplineKind kind;
	int size, count, capacity;
	SplinePoint *points;
} SplineDraft;

/* Keeps the points sorted; of two at the same place the first stays. */
static void draft_add(SplineDraft *draft, SplinePoint point)
{
	if (draft->count == draft->capacity) {
		draft->capacity = draft->capacity ? draft->capacity * 2 : 8;
		SplinePoint *points = ARENA_ARRAY(draft->context->parse, SplinePoint,
						  draft->capacity);
		for (int i = 0; i < draft->count; i++)
			points[i] = draft->points[i];
		draft->points = points;
	}
	int at = draft->count;
	while (at > 0 && draft->points[at - 1].at > point.at)
		at--;
	if (at > 0 && draft->points[at - 1].at == point.at)
		return;
	memmove(&draft->points[at + 1], &draft->points[at],
		sizeof point * (size_t)(draft->count - at));
	draft->points[at] = point;
	draft->count++;
}

static void draft_take_point(SplineDraft *draft, Cursor *cursor)
{
	SplinePoint point = {.at = 0};
	if (!cursor_take_float(cursor, &point.at))
		return;
	if (!cursor_peek_numeric(cursor)) {
		cursor_expected(cursor, "a point of the spline");
		return;
	}
	Value value = cursor_next(cursor)->value;
	if (value.kind == VALUE_COLOR || value.size > draft->size)
		draft->size = value.kind == VALUE_COLOR ? 5 : value.size;
	for (int k = 0; k < draft->size; k++)
		point.value[k] = value.kind == VALUE_FLOAT ? value.number : value.v[k];
	draft_add(draft, point);
}

/* False when the word is no kind of spline. */
static bool kind_of(Word word, SplineKind *kind)
{
	switch (word) {
	case W_linear_spline: *kind = SPLINE_LINEAR; return true;
	case W_quadratic_spline: *kind = SPLINE_QUADRATIC; return true;
	case W_cubic_spline: *kind = SPLINE_CUBIC; return true;
	case W_natural_spline: *kind = SPLINE_NATURAL; return true;
	default: return false;
	}
}

static bool draft_take_kind(SplineDraft *draft, Cursor *cursor)
{
	if (!kind_of(cursor_peek_word(cursor), &draft->kind))
		return false;
	cursor_next(cursor);
	return true;
}

static bool draft_take_spline(SplineDraft *draft, Cursor *cursor)
{
	if (!cursor_peek_item(cursor, VALUE_SPLINE))
		return false;
	const Spline *base = cursor_next(cursor)->value.spline;
	draft->kind = base->kind;
	draft->size = base->size;
	for (int i = 0; i < base->count; i++)
		draft_add(draft, base->points[i]);
	return true;
}

static const Spline *draft_finish(SplineDraft *draft)
{
	Context *context = draft->context;
	Arena *arena = context->builder->arena;
	Spline *spline = ARENA_NEW(arena, Spline);
	double *factor = ARENA_ARRAY(context->parse, double, draft->count);
	for (int k = 0; k < draft->size; k++)
		solve_natural(draft->points, draft->count, k, factor);
	spline->kind = draft->kind;
	spline->size = draft->size;
	spline->count = draft->count;
	spline->points = arena_copy(arena, draft->points,
				    sizeof *draft->points * (size_t)draft->count);
	return spline;
}

Value spline_build(Context *context, const Node *block)
{
	Cursor cursor = cursor_begin(context, block);
	SplineDraft draft = {.context = context, .kind = SPLINE_LINEAR, .size = 2};
	while (!cursor_at_end(&cursor)) {
		if (draft_take_kind(&draft, &cursor) || draft_take_spline(&draft, &cursor))
			continue;
		if (cursor_peek_float(&cursor))
			draft_take_point(&draft, &cursor);
		else
			cursor_unexpected(&cursor);
	}
	if (draft.count == 0) {
		diag_error(context->diag, block->where, "a spline needs at least one point");
		return value_none();
	}
	return (Value){.kind = VALUE_SPLINE, .spline = draft_finish(&draft)};
}

Value spline_as(Context *context, Value spline, Word kind, Location where)
{
	SplineKind wanted;
	if (spline.kind != VALUE_SPLINE || !kind_of(kind, &wanted)) {
		diag_error(context->diag, where, "unexpected '%s'", word_text(kind));
		return spline;
	}
	if (spline.spline->kind == wanted)
		return spline;
	Spline *copy = arena_copy(context->builder->arena, spline.spline, sizeof *copy);
	copy->kind = wanted;
	return (Value){.kind = VALUE_SPLINE, .spline = copy};
}
