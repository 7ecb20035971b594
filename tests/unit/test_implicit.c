/* Shapes defined by equations: quadrics, polynomials, superellipsoids, blobs, isosurfaces. */
#include "geom/blob.h"
#include "geom/isosurface.h"
#include "geom/poly.h"
#include "geom/sphere.h"
#include "geom/superellipsoid.h"
#include "geom/torus.h"
#include "tests/unit/shape_check.h"

static const char *message;

/* Both shapes must be crossed at the same places. */
static void check_same(const Shape *a, const Shape *b, double size, double tolerance)
{
	int bad = 0;
	for (int n = 0; n < 1000; n++) {
		Sampler sampler = {17, (uint64_t)n, 0};
		Ray ray = test_ray(&sampler, size);
		HitList first, second;
		hit_list_init(&first);
		hit_list_init(&second);
		shape_intersect(a, &ray, &first);
		shape_intersect(b, &ray, &second);
		hit_list_sort(&first);
		hit_list_sort(&second);
		bad += first.count != second.count;
		for (int i = 0; i < first.count && i < second.count; i++)
			bad += fabs(first.hits[i].t - second.hits[i].t) > tolerance;
		hit_list_free(&first);
		hit_list_free(&second);
	}
	if (bad > 5) {
		check_failures++;
		printf("%s differs from %s for %d rays\n", a->class->name, b->class->name, bad);
	}
}

static void test_quadric(Arena *arena)
{
	/* An ellipsoid with axes 1, 2, 3 about (1, 0, 0). */
	double c[10] = {1, 0.25, 1 / 9.0, 0, 0, 0, -2, 0, 0, 0};
	Shape shape = test_shape(&quadric_class, quadric_create(arena, c));
	check_shape(&shape, &(ShapeTraits){.name = "quadric", .size = 3, .step = 1e-6}, 2000);
	Transform grow = transform_scale(vec3(1, 2, 3)), shift = transform_translate(vec3(1, 0, 0));
	Transform all = transform_compose(&grow, &shift);
	Shape ellipsoid = {.class = &sphere_class,
			   .data = sphere_create(arena, vec3_all(0), 1),
			   .transform = &all};
	shape_finish(&ellipsoid);
	check_same(&shape, &ellipsoid, 3, 1e-9);
	/* xy = 1: a hyperbolic cylinder, through the mixed terms. */
	double mixed[10] = {0, 0, 0, 1, 0, 0, 0, 0, 0, -1};
	shape = test_shape(&quadric_class, quadric_create(arena, mixed));
	CHECK(shape_inside(&shape, vec3(0, 0, 5)) && !shape_inside(&shape, vec3(2, 2, 0)));
	check_shape(&shape, &(ShapeTraits){.name = "mixed quadric", .size = 3, .step = 1e-6}, 2000);
}

static void set_term(double *c, int order, const int powers[3], double value)
{
	c[poly_term_index(order, powers[0], powers[1], powers[2])] = value;
}

static void test_poly(Arena *arena)
{
	CHECK(poly_term_count(2) == 10 && poly_term_count(4) == 35 && poly_term_count(7) == 120);
	CHECK(poly_term_index(4, 4, 0, 0) == 0 && poly_term_index(4, 2, 0, 0) == 9 &&
	      poly_term_index(4, 0, 0, 0) == 34);
	CHECK(poly_term_index(4, 0, 2, 2) == 23 && poly_term_index(4, 3, 2, 0) == -1);
	/* The manual's torus about the y axis: radii sqrt(40), sqrt(12). */
	double c[35] = {0};
	const struct { int powers[3]; double value;
	} terms[] = {{{4, 0, 0}, 1},    {{2, 2, 0}, 2},  {{2, 0, 2}, 2},  {{2, 0, 0}, -104},
		     {{0, 4, 0}, 1},    {{0, 2, 2}, 2},  {{0, 2, 0}, 56}, {{0, 0, 4}, 1},
		     {{0, 0, 2}, -104}, {{0, 0, 0}, 784}};
	for (int i = 0; i < 10; i++)
		set_term(c, 4, terms[i].powers, terms[i].value);
	Shape quartic = test_shape(&poly_class, poly_create(arena, 4, c, &message));
	Shape torus = test_shape(&torus_class, torus_create(arena, sqrt(40), sqrt(12)));
	check_same(&quartic, &torus, 8, 1e-7);
	check_shape(&quartic, &(ShapeTraits){.name = "quartic", .size = 8, .step = 1e-5}, 2000);
	CHECK(!poly_create(arena, 1, c, &message) && !poly_create(arena, 36, c, &message));
}

