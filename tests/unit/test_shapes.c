/* The simple primitives: analytic distances, and what must hold for any shape. */
#include "geom/box.h"
#include "geom/cone.h"
#include "geom/disc.h"
#include "geom/plane.h"
#include "geom/ray_box.h"
#include "geom/sphere.h"
#include "geom/torus.h"
#include "tests/unit/shape_check.h"

static const char *message;

/* The sorted crossings of a ray with a shape must be these. */
static void check_distances(const ShapeClass *class, const void *data, Ray ray,
			    const double *expected, int count)
{
	Shape shape = test_shape(class, data);
	HitList list;
	hit_list_init(&list);
	shape_intersect(&shape, &ray, &list);
	hit_list_sort(&list);
	if (list.count != count) {
		check_failures++;
		printf("%s: %d crossings, expected %d\n", class->name, list.count, count);
	}
	for (int i = 0; i < count && i < list.count; i++)
		CHECK_NEAR(list.hits[i].t, expected[i], 1e-10 * (1 + fabs(expected[i])));
	hit_list_free(&list);
}

static Ray ray_from(Vec3 origin, Vec3 direction)
{
	return (Ray){origin, direction, 0, INFINITY};
}

static void test_sphere(Arena *arena)
{
	const void *data = sphere_create(arena, vec3(1, 0, 0), 2);
	check_distances(&sphere_class, data, ray_from(vec3(-5, 0, 0), vec3(1, 0, 0)),
			(double[]){4, 8}, 2);
	check_distances(&sphere_class, data, ray_from(vec3(-5, 0, 0), vec3(2, 0, 0)),
			(double[]){2, 4}, 2);
	check_distances(&sphere_class, data, ray_from(vec3(0, 0, 0), vec3(1, 0, 0)), (double[]){3},
			1);
	check_distances(&sphere_class, data, ray_from(vec3(1, 1, -1e6), vec3(0, 0, 1)),
	                (double[]){1e6 - sqrt(3), 1e6 + sqrt(3)}, 2);
	check_distances(&sphere_class, data, ray_from(vec3(-5, 2.1, 0), vec3(1, 0, 0)), NULL, 0);
	check_distances(&sphere_class, sphere_create(arena, vec3_all(0), 0),
			ray_from(vec3(0, 0, -5), vec3(0, 0, 1)), NULL, 0);
	Shape shape = test_shape(&sphere_class, data);
	Hit hit = {.shape = &shape};
	Vec2 uv = hit_uv(&hit, vec3(1, 0, 2));
	CHECK_NEAR(uv.u, 0.25, 1e-12);
	CHECK_NEAR(uv.v, 0.5, 1e-12);
	check_shape(&shape, &(ShapeTraits){.name = "sphere", .size = 2, .step = 1e-6}, 2000);
}

static void test_box(Arena *arena)
{
	const void *data = box_create(arena, vec3(1, 2, 3), vec3(-1, -2, -3));
	check_distances(&box_class, data, ray_from(vec3(0, 0, -10), vec3(0, 0, 1)),
			(double[]){7, 13}, 2);
	check_distances(&box_class, data, ray_from(vec3(5, 0, 0), vec3(-1, 0, 0)), (double[]){4, 6},
			2);
	check_distances(&box_class, data, ray_from(vec3(0, 0, 0), vec3(0, 4, 0)), (double[]){0.5},
			1);
	check_distances(&box_class, data, ray_from(vec3(-3, -2.5, 0), vec3(1, 1, 0)),
			(double[]){2, 4}, 2);
	check_distances(&box_class, data, ray_from(vec3(5, 3, 0), vec3(-1, 0, 0)), NULL, 0);
	const void *flat = box_create(arena, vec3(0, 0, 0), vec3(1, 0, 1));
	check_distances(&box_class, flat, ray_from(vec3(0.5, 3, 0.5), vec3(0, -1, 0)),
			(double[]){3, 3}, 2);
	Shape shape = test_shape(&box_class, data);
	check_shape(&shape, &(ShapeTraits){.name = "box", .size = 3, .step = 1e-6}, 2000);
	CHECK(shape_inside(&shape, vec3(1, 0, 0)));
	shape.inverted = true;
	CHECK(!shape_inside(&shape, vec3(1, 0, 0)));
	check_shape(&shape, &(ShapeTraits){.name = "inverse box", .size = 3, .step = 1e-6}, 500);
}

static void test_plane(Arena *arena)
{
	const void *data = plane_create(arena, vec3(0, 2, 0), 3, &message);
	check_distances(&plane_class, data, ray_from(vec3(0, 10, 0), vec3(0, -1, 0)), (double[]){7},
			1);
	check_distances(&plane_class, data, ray_from(vec3(0, 10, 0), vec3(1, 0, 0)), NULL, 0);
	check_distances(&plane_class, data, ray_from(vec3(0, 10, 0), vec3(0, 1, 0)), NULL, 0);
	CHECK(!plane_create(arena, vec3(0, 0, 0), 1, &message));
	Shape shape = test_shape(&plane_class, data);
	CHECK(!shape_is_bounded(&shape));
	CHECK(shape_inside(&shape, vec3(7, 2.9, 3)) && shape_inside(&shape, vec3(0, 3, 0)));
	CHECK(!shape_inside(&shape, vec3(7, 3.1, 3)));
	check_shape(&shape, &(ShapeTraits){.name = "plane", .size = 5, .step = 1e-6}, 2000);
}

