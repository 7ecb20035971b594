/* Arena, small systems, transforms, random numbers and diagnostics. */
#include "base/arena.h"
#include "base/cholesky.h"
#include "base/diag.h"
#include "base/median.h"
#include "base/parallel.h"
#include "base/random.h"
#include "base/transform.h"
#include "tests/unit/check.h"

static void test_arena(void)
{
	Arena *arena = arena_create();
	char *kept = arena_strdup(arena, "kept");
	ArenaMark mark = arena_mark(arena);
	for (int i = 0; i < 1000; i++) {
		char *block = arena_alloc(arena, 5000);
		CHECK(block[0] == 0 && block[4999] == 0 && ((size_t)block & 15) == 0);
		memset(block, 255, 5000);
	}
	size_t full = arena_bytes(arena);
	arena_rewind(arena, mark);
	CHECK(arena_bytes(arena) < full);
	CHECK_STRING(kept, "kept");
	CHECK(((char *)arena_alloc(arena, 100))[50] == 0);
	CHECK_STRING(arena_printf(arena, "%d-%s", 7, "x"), "7-x");
	arena_destroy(arena);
}

static void check_point(Vec3 p, double x, double y, double z)
{
	CHECK_NEAR(p.x, x, 1e-12);
	CHECK_NEAR(p.y, y, 1e-12);
	CHECK_NEAR(p.z, z, 1e-12);
}

static void test_transform(void)
{
	/* POV-Ray: rotating x by 90 degrees about z gives y; z by 90 about y gives x; y by 90 about
	 * x gives z. */
	Transform r = transform_rotate(vec3(0, 0, 90));
	check_point(transform_point(&r, vec3(1, 0, 0)), 0, 1, 0);
	r = transform_rotate(vec3(0, 90, 0));
	check_point(transform_point(&r, vec3(0, 0, 1)), 1, 0, 0);
	r = transform_rotate(vec3(90, 0, 0));
	check_point(transform_point(&r, vec3(0, 1, 0)), 0, 0, 1);
	Transform a = transform_rotate(vec3(20, 30, 40)), b = transform_scale(vec3(1, 2, 3)),
		  c = transform_translate(vec3(4, 5, 6));
	Transform t = transform_compose(&a, &b);
	t = transform_compose(&t, &c);
	Vec3 p = vec3(0.3, -0.7, 1.1),
	     q = transform_point(&c, transform_point(&b, transform_point(&a, p)));
	check_point(transform_point(&t, p), q.x, q.y, q.z);
	check_point(transform_point_inverse(&t, q), p.x, p.y, p.z);
	double scale, rows[12] = {1, 2, 0, 0, 1, 0, 0, 3, 2, 7, 8, 9};
	CHECK(transform_is_similarity(&a, &scale) && fabs(scale - 1) < 1e-12 &&
	      !transform_is_similarity(&t, &scale));
	CHECK(transform_matrix(rows, &t));
	check_point(transform_point(&t, vec3(1, 0, 0)), 8, 10, 9);
	check_point(transform_point_inverse(&t, vec3(8, 10, 9)), 1, 0, 0);
	CHECK(!transform_matrix((double[12]){1, 0, 0, 2, 0, 0, 0, 0, 1, 0, 0, 0}, &t) &&
	      transform_is_identity(&t));
	/* A normal stays orthogonal to its plane. */
	t = transform_compose(&a, &b);
	CHECK_NEAR(
		vec3_dot(transform_normal(&t, vec3(1, 0, 0)), transform_vector(&t, vec3(0, 1, 1))),
		0, 1e-12);
	Box3 half = transform_box(&a, (Box3){{-INFINITY, 0, 0}, {0, 1, 1}});
	CHECK(!box3_is_empty(half) && half.lo.x == -INFINITY);
}

static void test_random(void)
{
	CHECK_NEAR(random_halton(1, 0), 0.5, 0);
	CHECK_NEAR(random_halton(5, 1), 2.0 / 3 + 1.0 / 9, 1e-15);
	double run[100];
	for (int dimension = 0; dimension < 5; dimension++) {
		random_halton_run(1234567, dimension, 100, run);
		for (uint64_t i = 0; i < 100; i++)
			CHECK_NEAR(run[i], random_halton(1234567 + i, dimension), 1e-15);
	}
	double sum = 0, sum2 = 0;
	Sampler sampler = {1, 2, 0};
	for (int i = 0; i < 100000; i++) {
		double x = sampler_next(&sampler);
		CHECK(x >= 0 && x < 1);
		sum += x;
		sum2 += x * x;
	}
	/* five standard deviations of the mean of 100000 uniforms */
	CHECK_NEAR(sum / 1e5, 0.5, 5 * 0.2887 / sqrt(1e5));
	CHECK_NEAR(sum2 / 1e5, 1.0 / 3, 5 * 0.2981 / sqrt(1e5));
}

