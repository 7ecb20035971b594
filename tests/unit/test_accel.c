/* The accelerator gives the same answers as asking every shape, for few shapes, many, meshes, far
 * eyes and filters. */
#include "scene/accel.h"

#include "base/arena.h"
#include "base/random.h"
#include "geom/box.h"
#include "geom/mesh.h"
#include "geom/plane.h"
#include "geom/sphere.h"

#include "check.h"

enum { MOST = 400 };

static double uniform(uint64_t index, uint64_t dimension)
{
	return random_uniform(7, index, dimension);
}

static Vec3 place(uint64_t index, double size)
{
	return vec3(size * (uniform(index, 0) - 0.5), size * (uniform(index, 1) - 0.5),
		    size * (uniform(index, 2) - 0.5));
}

static const Shape *finish(Arena *arena, const ShapeClass *class, const void *data)
{
	Shape *shape = ARENA_NEW(arena, Shape);
	shape->class = class;
	shape->data = data;
	shape_finish(shape);
	return shape;
}

static const Shape *small_shape(Arena *arena, uint64_t index)
{
	Vec3 p = place(index, 10);
	if (index % 2)
		return finish(arena, &sphere_class,
			      sphere_create(arena, p, 0.05 + 0.5 * uniform(index, 3)));
	Vec3 q = vec3_add(
		p, vec3(0.1 + uniform(index, 4), 0.1 + uniform(index, 5), 0.1 + uniform(index, 6)));
	return finish(arena, &box_class, box_create(arena, p, q));
}

static const Shape *quad_mesh(Arena *arena)
{
	static const float vertices[4][3] = {{-3, -3, 1}, {3, -3, 1}, {3, 3, 1.5f}, {-3, 3, 1.5f}};
	static const int triangles[2][3] = {{0, 1, 2}, {0, 2, 3}};
	MeshDesc desc = {.vertices = vertices,
			 .vertex_count = 4,
			 .triangles = triangles,
			 .triangle_count = 2};
	const char *error = NULL;
	return finish(arena, &mesh_class, mesh_create(arena, &desc, &error));
}

static bool refuse_even(void *data, const Ray *ray, const Hit *hit)
{
	const Shape *const *shapes = data;
	(void)ray;
	for (int i = 0; shapes[i]; i++)
		if (shapes[i] == hit->shape)
			return i % 2;
	return true;
}

static bool brute_nearest(const Shape *const *shapes, const Ray *ray, bool odd_only, Hit *out)
{
	Ray rest = *ray;
	bool found = false;
	for (int i = 0; shapes[i]; i++)
		if ((!odd_only || i % 2) && shape_nearest(shapes[i], &rest, out)) {
			rest.tmax = out->t;
			found = true;
		}
	return found;
}

static void check_rays(const Shape *const *shapes, int count, double eye_distance)
{
	Accel *accel = accel_create(shapes, count);
	for (uint64_t i = 0; i < 2000; i++) {
		Vec3 from = vec3_scale(vec3_normalize(place(i + 1000, 1)), eye_distance);
		Ray ray = {from, vec3_normalize(vec3_sub(place(i + 9000, 8), from)), 1e-6,
			   INFINITY};
		Hit expected, got;
		bool hit = brute_nearest(shapes, &ray, false, &expected);
		CHECK(accel_nearest(accel, &ray, NULL, NULL, &got) == hit);
		if (hit)
			CHECK_NEAR(got.t, expected.t, 1e-9 * (1 + eye_distance));
		CHECK(accel_any(accel, &ray, NULL, NULL) == hit);
		hit = brute_nearest(shapes, &ray, true, &expected);
		CHECK(accel_nearest(accel, &ray, refuse_even, (void *)shapes, &got) == hit);
		if (hit)
			CHECK_NEAR(got.t, expected.t, 1e-9 * (1 + eye_distance));
		CHECK(accel_any(accel, &ray, refuse_even, (void *)shapes) == hit);
	}
	accel_destroy(accel);
}

