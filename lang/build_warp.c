/* warp { ... } */
#include <math.h>

#include "lang/build_pattern.h"
#include "surface/warp.h"

static void take_turbulence(Cursor *cursor, Warp *warp)
{
	Turbulence t = turbulence_default();
	double octaves = t.octaves;
	cursor_take_vec3(cursor, &t.amount);
	while (!cursor_at_end(cursor)) {
		if (cursor_accept_word(cursor, W_octaves))
			cursor_take_float(cursor, &octaves);
		else if (cursor_accept_word(cursor, W_omega))
			cursor_take_float(cursor, &t.omega);
		else if (cursor_accept_word(cursor, W_lambda))
			cursor_take_float(cursor, &t.lambda);
		else
			break;
	}
	t.octaves = turbulence_octaves(octaves);
	warp->kind = WARP_TURBULENCE;
	warp->u.turbulence = t;
}

/* The axis and the width of a vector along one axis; false when it is along none. */
static bool along_axis(Vec3 v, int *axis, double *width)
{
	int found = 0;
	for (int i = 0; i < 3; i++) {
		if (vec3_axis(v, i) == 0)
			continue;
		*axis = i;
		*width = vec3_axis(v, i);
		found++;
	}
	return found == 1;
}

static bool take_repeat(Cursor *cursor, Warp *warp)
{
	WarpRepeat repeat = {.width = 1};
	Vec3 along = {0, 0, 0};
	if (!cursor_take_vec3(cursor, &along))
		return false;
	if (!along_axis(along, &repeat.axis, &repeat.width)) {
		diag_error(cursor->context->diag, cursor->last->where,
			   "repeat takes a vector along one axis");
		return false;
	}
	while (!cursor_at_end(cursor)) {
		if (cursor_accept_word(cursor, W_offset))
			cursor_take_vec3(cursor, &repeat.offset);
		else if (cursor_accept_word(cursor, W_flip))
			cursor_take_vec3(cursor, &repeat.flip);
		else
			break;
	}
	warp->kind = WARP_REPEAT;
	warp->u.repeat = repeat;
	return true;
}

/* One word of a black hole; false when the next is none. */
static bool take_black_hole_item(Cursor *cursor, WarpBlackHole *hole)
{
	if (cursor_accept_word(cursor, W_strength))
		cursor_take_float(cursor, &hole->strength);
	else if (cursor_accept_word(cursor, W_falloff))
		cursor_take_float(cursor, &hole->falloff);
	else if (cursor_accept_word(cursor, W_inverse))
		hole->inverse = cursor_optional_bool(cursor);
	else if (cursor_accept_word(cursor, W_type))
		cursor_take_int(cursor, &hole->type);
	else if (cursor_accept_word(cursor, W_repeat))
		hole->repeats = cursor_take_vec3(cursor, &hole->repeat);
	else if (cursor_accept_word(cursor, W_turbulence))
		hole->uncertain = cursor_take_vec3(cursor, &hole->uncertainty);
	else
		return false;
	return true;
}

static void take_black_hole(Cursor *cursor, Warp *warp)
{
	WarpBlackHole hole = warp_black_hole_default();
	if (cursor_take_vec3(cursor, &hole.center))
		cursor_take_float(cursor, &hole.radius);
	while (!cursor_at_end(cursor) && take_black_hole_item(cursor, &hole))
		;
	warp->kind = WARP_BLACK_HOLE;
	warp->u.black_hole = hole;
}

static void take_mapping(Cursor *cursor, Warp *warp)
{
	WarpMapping mapping = warp_mapping_default();
	if (warp->kind == WARP_PLANAR && cursor_accept_vec3(cursor, &mapping.orientation))
		cursor_take_float(cursor, &mapping.distance);
	while (!cursor_at_end(cursor)) {
		if (cursor_accept_word(cursor, W_orientation))
			cursor_take_vec3(cursor, &mapping.orientation);
		else if (cursor_accept_word(cursor, W_dist_exp))
			cursor_take_float(cursor, &mapping.distance);
		else if (cursor_accept_word(cursor, W_major_radius))
			cursor_take_float(cursor, &mapping.major_radius);
		else
			break;
	}
	mapping.orientation = vec3_normalize(mapping.orientation);
	warp->u.mapping = mapping;
}

static WarpKind mapping_kind(Word word)
{
	switch (word) {
	case W_planar: return WARP_PLANAR;
	case W_cylindrical: return WARP_CYLINDRICAL;
	case W_spherical: return WARP_SPHERICAL;
	case W_toroidal: return WARP_TOROIDAL;
	default: return WARP_CUBIC;
	}
}

/* False after a reported error. */
static bool take_warp(Cursor *cursor, Warp *warp)
{
	Word word = cursor_peek_word(cursor);
	switch (word) {
	case W_turbulence: cursor_next(cursor); take_turbulence(cursor, warp); return true;
	case W_repeat: cursor_next(cursor); return take_repeat(cursor, warp);
	case W_black_hole: cursor_next(cursor); take_black_hole(cursor, warp); return true;
	case W_planar: case W_cylindrical: case W_spherical: case W_toroidal: case W_cubic:
		cursor_next(cursor);
		warp->kind = mapping_kind(word);
		take_mapping(cursor, warp);
		return true;
	default:
		return cursor_expected(cursor, "a kind of warp");
	}
}

void build_warp(Context *context, const Node *block, Pattern *pattern)
{
	Cursor cursor = cursor_begin(context, block);
	Warp warp = {.kind = WARP_CUBIC};
	if (take_warp(&cursor, &warp))
		warp_add(context->builder->arena, &pattern->warps, &warp);
	cursor_end(&cursor);
}
