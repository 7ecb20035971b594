/* The plain solids: sphere, box, cylinder, cone, torus, plane, disc, superellipsoid, ovus. */
#include "lang/build_object.h"

#include "geom/box.h"
#include "geom/cone.h"
#include "geom/disc.h"
#include "geom/ovus.h"
#include "geom/plane.h"
#include "geom/sphere.h"
#include "geom/superellipsoid.h"
#include "geom/torus.h"

static Arena *scene_arena(const Cursor *cursor) { return cursor->context->builder->arena; }

bool build_sphere(Cursor *cursor, Object *object)
{
	Vec3 center;
	double radius;
	if (!cursor_take_vec3(cursor, &center) || !cursor_take_float(cursor, &radius))
		return false;
	const void *data = sphere_create(scene_arena(cursor), center, radius);
	return build_shape_set(cursor, object, &sphere_class, data, NULL);
}

bool build_box(Cursor *cursor, Object *object)
{
	Vec3 corner, opposite;
	if (!cursor_take_vec3(cursor, &corner) || !cursor_take_vec3(cursor, &opposite))
		return false;
	const void *data = box_create(scene_arena(cursor), corner, opposite);
	return build_shape_set(cursor, object, &box_class, data, NULL);
}

static bool finish_cone(Cursor *cursor, Object *object, ConeDesc *desc, const ShapeClass *class)
{
	const char *error = NULL;
	desc->open = cursor_accept_word(cursor, W_open);
	const void *data = cone_create(scene_arena(cursor), desc, &error);
	return build_shape_set(cursor, object, class, data, &error);
}

bool build_cylinder(Cursor *cursor, Object *object)
{
	ConeDesc desc = {0};
	if (!cursor_take_vec3(cursor, &desc.base) || !cursor_take_vec3(cursor, &desc.cap) ||
	    !cursor_take_float(cursor, &desc.base_radius))
		return false;
	desc.cap_radius = desc.base_radius;
	return finish_cone(cursor, object, &desc, &cylinder_class);
}

bool build_cone(Cursor *cursor, Object *object)
{
	ConeDesc desc = {0};
	if (!cursor_take_vec3(cursor, &desc.base) ||
	    !cursor_take_float(cursor, &desc.base_radius) || !cursor_take_vec3(cursor, &desc.cap) ||
	    !cursor_take_float(cursor, &desc.cap_radius))
		return false;
	return finish_cone(cursor, object, &desc, &cone_class);
}

bool build_torus(Cursor *cursor, Object *object)
{
	double major, minor;
	if (!cursor_take_float(cursor, &major) || !cursor_take_float(cursor, &minor))
		return false;
	const void *data = torus_create(scene_arena(cursor), major, minor);
	return build_shape_set(cursor, object, &torus_class, data, NULL);
}

bool build_plane(Cursor *cursor, Object *object)
{
	Vec3 normal;
	double distance;
	const char *error = NULL;
	if (!cursor_take_vec3(cursor, &normal) || !cursor_take_float(cursor, &distance))
		return false;
	const void *data = plane_create(scene_arena(cursor), normal, distance, &error);
	return build_shape_set(cursor, object, &plane_class, data, &error);
}

bool build_disc(Cursor *cursor, Object *object)
{
	DiscDesc desc = {0};
	if (!cursor_take_vec3(cursor, &desc.center) || !cursor_take_vec3(cursor, &desc.normal) ||
	    !cursor_take_float(cursor, &desc.radius))
		return false;
	desc.hole = cursor_optional_float(cursor, 0);
	const void *data = disc_create(scene_arena(cursor), &desc);
	return build_shape_set(cursor, object, &disc_class, data, NULL);
}

bool build_superellipsoid(Cursor *cursor, Object *object)
{
	Vec2 exponents;
	if (!cursor_take_vec2(cursor, &exponents))
		return false;
	const void *data = superellipsoid_create(scene_arena(cursor), exponents.u, exponents.v);
	return build_shape_set(cursor, object, &superellipsoid_class, data, NULL);
}

bool build_ovus(Cursor *cursor, Object *object)
{
	double bottom, top;
	const char *error = NULL;
	if (!cursor_take_float(cursor, &bottom) || !cursor_take_float(cursor, &top))
		return false;
	const void *data = ovus_create(scene_arena(cursor), bottom, top, &error);
	return build_shape_set(cursor, object, &ovus_class, data, &error);
}
