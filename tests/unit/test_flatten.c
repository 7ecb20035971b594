/* Object trees to shapes in world space: transforms, inheritance, CSG, lights. */
#include "scene/flatten.h"

#include "check.h"
#include "geom/box.h"
#include "geom/csg.h"
#include "geom/plane.h"
#include "geom/sphere.h"

static Arena *arena;

static Object *new_object(ObjectKind kind)
{
	Object *object = ARENA_NEW(arena, Object);
	*object = object_default(kind);
	return object;
}

static Object *new_sphere(double x)
{
	Object *object = new_object(OBJECT_PRIMITIVE);
	object->class = &sphere_class;
	object->data = sphere_create(arena, vec3(x, 0, 0), 1);
	return object;
}

static Object *new_csg(ObjectKind kind, const Object *a, const Object *b)
{
	Object *object = new_object(kind);
	const Object **children = ARENA_ARRAY(arena, const Object *, 2);
	children[0] = a;
	children[1] = b;
	object->children = children;
	object->child_count = 2;
	return object;
}

static void move(Object *object, Transform transform)
{
	object_transform(arena, object, &transform);
}

static FlatScene flatten(const Object *object) { return scene_flatten(arena, &object, 1); }

static double first_hit(const Shape *shape, Vec3 from, Vec3 direction)
{
	Ray ray = {from, direction, 1e-6, 1e10};
	Hit hit;
	return shape_nearest(shape, &ray, &hit) ? hit.t : -1;
}

static void test_transforms_compose(void)
{
	Object *a = new_sphere(0), *b = new_sphere(2);
	move(b, transform_translate(vec3(0, 3, 0)));
	Object *both = new_csg(OBJECT_UNION, a, b);
	move(both, transform_rotate(vec3(0, 0, 90)));
	move(both, transform_translate(vec3(0, 0, 10)));
	FlatScene flat = flatten(both);
	CHECK(flat.shape_count == 2);
	/* <2,3,0> turned about z by 90 degrees is <-3,2,0>. */
	CHECK_NEAR(first_hit(flat.shapes[1], vec3(-3, 2, 0), vec3(0, 0, 1)), 9, 1e-9);
	CHECK_NEAR(first_hit(flat.shapes[0], vec3(0, 0, 0), vec3(0, 0, 1)), 9, 1e-9);
}

static void test_difference(void)
{
	Object *cut = new_csg(OBJECT_DIFFERENCE, new_sphere(0), new_sphere(1));
	FlatScene flat = flatten(cut);
	CHECK(flat.shape_count == 1);
	CHECK(flat.shapes[0]->class == &csg_intersection_class);
	/* The second sphere reaches to x = 0: its inside wall is the surface seen from the right.
	 */
	CHECK_NEAR(first_hit(flat.shapes[0], vec3(5, 0, 0), vec3(-1, 0, 0)), 5, 1e-9);
	CHECK(shape_inside(flat.shapes[0], vec3(-0.5, 0, 0)));
	CHECK(!shape_inside(flat.shapes[0], vec3(0.5, 0, 0)));
}

static void test_inverse(void)
{
	Object *both = new_csg(OBJECT_UNION, new_sphere(0), new_sphere(5));
	both->inverse = true;
	FlatScene flat = flatten(both);
	CHECK(flat.shape_count == 1);
	CHECK(!shape_inside(flat.shapes[0], vec3(0, 0, 0)));
	CHECK(!shape_inside(flat.shapes[0], vec3(5, 0, 0)));
	CHECK(shape_inside(flat.shapes[0], vec3(2.5, 0, 0)));
	Object *overlap = new_csg(OBJECT_INTERSECTION, new_sphere(0), new_sphere(1));
	overlap->inverse = true;
	flat = flatten(overlap);
	CHECK(!shape_inside(flat.shapes[0], vec3(0.5, 0, 0)));
	CHECK(shape_inside(flat.shapes[0], vec3(-0.5, 0, 0)));
}