/* x^12 + y^12 + z^12 = 1 is a superellipsoid as well. */
static void test_high_order(Arena *arena)
{
	double *c = ARENA_ARRAY(arena, double, poly_term_count(12));
	set_term(c, 12, (int[]){12, 0, 0}, 1);
	set_term(c, 12, (int[]){0, 12, 0}, 1);
	set_term(c, 12, (int[]){0, 0, 12}, 1);
	set_term(c, 12, (int[]){0, 0, 0}, -1);
	Shape poly = test_shape(&poly_class, poly_create(arena, 12, c, &message));
	Shape super = test_shape(&superellipsoid_class,
				 superellipsoid_create(arena, 1 / 6.0, 1 / 6.0));
	check_same(&poly, &super, 1, 1e-6);
}

/* Inside, told mostly without powers, is where (|x|^(2/e) + |y|^(2/e))^(e/n) + |z|^(2/n) < 1. */
static void test_gauge(Arena *arena)
{
	static const double exponents[] = {0.1, 0.5, 1, 1.5, 2, 2.5, 3, 4, 5, 9};
	enum { COUNT = sizeof exponents / sizeof *exponents };
	for (int i = 0; i < COUNT * COUNT; i++) {
		double e = exponents[i / COUNT], n = exponents[i % COUNT];
		Shape shape = test_shape(&superellipsoid_class, superellipsoid_create(arena, e, n));
		Sampler sampler = {5, (uint64_t)i, 0};
		for (int k = 0; k < 200; k++) {
			Vec3 p = vec3_mul(test_point(&sampler, 1), test_point(&sampler, 1));
			double across = pow(fabs(p.x), 2 / e) + pow(fabs(p.y), 2 / e),
			       all = pow(across, e / n) + pow(fabs(p.z), 2 / n);
			CHECK(fabs(all - 1) < 1e-9 || shape_inside(&shape, p) == (all < 1));
		}
	}
}

static void test_superellipsoid(Arena *arena)
{
	Shape ball = test_shape(&superellipsoid_class, superellipsoid_create(arena, 1, 1));
	Shape sphere = test_shape(&sphere_class, sphere_create(arena, vec3_all(0), 1));
	check_same(&ball, &sphere, 1, 1e-9);
	const double exponents[][2] = {{0.25, 0.25}, {1, 0.1}, {0.01, 0.01}, {2, 2},
				       {2, 0.5},     {0.5, 3}, {3, 3},       {5, 0.3}};
	for (int i = 0; i < 8; i++) {
		Shape shape = test_shape(
			&superellipsoid_class,
			superellipsoid_create(arena, exponents[i][0], exponents[i][1]));
		check_shape(&shape,
			    &(ShapeTraits){.name = "superellipsoid", .size = 1, .step = 1e-6},
			    2000);
	}
	/* An exponent of 0 stands for sharp edges. */
	Shape sharp = test_shape(&superellipsoid_class, superellipsoid_create(arena, 0, 0));
	CHECK(shape_inside(&sharp, vec3(0.99, -0.99, 0.99)));
}

static void test_blob(Arena *arena)
{
	/* One component: a sphere where 2 (1 - r^2)^2 = 1. */
	BlobComponent one = {.center = {0, 0, 0}, .radius = 1, .strength = 2, .texture = -1};
	Shape single = test_shape(&blob_class,
				  blob_create(arena, &(BlobDesc){&one, 1, 1}, &message));
	double radius = sqrt(1 - sqrt(0.5));
	Shape sphere = test_shape(&sphere_class, sphere_create(arena, vec3_all(0), radius));
	check_same(&single, &sphere, 1, 1e-9);
	Transform squash = transform_scale(vec3(1, 0.5, 1));
	BlobComponent several[] = {
		{.center = {0.75, 0, 0}, .radius = 1, .strength = 1, .texture = 4},
		{.center = {-0.375, 0.65, 0}, .radius = 1, .strength = 1, .texture = -1},
		{.center = {-0.375, -0.65, 0},
		 .radius = 1,
		 .strength = 1,
		 .texture = 5,
		 .transform = &squash},
		{.cylinder = true,
		 .center = {0, 0, -1},
		 .end = {0, 0.5, 1},
		 .radius = 0.7,
		 .strength = 1.5,
		 .texture = 4},
		{.center = {0, 0, 1}, .radius = 0.6, .strength = -2, .texture = -1},
	};
	Shape blob = test_shape(&blob_class,
				blob_create(arena, &(BlobDesc){several, 5, 0.6}, &message));
	check_shape(&blob, &(ShapeTraits){.name = "blob", .size = 1.2, .step = 1e-6}, 3000);
	Ray ray = {{-5, 0.1, 0}, {1, 0, 0}, 0, INFINITY};
	Hit hit;
	ShapeTextures textures;
	CHECK(shape_nearest(&blob, &ray, &hit));
	CHECK(hit_textures(&hit, ray_at(&ray, hit.t), &textures) >= 2);
	double sum = 0;
	for (int i = 0; i < textures.count; i++)
		sum += textures.weights[i];
	CHECK_NEAR(sum, 1, 1e-12);
	CHECK(!blob_create(arena, &(BlobDesc){several, 0, 1}, &message));
}