static void test_frame(void)
{
	for (int i = 0; i < 100; i++) {
		Sampler s = {3, (uint64_t)i, 0};
		Vec3 n = vec3(sampler_next(&s) - 0.5, sampler_next(&s) - 0.5,
			      i % 10 ? sampler_next(&s) - 0.5 : 0),
		     u, v;
		n = vec3_normalize(n);
		vec3_frame(n, &u, &v);
		Vec3 w = vec3_cross(u, v);
		check_point(w, n.x, n.y, n.z);
		CHECK_NEAR(vec3_dot(u, v), 0, 1e-12);
	}
}

static void test_diag(void)
{
	FILE *out = tmpfile();
	Diag *diag = diag_create(out);
	const char *text = "one\n\ttwo bad\nthree\n";
	uint32_t source = diag_add_source(diag, "a.pov", text, strlen(text));
	Expansion expansion = {{source, 0, NULL}, "Ball"};
	diag_error(diag, (Location){source, 9, &expansion}, "no %s", "good");
	diag_warning(diag, (Location){source, 4000, NULL}, "end");
	CHECK(diag_errors(diag) == 1);
	char seen[1000] = {0};
	rewind(out);
	CHECK(fread(seen, 1, sizeof seen - 1, out) > 0);
	CHECK_STRING(seen, "a.pov:2:6: error: no good\n    2 | \ttwo bad\n      | \t    ^\n"
	                   "  in macro 'Ball', called at a.pov:1:1\n"
	                   "a.pov:4:1: warning: end\n    4 | \n      | ^\n");
	diag_destroy(diag);
	fclose(out);
}

static void square(void *data, long item, int thread)
{
	(void)thread;
	((long *)data)[item] = item * item;
}

static void test_parallel(void)
{
	long squares[1000];
	parallel_for(1000, 7, square, squares);
	for (long i = 0; i < 1000; i++)
		CHECK(squares[i] == i * i);
}

/* M = L L' with a known L, x known, in rows longer than the system. */
static void test_cholesky(void)
{
	enum { SIZE = 3, STRIDE = 4 };
	const double l[SIZE][SIZE] = {{2, 0, 0}, {-1, 3, 0}, {0.5, 4, 1}}, x[SIZE] = {1, -2, 7};
	double m[SIZE][STRIDE] = {{0}}, b[SIZE] = {0};
	for (int i = 0; i < SIZE; i++) {
		for (int j = 0; j < SIZE; j++) {
			double sum = 0;
			for (int k = 0; k < SIZE; k++)
				sum += l[i][k] * l[j][k];
			m[i][j] = j <= i ? sum : NAN;
			b[i] += sum * x[j];
		}
	}
	CHECK(cholesky_factor(m[0], STRIDE, SIZE, 1e-9));
	for (int i = 0; i < SIZE; i++)
		for (int j = 0; j <= i; j++)
			CHECK_NEAR(m[i][j], l[i][j], 1e-12);
	cholesky_forward(m[0], STRIDE, SIZE, b);
	for (int i = 0; i < SIZE; i++) /* L' x */
		CHECK_NEAR(b[i], l[0][i] * x[0] + l[1][i] * x[1] + l[2][i] * x[2], 1e-12);
	cholesky_back(m[0], STRIDE, SIZE, b);
	for (int i = 0; i < SIZE; i++)
		CHECK_NEAR(b[i], x[i], 1e-12);
	double twice[2][2] = {{1, 0}, {2, 4}}; /* the second unknown is twice the first */
	CHECK(!cholesky_factor(twice[0], 2, 2, 1e-9));
}

/* The value with as many below it as above, by sorting. */
static void test_median(void)
{
	static const double few[] = {3}, even[] = {4, 1, 3, 2}, equal[] = {2, 1, 2, 2, 5};
	static const double far[] = {INFINITY, 1, INFINITY};
	CHECK(median(few, 1) == 3 && median(even, 4) == 3 && median(equal, 5) == 2);
	CHECK(median(even, 3) == 3 && isinf(median(far, 3)) && median(far, 2) == INFINITY);
	double values[MEDIAN_MOST], sorted[MEDIAN_MOST];
	for (int count = MEDIAN_MOST - 1; count <= MEDIAN_MOST; count++) {
		for (int i = 0; i < count; i++) {
			values[i] = floor(700 * random_uniform(1, (uint64_t)i, (uint64_t)count));
			int at = i;
			for (; at > 0 && sorted[at - 1] > values[i]; at--)
				sorted[at] = sorted[at - 1];
			sorted[at] = values[i];
		}
		CHECK(median(values, count) == sorted[count / 2]);
	}
}

int main(void)
{
	test_median();
	test_arena();
	test_transform();
	test_random();
	test_frame();
	test_diag();
	test_parallel();
	test_cholesky();
	return CHECK_RESULT();
}