static void test_inheritance(void)
{
	Texture own = {0}, shared = {0};
	Interior glass = {.ior = 1.5f};
	Pigment pigment = {.kind = PIGMENT_COLOR};
	Finish finish = {0};
	own.pigment = shared.pigment = &pigment;
	own.finish = shared.finish = &finish;
	Object *a = new_sphere(0), *b = new_sphere(5);
	a->texture = &own;
	a->flags.no_shadow = ON;
	move(a, transform_scale(vec3(2, 2, 2)));
	Object *both = new_csg(OBJECT_UNION, a, b);
	both->flags.hollow = ON;
	both->interior = &glass;
	move(both, transform_translate(vec3(1, 0, 0)));
	both->texture = &shared;
	both->texture_transform = transform_identity();
	FlatScene flat = flatten(both);
	const Surface *first = flat.shapes[0]->owner, *second = flat.shapes[1]->owner;
	CHECK(first->texture == &own && second->texture == &shared);
	CHECK(first->no_shadow && !second->no_shadow);
	CHECK(first->hollow && second->hollow);
	CHECK(first->interior == &glass && second->interior == &glass);
	/* The first texture was scaled and moved with its sphere; the union's came after the move.
	 */
	CHECK(first->attach && !second->attach);
	if (first->attach)
		CHECK_NEAR(transform_point(first->attach, vec3(1, 0, 0)).x, 3, 1e-12);
	CHECK(first->opaque);
}

static void test_clip_moves_along(void)
{
	const char *error;
	Object *ball = new_sphere(0), *half = new_object(OBJECT_PRIMITIVE);
	half->class = &plane_class;
	half->data = plane_create(arena, vec3(1, 0, 0), 0, &error);
	const Object *clips[1] = {half};
	ball->clip = clips;
	ball->clip_count = 1;
	move(ball, transform_translate(vec3(10, 0, 0)));
	FlatScene flat = flatten(ball);
	CHECK_NEAR(first_hit(flat.shapes[0], vec3(9.5, 0, -5), vec3(0, 0, 1)), 5 - sqrt(0.75),
		   1e-9);
	CHECK(first_hit(flat.shapes[0], vec3(10.5, 0, -5), vec3(0, 0, 1)) < 0);
}

static void test_bound_only_where_unbounded(void)
{
	const char *error;
	const Object *bounds[1];
	Object *box = new_object(OBJECT_PRIMITIVE), *plane = new_object(OBJECT_PRIMITIVE),
	       *ball = new_sphere(0);
	box->class = &box_class;
	box->data = box_create(arena, vec3(-3, -3, -3), vec3(3, 3, 3));
	bounds[0] = box;
	plane->class = &plane_class;
	plane->data = plane_create(arena, vec3(0, 1, 0), 0, &error);
	plane->bound = ball->bound = bounds;
	plane->bound_count = ball->bound_count = 1;
	CHECK(flatten(plane).shapes[0]->bound_count == 1);
	CHECK(flatten(ball).shapes[0]->bound_count == 0);
}

static void test_lights(void)
{
	Light lamp = light_default();
	lamp.position = vec3(1, 0, 0);
	Object *light = new_object(OBJECT_LIGHT), *ball = new_sphere(0);
	const Object *look[1] = {ball};
	light->light = &lamp;
	light->children = look;
	light->child_count = 1;
	move(light, transform_translate(vec3(0, 4, 0)));
	Object *group = new_csg(OBJECT_LIGHT_GROUP, light, new_sphere(3));
	FlatScene flat = flatten(group);
	CHECK(flat.light_count == 1 && flat.shape_count == 2);
	CHECK_NEAR(flat.lights[0].position.y, 4, 0);
	CHECK(flat.lights[0].group == 1);
	const Surface *lamp_surface = flat.shapes[0]->owner, *lit = flat.shapes[1]->owner;
	CHECK(lamp_surface->no_shadow && !lit->no_shadow);
	CHECK(lit->light_group == 1 && !lit->global_lights);
}

static void test_one_shape(void)
{
	Object *both = new_csg(OBJECT_UNION, new_sphere(0), new_sphere(5));
	move(both, transform_scale(vec3(2, 2, 2)));
	const Shape *shape = object_shape(arena, both);
	CHECK(shape->owner == NULL);
	CHECK_NEAR(shape->box.lo.x, -2, 1e-6);
	CHECK_NEAR(shape->box.hi.x, 12, 1e-6);
	CHECK(shape_inside(shape, vec3(11, 0, 0)));
}

int main(void)
{
	arena = arena_create();
	test_transforms_compose();
	test_difference();
	test_inverse();
	test_inheritance();
	test_clip_moves_along();
	test_bound_only_where_unbounded();
	test_lights();
	test_one_shape();
	arena_destroy(arena);
	return CHECK_RESULT();
}
