/*
 * Objects: shapes by a table (a row per word), CSG, lights and light groups, and the modifiers that
 * all of them take. A new shape is one row in build_object.c and one function with the signature
 * below.
 */
#ifndef LANG_BUILD_OBJECT_H
#define LANG_BUILD_OBJECT_H

#include "lang/context.h"
#include "lang/cursor.h"
#include "scene/object.h"

/* True for what build_object takes: a shape's block or an object's name. */
bool build_is_object(const Node *node);
/* An object in the scene arena; NULL after a reported error. */
const Object *build_object(Context *context, const Node *node);

/* A growing list of objects in the scene arena. */
typedef struct ObjectList {
	const Object **items;
	int count, capacity;
} ObjectList;

/* Takes every object that comes next. */
void build_object_list(Cursor *cursor, ObjectList *list);
/* Makes the list the children of an object; reports nesting beyond what flattening can take. */
void build_object_adopt(Cursor *cursor, Object *object, const ObjectList *list);

/* Takes one modifier if one is next; false when none is. */
bool build_object_modifier(Cursor *cursor, Object *object);

/* A shape's own words: reads them and fills in the object, which is a default primitive at first.
 * False after a reported error. */
typedef bool ShapeBuilder(Cursor *cursor, Object *object);

ShapeBuilder build_sphere, build_box, build_cylinder, build_cone, build_torus, build_plane,
	build_disc, build_superellipsoid, build_ovus, build_quadric, build_cubic, build_quartic,
	build_poly, build_polynomial, build_triangle, build_smooth_triangle, build_mesh,
	build_mesh2, build_bicubic_patch, build_polygon, build_height_field, build_prism,
	build_lathe, build_sor, build_text, build_sphere_sweep, build_blob, build_isosurface,
	build_parametric, build_julia_fractal, build_union, build_intersection, build_difference,
	build_merge, build_object_copy, build_light_source, build_light_group;

/* What a create function answered: sets class and data, or reports its error at the block. The
 * error comes by pointer, as arguments are worked out in any order; NULL where there is none. */
bool build_shape_set(Cursor *cursor, Object *object, const ShapeClass *class, const void *data,
		     const char *const *error);

#endif
