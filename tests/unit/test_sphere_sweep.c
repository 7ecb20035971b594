/* Sphere sweeps and eggs. */
#include "geom/sphere_sweep.h"

#include "geom/ovus.h"
#include "tests/unit/shape_check.h"

static const char *message;

static const Vec3 CENTERS[] = {{-1, -1, 0},   {-0.5, 0.5, 0.3}, {0.2, -0.4, -0.5},
			       {0.9, 0.6, 0}, {0.2, 0.9, 0.8},  {-1, 1, 0}};
static const double RADII[] = {0.2, 0.3, 0.15, 0.35, 0.25, 0.2};

static SphereSweepDesc desc_of(SphereSweepKind kind, int count)
{
	return (SphereSweepDesc){.kind = kind,
				 .centers = CENTERS,
				 .radii = RADII,
				 .count = count,
				 .tolerance = 1e-6};
}

static void test_kinds(Arena *arena)
{
	const SphereSweepKind kinds[] = {SPHERE_SWEEP_LINEAR, SPHERE_SWEEP_CUBIC,
					 SPHERE_SWEEP_B_SPLINE};
	for (int i = 0; i < 3; i++) {
		SphereSweepDesc desc = desc_of(kinds[i], 6);
		Shape shape = test_shape(&sphere_sweep_class,
					 sphere_sweep_create(arena, &desc, &message));
		check_shape(&shape,
			    &(ShapeTraits){.name = "sphere_sweep", .size = 1.2, .step = 1e-6},
			    3000);
	}
	SphereSweepDesc desc = desc_of(SPHERE_SWEEP_LINEAR, 1);
	CHECK(!sphere_sweep_create(arena, &desc, &message));
	desc = desc_of(SPHERE_SWEEP_B_SPLINE, 3);
	CHECK(!sphere_sweep_create(arena, &desc, &message));
}

/* Two equal spheres: a capsule. */
static void test_capsule(Arena *arena)
{
	const Vec3 centers[] = {{-1, 0, 0}, {1, 0, 0}};
	const double radii[] = {0.5, 0.5};
	SphereSweepDesc desc = {
		.kind = SPHERE_SWEEP_LINEAR, .centers = centers, .radii = radii, .count = 2};
	Shape shape = test_shape(&sphere_sweep_class, sphere_sweep_create(arena, &desc, &message));
	Ray ray = {{0.3, 0, -5}, {0, 0, 1}, 0, INFINITY};
	Hit hit;
	CHECK(shape_nearest(&shape, &ray, &hit));
	CHECK_NEAR(hit.t, 4.5, 1e-12);
	ray = (Ray){{-5, 0, 0}, {2, 0, 0}, 0, INFINITY};
	CHECK(shape_nearest(&shape, &ray, &hit));
	CHECK_NEAR(hit.t, 1.75, 1e-12);
	CHECK(shape_inside(&shape, vec3(0.5, 0.49, 0)) &&
	      !shape_inside(&shape, vec3(0.5, 0.51, 0)));
	CHECK(shape_inside(&shape, vec3(1.49, 0, 0)) && !shape_inside(&shape, vec3(1.51, 0, 0)));
}

/* Seen square to the plane it lies in: hits lie under every point of its middle line. */
static void test_flat(Arena *arena)
{
	const Vec3 centers[] = {
		{-0.5, -1, 0}, {0, -0.5, 0}, {0.6, 0, 0}, {0.3, 0.8, 0}, {-0.5, 1, 0}};
	SphereSweepDesc desc = {
		.kind = SPHERE_SWEEP_B_SPLINE, .centers = centers, .radii = RADII, .count = 5};
	Shape shape = test_shape(&sphere_sweep_class, sphere_sweep_create(arena, &desc, &message));
	int missed = 0;
	for (int i = 0; i < 200; i++) {
		double s = 0.01 + 0.0049 * i;
		double weights[] = {pow(1 - s, 3), 3 * s * s * s - 6 * s * s + 4,
				    1 + 3 * s + 3 * s * s - 3 * s * s * s, s * s * s};
		Ray ray = {{0, 0, -10}, {0, 0, 1}, 0, INFINITY};
		Hit hit;
		for (int k = 0; k < 4; k++)
			ray.origin = vec3_mad(ray.origin, weights[k] / 6, centers[k]);
		missed += !shape_nearest(&shape, &ray, &hit) || hit.t > 9.9;
	}
	CHECK(missed == 0);
}

static void test_ovus(Arena *arena)
{
	const double ratios[] = {0.3, 0.8, 1, 1.4, 1.9, 2.5};
	for (int i = 0; i < 6; i++) {
		Shape shape = test_shape(&ovus_class, ovus_create(arena, 1, ratios[i], &message));
		check_shape(&shape, &(ShapeTraits){.name = "ovus", .size = 2, .step = 1e-6}, 2000);
		Ray ray = {{0, 10, 0}, {0, -1, 0}, 0, INFINITY};
		Hit hit;
		CHECK(shape_nearest(&shape, &ray, &hit));
		CHECK_NEAR(hit.t, 9 - ratios[i], 1e-9);
		ray = (Ray){{0, -10, 0}, {0, 1, 0}, 0, INFINITY};
		CHECK(shape_nearest(&shape, &ray, &hit));
		CHECK_NEAR(hit.t, ratios[i] < 2 ? 9 : 11 - ratios[i], 1e-9);
	}
	/* A measured value of POV-Ray's. */
	Shape egg = test_shape(&ovus_class, ovus_create(arena, 1, 0.5, &message));
	Ray front = {{-0.2, 1.4, -9}, {0, 0, 1}, 0, INFINITY};
	Hit at;
	CHECK(shape_nearest(&egg, &front, &at));
	Vec2 uv = hit_uv(&at, ray_at(&front, at.t));
	CHECK_NEAR(uv.u, 0.6339, 1e-4);
	CHECK_NEAR(uv.v, 0.9187, 1e-4);
	CHECK(!ovus_create(arena, -1, 1, &message));
}

int main(void)
{
	Arena *arena = arena_create();
	test_kinds(arena);
	test_capsule(arena);
	test_flat(arena);
	test_ovus(arena);
	arena_destroy(arena);
	return CHECK_RESULT();
}
