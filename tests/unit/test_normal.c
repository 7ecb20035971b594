/* Normals bent by the slope of a pattern, by maps and by averages; under transformations. */
#include "surface/texture.h"

#include "check.h"
#include "surface/warp.h"

static double value_slope(const Pattern *pattern, const SurfacePoint *at)
{
	const Vec3 *gradient = pattern->data;
	return 0.5 + vec3_dot(*gradient, at->p);
}

static const PatternClass SLOPE = {.name = "a slope", .value = value_slope};

static Normal normal_of(const Vec3 *gradient, double amount)
{
	return (Normal){
		.kind = NORMAL_PATTERN,
		.pattern = {.class = &SLOPE, .data = gradient, .frequency = 1, .exponent = 1},
		.amount = amount, .bump_size = 1, .accuracy = 0.02,
	};
}

static SurfacePoint origin(void)
{
	return (SurfacePoint){.normal = {0, 0, -1}, .direction = {0, 0, 1}};
}

/* Four corners of the unit tetrahedron, height h = g.p: the sum of h c over them is 4/3 g, and the
 * factors of height and step give n - 4/30 amount g. */
static void test_closed_form(void)
{
	const Vec3 gradient = {0.3, -0.2, 0.1};
	Normal normal = normal_of(&gradient, 0.8);
	SurfacePoint at = origin();
	Vec3 n = normal_perturb(&normal, &at, vec3(0, 0, -1));
	Vec3 expected = vec3_normalize(vec3_mad(vec3(0, 0, -1), -0.8 * 4 / 30, gradient));
	CHECK_NEAR(vec3_distance(n, expected), 0, 1e-6);
	normal.accuracy = 0.001;
	CHECK_NEAR(vec3_distance(normal_perturb(&normal, &at, vec3(0, 0, -1)), expected), 0, 1e-6);
}

/* Turning pattern, point and normal together turns the result. */
static void test_rotation(void)
{
	Arena *arena = arena_create();
	const Vec3 gradient = {0.3, 0.2, 0.1};
	Normal still = normal_of(&gradient, 1.5), turned = still;
	Transform rotate = transform_rotate(vec3(20, 50, -70));
	warp_add_transform(arena, &turned.pattern.warps, &rotate);
	SurfacePoint at = origin();
	Vec3 n = vec3_normalize(vec3(1, 2, -3));
	Vec3 expected = transform_vector(&rotate, normal_perturb(&still, &at, n));
	Vec3 found = normal_perturb(&turned, &at, transform_vector(&rotate, n));
	CHECK_NEAR(vec3_distance(found, expected), 0, 1e-9);
	CHECK_NEAR(vec3_length(found), 1, 1e-12);
	arena_destroy(arena);
}

/* A uniform scale leaves the perturbation as deep as it was. */
static void test_scale(void)
{
	Arena *arena = arena_create();
	const Vec3 gradient = {0.3, 0.2, 0.1};
	Normal still = normal_of(&gradient, 1.5), scaled = still;
	Transform scale = transform_scale(vec3_all(7));
	warp_add_transform(arena, &scaled.pattern.warps, &scale);
	SurfacePoint at = origin();
	Vec3 n = vec3(0, 0.6, 0.8);
	CHECK_NEAR(vec3_distance(normal_perturb(&scaled, &at, n), normal_perturb(&still, &at, n)),
		   0, 1e-9);
	arena_destroy(arena);
}

static void test_average(void)
{
	const Vec3 right = {0.5, 0, 0}, left = {-0.5, 0, 0};
	Normal a = normal_of(&right, 1), b = normal_of(&left, 1);
	const NormalEntry entries[] = {{1, &a}, {1, &b}};
	Normal average = {.kind = NORMAL_AVERAGE, .normals = entries, .normal_count = 2};
	SurfacePoint at = origin();
	CHECK_NEAR(vec3_distance(normal_perturb(&average, &at, vec3(0, 0, -1)), vec3(0, 0, -1)), 0,
		   1e-7);
}

static void test_slope_map(void)
{
	const Vec3 gradient = {1, 0, 0};
	const SlopeEntry slopes[] = {{0, 0, 0}, {1, 0, 0}};
	Normal normal = normal_of(&gradient, 1);
	normal.kind = NORMAL_SLOPE_MAP;
	normal.slopes = slopes;
	normal.slope_count = 2;
	SurfacePoint at = origin();
	CHECK_NEAR(vec3_distance(normal_perturb(&normal, &at, vec3(0, 0, -1)), vec3(0, 0, -1)), 0,
		   1e-12);
	/* Slope 2 all over: twice as steep as the pattern itself. */
	const SlopeEntry steep[] = {{0, 0, 2}, {1, 2, 2}};
	const Vec3 twice = {2, 0, 0};
	Normal plain = normal_of(&twice, 1);
	normal.slopes = steep;
	CHECK_NEAR(vec3_distance(normal_perturb(&normal, &at, vec3(0, 0, -1)),
	                         normal_perturb(&plain, &at, vec3(0, 0, -1))), 0, 1e-7);
}

int main(void)
{
	test_closed_form();
	test_rotation();
	test_scale();
	test_average();
	test_slope_map();
	return CHECK_RESULT();
}
