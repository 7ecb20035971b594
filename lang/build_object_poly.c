/* Algebraic surfaces: quadric, cubic, quartic, poly, polynomial. */
#include "lang/build_object.h"

#include "geom/poly.h"

static Arena *scene_arena(const Cursor *cursor) { return cursor->context->builder->arena; }

bool build_quadric(Cursor *cursor, Object *object)
{
	Vec3 square, mixed, linear;
	double constant;
	if (!cursor_take_vec3(cursor, &square) || !cursor_take_vec3(cursor, &mixed) ||
	    !cursor_take_vec3(cursor, &linear) || !cursor_take_float(cursor, &constant))
		return false;
	const double coefficients[10] = {square.x, square.y, square.z, mixed.x, mixed.y,
	                                 mixed.z, linear.x, linear.y, linear.z, constant};
	return build_shape_set(cursor, object, &quadric_class,
			       quadric_create(scene_arena(cursor), coefficients), NULL);
}

static bool finish_poly(Cursor *cursor, Object *object, int order, const double *coefficients)
{
	const char *error = NULL;
	const void *data = poly_create(scene_arena(cursor), order, coefficients, &error);
	return build_shape_set(cursor, object, &poly_class, data, &error);
}

static bool read_poly(Cursor *cursor, Object *object, int order)
{
	int count = poly_term_count(order);
	double *coefficients = ARENA_ARRAY(cursor->context->items, double, count);
	return cursor_take_floats(cursor, coefficients, count) &&
	       finish_poly(cursor, object, order, coefficients);
}

bool build_cubic(Cursor *cursor, Object *object) { return read_poly(cursor, object, 3); }

bool build_quartic(Cursor *cursor, Object *object) { return read_poly(cursor, object, 4); }

static bool take_order(Cursor *cursor, int *order)
{
	if (!cursor_take_int(cursor, order))
		return false;
	if (*order >= POLY_MIN_ORDER && *order <= POLY_MAX_ORDER)
		return true;
	diag_error(cursor->context->diag, cursor->block->where,
		   "the order of a polynomial must be from %d to %d", POLY_MIN_ORDER,
		   POLY_MAX_ORDER);
	while (cursor_peek_numeric(cursor))
		cursor_next(cursor);
	return false;
}

bool build_poly(Cursor *cursor, Object *object)
{
	int order;
	return take_order(cursor, &order) && read_poly(cursor, object, order);
}

/* polynomial { order, xyz(i, j, k): value, ... }: each term comes as an entry of four numbers. */
bool build_polynomial(Cursor *cursor, Object *object)
{
	int order;
	if (!take_order(cursor, &order))
		return false;
	double *coefficients = ARENA_ARRAY(cursor->context->items, double, poly_term_count(order));
	while (cursor_peek_entry(cursor)) {
		double term[4];
		const Node *entry = cursor_next(cursor);
		Cursor inside = cursor_begin(cursor->context, entry);
		if (!cursor_take_floats(&inside, term, 4))
			return false;
		cursor_end(&inside);
		bool small = term[0] >= 0 && term[1] >= 0 && term[2] >= 0 &&
			     term[0] + term[1] + term[2] <= order;
		int index = small ? poly_term_index(order, (int)term[0], (int)term[1], (int)term[2])
				  : -1;
		if (index < 0)
			diag_error(cursor->context->diag, entry->where,
				   "this term exceeds the order %d", order);
		else
			coefficients[index] = term[3];
	}
	return finish_poly(cursor, object, order, coefficients);
}