static void test_long_blob(Arena *arena)
{
	enum { COUNT = 200 };
	BlobComponent *row = ARENA_ARRAY(arena, BlobComponent, COUNT);
	for (int i = 0; i < COUNT; i++)
		row[i] = (BlobComponent){.center = {i * 0.5 - 50, sin(i), 0},
					 .radius = 1,
					 .strength = 1,
					 .texture = -1};
	Shape blob = test_shape(&blob_class,
				blob_create(arena, &(BlobDesc){row, COUNT, 0.5}, &message));
	check_shape(&blob, &(ShapeTraits){.name = "long blob", .size = 5, .step = 1e-6}, 2000);
	/* Along the whole row, from afar. */
	Ray ray = {{-1000, 0, 0.1}, {1, 0, 0}, 0, INFINITY};
	HitList list;
	hit_list_init(&list);
	shape_intersect(&blob, &ray, &list);
	CHECK(list.count % 2 == 0 && list.count > 10);
	hit_list_free(&list);
}

static double ball_value(const void *function, Vec3 p)
{
	return vec3_length(p) - *(const double *)function;
}

static void test_isosurface(Arena *arena)
{
	double radius = 0.8, large = 1.2;
	IsosurfaceDesc desc = isosurface_default();
	desc.value = ball_value;
	desc.function = &radius;
	desc.max_trace = 0;
	Shape iso = test_shape(&isosurface_class, isosurface_create(arena, &desc));
	Shape sphere = test_shape(&sphere_class, sphere_create(arena, vec3_all(0), 0.8));
	check_same(&iso, &sphere, 1, 1e-6);
	check_shape(&iso, &(ShapeTraits){.name = "isosurface", .size = 1, .step = 1e-5}, 1000);
	/* Cut by its container: the container's faces close it, unless it is open. */
	desc.function = &large;
	iso = test_shape(&isosurface_class, isosurface_create(arena, &desc));
	check_shape(&iso, &(ShapeTraits){.name = "cut isosurface", .size = 1.2, .step = 1e-5},
		    1000);
	Ray ray = {{0, 0, -5}, {0, 0, 2}, 0, INFINITY};
	Hit hit;
	CHECK(shape_nearest(&iso, &ray, &hit));
	CHECK_NEAR(hit.t, 2, 1e-12);
	desc.open = true;
	iso = test_shape(&isosurface_class, isosurface_create(arena, &desc));
	CHECK(!shape_nearest(&iso, &ray, &hit));
}

typedef struct CountedBall {
	double radius;
	int calls;
} CountedBall;

static double counted_value(const void *data, Vec3 p)
{
	CountedBall *ball = *(CountedBall *const *)data;
	ball->calls++;
	return ball_value(&ball->radius, p);
}

/* What the gradient rules out is not looked at: halving alone takes 41 looks for both
 * sides of the ball. */
static void test_isosurface_looks(Arena *arena)
{
	CountedBall ball = {.radius = 0.8}, *counted = &ball;
	IsosurfaceDesc desc = isosurface_default();
	desc.value = counted_value;
	desc.function = &counted;
	desc.max_trace = 2;
	Shape iso = test_shape(&isosurface_class, isosurface_create(arena, &desc));
	Ray ray = {{0.1, 0.3, -5}, {0, 0, 1}, 0, INFINITY};
	HitList list;
	hit_list_init(&list);
	shape_intersect(&iso, &ray, &list);
	CHECK(list.count == 2);
	CHECK_NEAR(list.hits[0].t, 5 - sqrt(0.64 - 0.1), 1e-9);
	CHECK_NEAR(list.hits[1].t, 5 + sqrt(0.64 - 0.1), 1e-9);
	CHECK(ball.calls <= 32);
	hit_list_free(&list);
}

int main(void)
{
	Arena *arena = arena_create();
	test_quadric(arena);
	test_poly(arena);
	test_high_order(arena);
	test_superellipsoid(arena);
	test_gauge(arena);
	test_blob(arena);
	test_long_blob(arena);
	test_isosurface(arena);
	test_isosurface_looks(arena);
	arena_destroy(arena);
	return CHECK_RESULT();
}