static void test_cone(Arena *arena)
{
	ConeDesc desc = {.base = {0, 0, 0}, .cap = {0, 4, 0}, .base_radius = 2, .cap_radius = 1};
	const void *data = cone_create(arena, &desc, &message);
	check_distances(&cone_class, data, ray_from(vec3(-5, 2, 0), vec3(1, 0, 0)),
			(double[]){3.5, 6.5}, 2);
	check_distances(&cone_class, data, ray_from(vec3(0, 9, 0), vec3(0, -1, 0)),
			(double[]){5, 9}, 2);
	check_distances(&cone_class, data, ray_from(vec3(1.5, 9, 0), vec3(0, -1, 0)),
			(double[]){7, 9}, 2);
	Shape shape = test_shape(&cone_class, data);
	check_shape(&shape, &(ShapeTraits){.name = "cone", .size = 4, .step = 1e-6}, 2000);
	desc.open = true;
	check_distances(&cone_class, cone_create(arena, &desc, &message),
			ray_from(vec3(1.5, 9, 0), vec3(0, -1, 0)), (double[]){7}, 1);
	desc = (ConeDesc){.base = {0, -1, 0}, .cap = {3, -1, 4}, .base_radius = 1, .cap_radius = 1};
	data = cone_create(arena, &desc, &message);
	check_distances(&cylinder_class, data, ray_from(vec3(1.5, 5, 2), vec3(0, -1, 0)),
			(double[]){5, 7}, 2);
	check_distances(&cylinder_class, data, ray_from(vec3(-3, -1, -4), vec3(3, 0, 4)),
			(double[]){1, 2}, 2);
	check_distances(&cylinder_class, data, ray_from(vec3(1.5, 1e6, 2), vec3(0, -1, 0)),
			(double[]){1e6, 1e6 + 2}, 2);
	shape = test_shape(&cylinder_class, data);
	check_shape(&shape, &(ShapeTraits){.name = "cylinder", .size = 4, .step = 1e-6}, 2000);
	check_flat(&shape, ray_from(vec3(-3, -1, -4), vec3(3, 0, 4)), "ff");
	check_flat(&shape, ray_from(vec3(-3, -1.9, -4), vec3(3, 1, 4)), "fc");
	desc = (ConeDesc){.base = {0, 0, 0}, .cap = {0, 0, 0}, .base_radius = 1, .cap_radius = 1};
	CHECK(!cone_create(arena, &desc, &message));
	/* Radii of different sign: two cones tip to tip. */
	desc = (ConeDesc){.base = {-2, 0, 0}, .cap = {2, 0, 0}, .base_radius = 2, .cap_radius = -2};
	shape = test_shape(&cone_class, cone_create(arena, &desc, &message));
	CHECK(shape_inside(&shape, vec3(1.5, 1, 0)) && !shape_inside(&shape, vec3(0.5, 1, 0)));
	check_shape(&shape, &(ShapeTraits){.name = "double cone", .size = 3, .step = 1e-6}, 1000);
}

static void test_disc(Arena *arena)
{
	DiscDesc desc = {.center = {0, 1, 0}, .normal = {0, 3, 0}, .radius = 2, .hole = 0.5};
	const void *data = disc_create(arena, &desc);
	check_distances(&disc_class, data, ray_from(vec3(1, 4, 0), vec3(0, -1, 0)), (double[]){3},
			1);
	check_distances(&disc_class, data, ray_from(vec3(0.4, 4, 0), vec3(0, -1, 0)), NULL, 0);
	check_distances(&disc_class, data, ray_from(vec3(0, 4, 2.1), vec3(0, -1, 0)), NULL, 0);
	Shape shape = test_shape(&disc_class, data);
	CHECK(shape_inside(&shape, vec3(9, 0.9, 9)) && !shape_inside(&shape, vec3(9, 1.1, 9)));
	CHECK_NEAR(shape.box.hi.x, 2, 1e-6);
	CHECK_NEAR(shape.box.hi.y, 1, 1e-6);
	check_shape(&shape, &(ShapeTraits){.name = "disc", .size = 2, .step = 1e-6}, 2000);
}

