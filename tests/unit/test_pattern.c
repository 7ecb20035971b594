/* Noise, patterns and warps against values that tests/measure_patterns.sh measured with POV-Ray. */
#include "surface/pattern.h"

#include "base/random.h"
#include "surface/pattern_data.h"
#include "surface/warp.h"
#include "tests/unit/check.h"

typedef struct MeasuredPattern { const char *class, *words; double values[4]; } MeasuredPattern;

#include "tests/unit/pattern_data.h"

static const Vec3 points[4] = {
	{0.31, 0.42, 0.53}, {-1.27, 0.88, 2.41}, {3.19, -2.63, -0.77}, {-7.3, 5.9, 11.7}};

/* What a case's words say; zero: nothing. Amount and warp apply first, then scale, then outer. */
typedef struct Case {
	const void *data;
	int generator;
	Vec3 amount; /* the classic turbulence's */
	const Warp *warp;
	double scale;
	const Warp *outer;
	bool has_wave; WaveType wave;
	double frequency, phase, exponent;
} Case;

#define TURBULENCE(x, y, z) .amount = {x, y, z}
#define DATA(type, ...) .data = &(const type){__VA_ARGS__}
#define WARP(name, ...) .warp = &(const Warp){.kind = name, __VA_ARGS__}
#define WAVE(kind) .has_wave = true, .wave = kind
#define FRACTAL_POWER(...) \
	DATA(FractalData, .exterior = 1, .exterior_factor = 1, .interior_factor = 1, __VA_ARGS__)
#define FRACTAL(...) FRACTAL_POWER(.exponent = 2, __VA_ARGS__)
#define MAPPING(...) .u.mapping = {__VA_ARGS__}

static const GradientData along_y = {{0, 1, 0}};

/* In the order of the measured rows. */
static const Case cases[] = {
	{.generator = 1},
	{.generator = 2},
	{.generator = 3},
	{TURBULENCE(0.5, 0.5, 0.5)}, /* bozo */
	{0},
	{0},
	{0},
	{.generator = 1},
	{0}, /* dents, wrinkles, granite, agate */
	{TURBULENCE(0.3, 0.3, 0.3), DATA(AgateData, 0.4)},
	{TURBULENCE(0.7, 0.7, 0.7)},
	{TURBULENCE(0.1, 0.05, 0.2)}, /* marble, wood */
	{0},
	{0},
	{0},
	{DATA(GradientData, {1, 2, 3})}, /* onion, leopard, radial, gradient */
	{.scale = 20},
	{.scale = 20},
	{.scale = 20},
	{.scale = 20}, /* planar to boxed */
	{0},
	{DATA(SpiralData, 3)},
	{DATA(SpiralData, 5)},
	{0},
	{0}, /* quilted, spirals, ripples, waves */
	{0},
	{DATA(BrickData, {1, 1, 1}, 0.2)},
	{0},
	{0},
	{0}, /* checker, brick, hexagon, cubic, cells */
	{0},
	{DATA(CrackleData, {-1, 1, 0}, 1, 0, false)},
	{DATA(CrackleData, {1, 0, 0}, 3, 0.3, false)},
	{DATA(CrackleData, {-1, 1, 0}, 2, 0, true)},
	{FRACTAL(.iterations = 20), .scale = 5},
	{FRACTAL_POWER(.iterations = 20, .exponent = 4, .interior = 1), .scale = 5},
	{FRACTAL(.iterations = 30, .real = 0.353, .imaginary = 0.288), .scale = 5},
	{FRACTAL(.iterations = 30)},
	{FRACTAL(.iterations = 30)},
	{.data = &along_y, WAVE(WAVE_SINE)},
	{.data = &along_y, WAVE(WAVE_SCALLOP)},
	{.data = &along_y, WAVE(WAVE_CUBIC)},
	{.data = &along_y, WAVE(WAVE_POLY), .exponent = 2},
	{.data = &along_y, WAVE(WAVE_TRIANGLE)},
	{.data = &along_y, .frequency = 3, .phase = 0.7},
	{WARP(WARP_REPEAT, .u.repeat = {0, 2, {1, 1, 0}, {0.1, 0.2, 0.3}})},
	{WARP(WARP_PLANAR, MAPPING({1, 0.3, 0.2}, 0.4))},
	{WARP(WARP_CYLINDRICAL, MAPPING({0, 1, 0}, 0.5))},
	{WARP(WARP_SPHERICAL, MAPPING({0, 0, 1}, 1))},
	{WARP(WARP_TOROIDAL, MAPPING({0, 0, 1}, 1, 0.8))},
	{WARP(WARP_CUBIC)},
	{WARP(WARP_BLACK_HOLE, .u.black_hole = {.radius = 2, .strength = 1, .falloff = 3})},
	{TURBULENCE(0.4, 0.4, 0.4), .scale = 2,
	 .outer = &(const Warp){.kind = WARP_TURBULENCE,
				.u.turbulence = {{0.1, 0.2, 0.3}, 6, 3, 0.5}}},
};

