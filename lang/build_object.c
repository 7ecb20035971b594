#include "lang/build_object.h"

#include <string.h>

typedef struct ShapeRow {
	Word word;
	ShapeBuilder *build;
} ShapeRow;

static const ShapeRow shape_rows[] = {
	{W_bicubic_patch, build_bicubic_patch},
	{W_blob, build_blob},
	{W_box, build_box},
	{W_cone, build_cone},
	{W_cubic, build_cubic},
	{W_cylinder, build_cylinder},
	{W_difference, build_difference},
	{W_disc, build_disc},
	{W_height_field, build_height_field},
	{W_intersection, build_intersection},
	{W_isosurface, build_isosurface},
	{W_julia_fractal, build_julia_fractal},
	{W_lathe, build_lathe},
	{W_light_group, build_light_group},
	{W_light_source, build_light_source},
	{W_merge, build_merge},
	{W_mesh, build_mesh},
	{W_mesh2, build_mesh2},
	{W_object, build_object_copy},
	{W_ovus, build_ovus},
	{W_parametric, build_parametric},
	{W_plane, build_plane},
	{W_poly, build_poly},
	{W_polygon, build_polygon},
	{W_polynomial, build_polynomial},
	{W_prism, build_prism},
	{W_quadric, build_quadric},
	{W_quartic, build_quartic},
	{W_smooth_triangle, build_smooth_triangle},
	{W_sor, build_sor},
	{W_sphere, build_sphere},
	{W_sphere_sweep, build_sphere_sweep},
	{W_superellipsoid, build_superellipsoid},
	{W_text, build_text},
	{W_torus, build_torus},
	{W_triangle, build_triangle},
	{W_union, build_union},
};

static const ShapeRow *find_row(Word word)
{
	for (size_t i = 0; i < sizeof shape_rows / sizeof *shape_rows; i++)
		if (shape_rows[i].word == word)
			return &shape_rows[i];
	return NULL;
}

bool build_is_object(const Node *node)
{
	if (node->kind == NODE_ITEM)
		return node->value.kind == VALUE_OBJECT;
	return node->kind == NODE_BLOCK && find_row(node->word);
}

const Object *build_object(Context *context, const Node *node)
{
	if (node->kind == NODE_ITEM)
		return node->value.item;
	const ShapeRow *row = find_row(node->word);
	Cursor cursor = cursor_begin(context, node);
	Object *object = ARENA_NEW(context->builder->arena, Object);
	*object = object_default(OBJECT_PRIMITIVE);
	bool good = true;
	const Object *named = cursor_accept_item(&cursor, VALUE_OBJECT);
	if (named)
		*object = *named;
	else
		good = row->build(&cursor, object);
	while (!cursor_at_end(&cursor))
		if (!build_object_modifier(&cursor, object))
			cursor_unexpected(&cursor);
	return good ? object : NULL;
}

static void push_object(Arena *arena, ObjectList *list, const Object *object)
{
	if (list->count == list->capacity) {
		list->capacity = list->capacity ? 2 * list->capacity : 4;
		const Object **larger = ARENA_ARRAY(arena, const Object *, list->capacity);
		if (list->count)
			memcpy(larger, list->items, (size_t)list->count * sizeof *larger);
		list->items = larger;
	}
	list->items[list->count++] = object;
}

void build_object_list(Cursor *cursor, ObjectList *list)
{
	while (cursor->at && build_is_object(cursor->at)) {
		const Object *object = build_object(cursor->context, cursor_next(cursor));
		if (object)
			push_object(cursor->context->builder->arena, list, object);
	}
}

void build_object_adopt(Cursor *cursor, Object *object, const ObjectList *list)
{
	int depth = 0;
	for (int i = 0; i < list->count; i++)
		if (list->items[i]->depth > depth)
			depth = list->items[i]->depth;
	object->children = list->items;
	object->child_count = list->count;
	object->depth = depth + 1;
	if (object->depth <= OBJECT_DEPTH_MAX)
		return;
	diag_error(cursor->context->diag, cursor->block->where, "objects nested more than %d deep",
		   OBJECT_DEPTH_MAX);
	object->child_count = object->depth = 0;
}

bool build_shape_set(Cursor *cursor, Object *object, const ShapeClass *class, const void *data,
		     const char *const *error)
{
	if (!data) {
		diag_error(cursor->context->diag, cursor->block->where, "%s: %s",
			   word_text(cursor->block->word),
			   error && *error ? *error : "cannot be made");
		return false;
	}
	object->class = class;
	object->data = data;
	return true;
}