static void test_torus(Arena *arena)
{
	const void *data = torus_create(arena, 3, 1);
	check_distances(&torus_class, data, ray_from(vec3(-10, 0, 0), vec3(1, 0, 0)),
			(double[]){6, 8, 12, 14}, 4);
	check_distances(&torus_class, data, ray_from(vec3(-1e5, 0, 0), vec3(10, 0, 0)),
	                (double[]){9999.6, 9999.8, 10000.2, 10000.4}, 4);
	check_distances(&torus_class, data, ray_from(vec3(3.5, 10, 0), vec3(0, -1, 0)),
	                (double[]){10 - sqrt(0.75), 10 + sqrt(0.75)}, 2);
	check_distances(&torus_class, data, ray_from(vec3(0, 10, 0), vec3(0, -1, 0)), NULL, 0);
	check_distances(&torus_class, torus_create(arena, 1, -1),
			ray_from(vec3(-5, 0, 0), vec3(1, 0, 0)), NULL, 0);
	Shape shape = test_shape(&torus_class, data);
	check_shape(&shape, &(ShapeTraits){.name = "torus", .size = 4, .step = 1e-6}, 2000);
	shape = test_shape(&torus_class, torus_create(arena, 3, 0.05));
	check_shape(&shape, &(ShapeTraits){.name = "thin torus", .size = 3, .step = 1e-6}, 5000);
}

static void check_uv(const Shape *shape, Ray ray, double u, double v)
{
	Hit hit;
	CHECK(shape_nearest(shape, &ray, &hit));
	Vec2 uv = hit_uv(&hit, ray_at(&ray, hit.t));
	CHECK_NEAR(uv.u, u, 2e-4);
	CHECK_NEAR(uv.v, v, 2e-4);
}

/* Values measured with POV-Ray. */
static void test_uv(Arena *arena)
{
	Shape box = test_shape(&box_class, box_create(arena, vec3_all(-1), vec3_all(1)));
	check_uv(&box, ray_from(vec3(-0.75, 0.75, -9), vec3(0, 0, 1)), 0.9687, 0.625);
	check_uv(&box, ray_from(vec3(-0.25, -0.25, 9), vec3(0, 0, -1)), 0.34375, 0.4584);
	check_uv(&box, ray_from(vec3(9, -0.75, -0.75), vec3(-1, 0, 0)), 0.7187, 0.375);
	check_uv(&box, ray_from(vec3(-9, 0.75, 0.75), vec3(1, 0, 0)), 0.2187, 0.625);
	check_uv(&box, ray_from(vec3(0.75, 9, -0.75), vec3(0, -1, 0)), 0.4687, 0.9584);
	check_uv(&box, ray_from(vec3(-0.75, -9, 0.75), vec3(0, 1, 0)), 0.2812, 0.2917);
	Shape torus = test_shape(&torus_class, torus_create(arena, 1, 0.4));
	check_uv(&torus, ray_from(vec3(-1, -0.2, -9), vec3(0, 0, 1)), 0.8832, 0.4167);
	check_uv(&torus, ray_from(vec3(-0.2, 0.2, -9), vec3(0, 0, 1)), 0.7737, 0.5834);
}

/* clipped_by takes away what lies outside of the clip. */
static void test_clip(Arena *arena)
{
	Shape clip = test_shape(&plane_class, plane_create(arena, vec3(0, 0, 1), 0, &message));
	const Shape *clips[] = {&clip};
	Shape shape = {.class = &sphere_class, .data = sphere_create(arena, vec3_all(0), 1)};
	shape.clip = clips;
	shape.clip_count = 1;
	shape_finish(&shape);
	Ray ray = ray_from(vec3(0, 0, 5), vec3(0, 0, -1));
	Hit hit;
	CHECK(shape_nearest(&shape, &ray, &hit));
	CHECK_NEAR(hit.t, 6, 1e-12);
	CHECK(!shape_inside(&shape, vec3(0, 0, 0.5)) && shape_inside(&shape, vec3(0, 0, -0.5)));
	shape.clip_count = 0;
	shape.bound = clips;
	shape.bound_count = 1;
	shape_finish(&shape);
	CHECK(shape_nearest(&shape, &ray, &hit));
	CHECK_NEAR(hit.t, 4, 1e-12);
	ray.direction = vec3(0, 0.01, 1);
	ray.origin = vec3(0, 0, 5);
	CHECK(!shape_nearest(&shape, &ray, &hit));
}

/* A ray in the very plane of a box's side meets the box, whichever side it is and whatever sign the
 * zero of its direction has. */
static void test_ray_in_side(void)
{
	Box3 box = {vec3(0, 0, 0), vec3(1, 1, 1)};
	for (int i = 0; i < 8; i++) {
		double side = i & 1, zero = i & 2 ? -0.0 : 0.0, x = i & 4 ? 1 : -1;
		Ray ray = {vec3(0.5 - 2 * x, side, 0.5), vec3(x, zero, zero), 0, INFINITY};
		RaySlabs slabs = ray_slabs(&ray);
		double range[2];
		ray_slabs_range(&slabs, &box, range);
		CHECK(ray_slabs_hit(&slabs, &box));
		CHECK_NEAR(range[0], 1.5, 1e-12);
		CHECK_NEAR(range[1], 2.5, 1e-12);
	}
}

int main(void)
{
	Arena *arena = arena_create();
	test_sphere(arena);
	test_box(arena);
	test_plane(arena);
	test_cone(arena);
	test_disc(arena);
	test_torus(arena);
	test_uv(arena);
	test_clip(arena);
	test_ray_in_side();
	arena_destroy(arena);
	return CHECK_RESULT();
}