enum { CASE_COUNT = sizeof cases / sizeof *cases, ROW_COUNT = sizeof measured / sizeof *measured };

static Pattern make_pattern(Arena *arena, const char *class, const Case *c)
{
	Pattern pattern;
	pattern_init(&pattern, pattern_find(class));
	pattern.data = c->data;
	pattern.noise_generator = c->generator;
	if (vec3_length2(c->amount) > 0) {
		Turbulence t = turbulence_default();
		t.amount = c->amount;
		warp_set_classic(arena, &pattern.warps, &t);
	}
	if (c->warp)
		warp_add(arena, &pattern.warps, c->warp);
	if (c->scale != 0) {
		Transform scale = transform_scale(vec3_all(c->scale));
		warp_add_transform(arena, &pattern.warps, &scale);
	}
	if (c->outer)
		warp_add(arena, &pattern.warps, c->outer);
	if (c->has_wave)
		pattern.wave = c->wave;
	if (c->frequency != 0)
		pattern.frequency = c->frequency;
	pattern.phase = c->phase;
	pattern.exponent = c->exponent != 0 ? c->exponent : 1;
	return pattern;
}

static void test_patterns(Arena *arena)
{
	CHECK(CASE_COUNT == ROW_COUNT);
	for (int i = 0; i < CASE_COUNT; i++) {
		Pattern pattern = make_pattern(arena, measured[i].class, &cases[i]);
		for (int k = 0; k < 4; k++) {
			SurfacePoint at = {.p = points[k]};
			double value = pattern_value(&pattern, &at);
			if (!(fabs(value - measured[i].values[k]) < 1e-12)) {
				check_failures++;
				printf("%s at point %d: %.15f, measured %.15f\n", measured[i].words,
				       k, value, measured[i].values[k]);
			}
		}
	}
}

static void test_vectors(void)
{
	for (int i = 0; i < 2; i++) {
		Turbulence t = {.octaves = i ? 6 : 1, .lambda = 2.3, .omega = 0.6};
		for (int k = 0; k < 4; k++) {
			Vec3 v = turbulence_vector(points[k], &t, 2);
			CHECK_NEAR(v.x, measured_vectors[i][k][0], 1e-12);
			CHECK_NEAR(v.y, measured_vectors[i][k][1], 1e-12);
			CHECK_NEAR(v.z, measured_vectors[i][k][2], 1e-12);
		}
	}
}

static Vec3 random_point(int i)
{
	return vec3(random_uniform(1, (uint64_t)i, 0) * 20 - 10,
		    random_uniform(1, (uint64_t)i, 1) * 20 - 10,
		    random_uniform(1, (uint64_t)i, 2) * 20 - 10);
}

/* Every entry of a list pattern is found, and no other. */
static void test_blocks(void)
{
	static const char *const names[] = {"square",  "triangular", "cubic",
					    "hexagon", "checker",    "brick"};
	for (int n = 0; n < 6; n++) {
		Pattern pattern;
		pattern_init(&pattern, pattern_find(names[n]));
		int seen[6] = {0}, missing = 0;
		for (int i = 0; i < 4000; i++) {
			SurfacePoint at = {.p = random_point(i)};
			int entry = (int)pattern_value(&pattern, &at);
			CHECK(entry >= 0 && entry < pattern.class->list);
			seen[entry] = 1;
		}
		for (int i = 0; i < pattern.class->list; i++)
			missing += !seen[i];
		CHECK(missing == 0);
	}
}

static void test_strange_points(void)
{
	const Vec3 strange[] = {
		{NAN, 0, 0}, {INFINITY, 1, 2}, {1e300, -1e300, 5}, {-1e9, 3e9, 1e12}};
	for (int i = 0; i < 4; i++)
		for (int generator = 1; generator <= 3; generator++) {
			double v = noise_value(strange[i], generator);
			CHECK(isnan(v) || (v >= 0 && v <= 1));
		}
	CHECK(pattern_find("no such pattern") == NULL);
}

int main(void)
{
	Arena *arena = arena_create();
	test_patterns(arena);
	test_vectors();
	test_blocks();
	test_strange_points();
	arena_destroy(arena);
	return CHECK_RESULT();
}