static void check_containing(Arena *arena)
{
	const char *error = NULL;
	const Shape *shapes[] = {
		finish(arena, &sphere_class, sphere_create(arena, vec3(0, 0, 0), 2)),
		finish(arena, &sphere_class, sphere_create(arena, vec3(1, 0, 0), 2)),
		finish(arena, &plane_class, plane_create(arena, vec3(0, 1, 0), -1, &error)),
	};
	const Shape *out[4];
	Accel *accel = accel_create(shapes, 3);
	CHECK(accel_containing(accel, vec3(0.5, 0, 0), out, 4) == 2);
	CHECK(accel_containing(accel, vec3(0.5, 0, 0), out, 1) == 1);
	CHECK(accel_containing(accel, vec3(-1.5, 0, 0), out, 4) == 1 && out[0] == shapes[0]);
	CHECK(accel_containing(accel, vec3(0, -9, 0), out, 4) == 1 && out[0] == shapes[2]);
	CHECK(accel_containing(accel, vec3(0, 9, 0), out, 4) == 0);
	accel_destroy(accel);
	accel = accel_create(shapes, 0);
	CHECK(accel_containing(accel, vec3(0, 0, 0), out, 4) == 0);
	Ray ray = {{0, 0, 0}, {0, 0, 1}, 0, INFINITY};
	CHECK(!accel_any(accel, &ray, NULL, NULL));
	accel_destroy(accel);
}

/* Many shapes without bounds, mixed: plain spheres come first, then plain planes, then the rest,
 * each in the order of the scene. */
static void check_order(Arena *arena)
{
	enum { MIXED = 3000 };
	static const Shape *shapes[MIXED], *out[MIXED];
	const char *error = NULL;
	Transform moved = transform_translate(vec3(0, 1, 0));
	Accel *accel;
	for (int i = 0; i < MIXED; i++) {
		const ShapeClass *class = i % 3 == 1 ? &sphere_class : &plane_class;
		Shape *shape = ARENA_NEW(arena, Shape);
		*shape = (Shape){.class = class, .transform = i % 3 == 0 ? &moved : NULL};
		shape->data = i % 3 == 1 ? (const void *)sphere_create(arena, vec3(0, 0, 0), 1e20)
					 : plane_create(arena, vec3(0, 1, 0), 1, &error);
		shape_finish(shape);
		shapes[i] = shape;
	}
	accel = accel_create(shapes, MIXED);
	CHECK(accel_containing(accel, vec3(0, 0, 0), out, MIXED) == MIXED);
	for (int i = 0; i < MIXED / 3; i++) {
		CHECK(out[i] == shapes[3 * i + 1]);
		CHECK(out[MIXED / 3 + i] == shapes[3 * i + 2]);
		CHECK(out[MIXED / 3 * 2 + i] == shapes[3 * i]);
	}
	accel_destroy(accel);
}

/* Rays from and to nowhere hit nothing. */
static void check_nowhere(const Shape *const *shapes, int count)
{
	Accel *accel = accel_create(shapes, count);
	Ray rays[] = {
		{{0, 0, -9}, {NAN, NAN, NAN}, 1e-6, INFINITY},
		{{0, NAN, -9}, {0, 0, 1}, 1e-6, INFINITY},
		{{0, 0, -INFINITY}, {0, 0, 1}, 1e-6, INFINITY},
	};
	for (int i = 0; i < 3; i++) {
		Hit hit;
		CHECK(!accel_nearest(accel, &rays[i], NULL, NULL, &hit));
		CHECK(!accel_any(accel, &rays[i], NULL, NULL));
	}
	accel_destroy(accel);
}

int main(void)
{
	Arena *arena = arena_create();
	const Shape *shapes[MOST + 3] = {0};
	for (int i = 0; i < MOST; i++)
		shapes[i] = small_shape(arena, (uint64_t)i);
	check_rays(shapes, MOST, 20);
	check_rays(shapes, MOST, 1e6);
	check_nowhere(shapes, MOST);
	const Shape *small = shapes[7];
	shapes[7] = finish(arena, &sphere_class, sphere_create(arena, vec3(0, 0, 4e25), 1e25));
	check_rays(shapes, MOST, 20);
	shapes[7] = small;
	shapes[5] = NULL;
	check_rays(shapes, 5, 20);
	const char *error = NULL;
	shapes[4] = finish(arena, &plane_class, plane_create(arena, vec3(0.1, 1, 0.2), -2, &error));
	shapes[3] = quad_mesh(arena);
	check_rays(shapes, 5, 20);
	check_containing(arena);
	check_order(arena);
	arena_destroy(arena);
	return CHECK_RESULT();
}
