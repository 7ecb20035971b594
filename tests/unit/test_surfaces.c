/* Julia fractals and parametric surfaces. */
#include "geom/julia_fractal.h"

#include "geom/parametric.h"
#include "tests/unit/shape_check.h"

static const char *message;

static void test_quaternion(Arena *arena)
{
	JuliaDesc desc = julia_default();
	desc.parameter[0] = -0.083;
	desc.parameter[2] = -0.83;
	desc.parameter[3] = -0.025;
	desc.max_iteration = 5;
	desc.precision = 200;
	Shape shape = test_shape(&julia_fractal_class, julia_create(arena, &desc, &message));
	check_shape(&shape, &(ShapeTraits){.name = "quaternion", .size = 1.2, .step = 1e-4}, 1000);
	desc.function = JULIA_CUBE;
	shape = test_shape(&julia_fractal_class, julia_create(arena, &desc, &message));
	check_shape(&shape, &(ShapeTraits){.name = "quaternion cube", .size = 1.2, .step = 1e-4},
		    1000);
	desc.slice_normal[0] = 0.5;
	desc.slice_distance = 0.1;
	shape = test_shape(&julia_fractal_class, julia_create(arena, &desc, &message));
	check_shape(&shape, &(ShapeTraits){.name = "sliced quaternion", .size = 1.2, .step = 1e-4},
		    1000);
	desc.function = JULIA_SIN;
	CHECK(!julia_create(arena, &desc, &message));
	desc.function = JULIA_SQR;
	desc.slice_normal[3] = 0;
	CHECK(!julia_create(arena, &desc, &message));
}

/* With parameter 0, z^2 stays within its bound inside a sphere of radius 1, nearly, after many
 * iterations. */
static void test_sphere(Arena *arena)
{
	JuliaDesc desc = julia_default();
	Shape shape = test_shape(&julia_fractal_class, julia_create(arena, &desc, &message));
	CHECK(shape_inside(&shape, vec3(0.6, 0.5, 0.5)) &&
	      !shape_inside(&shape, vec3(0.6, 0.6, 0.6)));
}

/* POV-Ray draws the hypercomplex square's set for the cube as well. */
static void test_cube(Arena *arena)
{
	JuliaDesc desc = julia_default();
	desc.hypercomplex = true;
	desc.parameter[1] = 0.5;
	desc.max_iteration = 4;
	Shape square = test_shape(&julia_fractal_class, julia_create(arena, &desc, &message));
	desc.function = JULIA_CUBE;
	Shape cube = test_shape(&julia_fractal_class, julia_create(arena, &desc, &message));
	Sampler sampler = {7, 0, 0};
	for (int i = 0; i < 1000; i++) {
		Vec3 p = test_point(&sampler, 1.5);
		CHECK(shape_inside(&square, p) == shape_inside(&cube, p));
	}
}

static void test_hypercomplex(Arena *arena)
{
	const JuliaFunction functions[] = {JULIA_SQR,  JULIA_CUBE, JULIA_RECIPROCAL,
					   JULIA_SINH, JULIA_PWR,  JULIA_EXP};
	for (int i = 0; i < 6; i++) {
		JuliaDesc desc = julia_default();
		desc.hypercomplex = true;
		desc.function = functions[i];
		desc.exponent = (Vec2){2, 0};
		desc.parameter[0] = -0.16;
		desc.parameter[1] = 0.8;
		desc.max_iteration = 4;
		desc.precision = 100;
		Shape shape = test_shape(&julia_fractal_class,
					 julia_create(arena, &desc, &message));
		check_shape(
			&shape,
			&(ShapeTraits){
				.name = "hypercomplex", .size = 2, .step = 1e-4, .both_ways = true},
			300);
	}
}

static Vec3 ball_point(const void *function, double u, double v)
{
	double radius = *(const double *)function;
	return vec3(radius * sin(u) * cos(v), radius * cos(u), radius * sin(u) * sin(v));
}

static void test_parametric(Arena *arena)
{
	double radius = 0.9;
	ParametricDesc desc = parametric_default();
	desc.point = ball_point;
	desc.function = &radius;
	desc.hi = (Vec2){M_PI, 2 * M_PI};
	Shape shape = test_shape(&parametric_class, parametric_create(arena, &desc, &message));
	check_shape(
		&shape,
		&(ShapeTraits){.name = "parametric", .size = 1, .step = 1e-6, .no_inside = true},
		2000);
	int bad = 0;
	for (int n = 0; n < 1000; n++) {
		Sampler sampler = {9, (uint64_t)n, 0};
		Ray ray = test_ray(&sampler, 0.9);
		HitList list;
		hit_list_init(&list);
		shape_intersect(&shape, &ray, &list);
		bad += list.count != 2;
		for (int i = 0; i < list.count; i++)
			CHECK_NEAR(vec3_length(ray_at(&ray, list.hits[i].t)), 0.9, 1e-8);
		hit_list_free(&list);
	}
	CHECK(bad <= 5);
	desc.hi = desc.lo;
	CHECK(!parametric_create(arena, &desc, &message));
}

int main(void)
{
	Arena *arena = arena_create();
	test_sphere(arena);
	test_quaternion(arena);
	test_cube(arena);
	test_hypercomplex(arena);
	test_parametric(arena);
	arena_destroy(arena);
	return CHECK_RESULT();
}
