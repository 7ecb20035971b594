/* Shapes from curves and letters: prism, lathe, sor, sphere_sweep, text. */
#include "lang/build_object.h"

#include "geom/sphere_sweep.h"
#include "geom/sweep.h"
#include "lang/files.h"

static Arena *scene_arena(const Cursor *cursor) { return cursor->context->builder->arena; }

/* Where it is none, what it counts makes no sense and is passed over. */
static bool take_count(Cursor *cursor, int *count)
{
	bool good = cursor_take_int(cursor, count);
	if (!good)
		cursor->at = NULL;
	return good;
}

/* A count, then so many points. */
static const Vec2 *take_points(Cursor *cursor, int *count)
{
	if (!take_count(cursor, count))
		return NULL;
	int capacity = 0;
	for (const Node *node = cursor->at; node && node->kind == NODE_VALUE; node = node->next)
		capacity++;
	if (*count < 1 || *count > capacity) {
		cursor_expected(cursor,
				*count < 1 ? "at least one point" : "as many points as announced");
		return NULL;
	}
	Vec2 *points = ARENA_ARRAY(scene_arena(cursor), Vec2, *count);
	for (int i = 0; i < *count; i++)
		if (!cursor_take_vec2(cursor, &points[i]))
			return NULL;
	return points;
}

static CurveKind read_kind(Cursor *cursor, CurveKind kind)
{
	if (cursor_accept_word(cursor, W_linear_spline))
		return CURVE_LINEAR;
	if (cursor_accept_word(cursor, W_quadratic_spline))
		return CURVE_QUADRATIC;
	if (cursor_accept_word(cursor, W_cubic_spline))
		return CURVE_CUBIC;
	if (cursor_accept_word(cursor, W_bezier_spline))
		return CURVE_BEZIER;
	return kind;
}

bool build_prism(Cursor *cursor, Object *object)
{
	PrismDesc desc = {.kind = CURVE_LINEAR};
	const char *error = NULL;
	for (;;) {
		const Node *before = cursor->at;
		desc.kind = read_kind(cursor, desc.kind);
		if (cursor_accept_word(cursor, W_conic_sweep))
			desc.conic = true;
		else if (cursor_accept_word(cursor, W_linear_sweep))
			desc.conic = false;
		if (cursor->at == before)
			break;
	}
	if (!cursor_take_float(cursor, &desc.low) || !cursor_take_float(cursor, &desc.high) ||
	    !(desc.points = take_points(cursor, &desc.point_count)))
		return false;
	desc.open = cursor_accept_word(cursor, W_open);
	return build_shape_set(cursor, object, &prism_class,
			       prism_create(scene_arena(cursor), &desc, &error), &error);
}

bool build_lathe(Cursor *cursor, Object *object)
{
	LatheDesc desc = {.kind = read_kind(cursor, CURVE_LINEAR)};
	const char *error = NULL;
	if (!(desc.points = take_points(cursor, &desc.point_count)))
		return false;
	return build_shape_set(cursor, object, &lathe_class,
			       lathe_create(scene_arena(cursor), &desc, &error), &error);
}

bool build_sor(Cursor *cursor, Object *object)
{
	SorDesc desc = {0};
	const char *error = NULL;
	if (!(desc.points = take_points(cursor, &desc.point_count)))
		return false;
	desc.open = cursor_accept_word(cursor, W_open);
	return build_shape_set(cursor, object, &sor_class,
			       sor_create(scene_arena(cursor), &desc, &error), &error);
}

static bool take_spheres(Cursor *cursor, SphereSweepDesc *desc)
{
	if (!take_count(cursor, &desc->count))
		return false;
	int capacity = 0;
	for (const Node *node = cursor->at; node && node->kind == NODE_VALUE; node = node->next)
		capacity++;
	if (desc->count < 1 || desc->count > capacity)
		return cursor_expected(cursor, "as many spheres as announced");
	Vec3 *centers = ARENA_ARRAY(scene_arena(cursor), Vec3, desc->count);
	double *radii = ARENA_ARRAY(scene_arena(cursor), double, desc->count);
	desc->centers = centers;
	desc->radii = radii;
	for (int i = 0; i < desc->count; i++)
		if (!cursor_take_vec3(cursor, &centers[i]) || !cursor_take_float(cursor, &radii[i]))
			return false;
	return true;
}

bool build_sphere_sweep(Cursor *cursor, Object *object)
{
	SphereSweepDesc desc = {.kind = SPHERE_SWEEP_LINEAR, .tolerance = 1e-6};
	const char *error = NULL;
	if (cursor_accept_word(cursor, W_cubic_spline))
		desc.kind = SPHERE_SWEEP_CUBIC;
	else if (cursor_accept_word(cursor, W_b_spline))
		desc.kind = SPHERE_SWEEP_B_SPLINE;
	else
		cursor_accept_word(cursor, W_linear_spline);
	if (!take_spheres(cursor, &desc))
		return false;
	if (cursor_accept_word(cursor, W_tolerance) && !cursor_take_float(cursor, &desc.tolerance))
		return false;
	const void *data = sphere_sweep_create(scene_arena(cursor), &desc, &error);
	return build_shape_set(cursor, object, &sphere_sweep_class, data, &error);
}

/* text { internal n ... }: POV-Ray keeps these fonts in its program; they stand beside its includes
 * as files as well. */
static bool take_internal_font(Cursor *cursor, const char **font)
{
	static const char *const fonts[] = {"povlogo", "timrom", "cyrvetic", "crystal"};
	int number;
	if (!cursor_take_int(cursor, &number))
		return false;
	*font = fonts[number >= 0 && number < 4 ? number : 0];
	return true;
}

/* The font's file, whose name may lack its ending; NULL after a report. */
static const char *find_font(Context *context, const char *font, Location where)
{
	const char *path = files_find(context, font);
	if (!path)
		path = files_find(context, arena_printf(context->items, "%s.ttf", font));
	if (!path)
		path = files_find(context, arena_printf(context->items, "%s.ttc", font));
	if (!path)
		diag_error(context->diag, where, "cannot find the font '%s'", font);
	return path && files_may_read(context, path, where) ? path : NULL;
}

/* text { ttf "font" "letters" thickness, offset } */
bool build_text(Cursor *cursor, Object *object)
{
	TextDesc desc = {0};
	Vec3 offset = {0, 0, 0};
	const char *error = NULL, *font = NULL;
	bool internal = cursor_accept_word(cursor, W_internal);
	if (!internal)
		cursor_accept_word(cursor, W_ttf);
	Location where = cursor_where(cursor);
	if (!(internal ? take_internal_font(cursor, &font) : cursor_take_string(cursor, &font)))
		return false;
	if (!cursor_take_string(cursor, &desc.text) ||
	    !cursor_take_float(cursor, &desc.thickness) || !cursor_take_vec3(cursor, &offset))
		return false;
	desc.font_path = find_font(cursor->context, font, where);
	if (!desc.font_path)
		return false;
	desc.offset = (Vec2){offset.x, offset.y};
	return build_shape_set(cursor, object, &text_class,
			       text_create(scene_arena(cursor), &desc, &error), &error);
}
