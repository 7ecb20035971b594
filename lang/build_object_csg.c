/* union, intersection, difference, merge, light_group and object { }. */
#include "lang/build_object.h"

static bool build_csg(Cursor *cursor, Object *object, ObjectKind kind)
{
	ObjectList list = {0};
	object->kind = kind;
	build_object_list(cursor, &list);
	build_object_adopt(cursor, object, &list);
	return true;
}

bool build_union(Cursor *cursor, Object *object) { return build_csg(cursor, object, OBJECT_UNION); }

bool build_intersection(Cursor *cursor, Object *object)
{
	return build_csg(cursor, object, OBJECT_INTERSECTION);
}

bool build_difference(Cursor *cursor, Object *object)
{
	return build_csg(cursor, object, OBJECT_DIFFERENCE);
}

bool build_merge(Cursor *cursor, Object *object) { return build_csg(cursor, object, OBJECT_MERGE); }

bool build_light_group(Cursor *cursor, Object *object)
{
	return build_csg(cursor, object, OBJECT_LIGHT_GROUP);
}

/* object { Name ... } arrives here only when there is a shape with braces inside. */
bool build_object_copy(Cursor *cursor, Object *object)
{
	if (!cursor->at || !build_is_object(cursor->at))
		return cursor_expected(cursor, "an object");
	const Object *inner = build_object(cursor->context, cursor_next(cursor));
	if (!inner)
		return false;
	*object = *inner;
	return true;
}
