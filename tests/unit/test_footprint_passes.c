/* Footprints in progressive passes: the mean converges. */
#include "base/parallel.h"
#include "surface/texture.h"
#include "tests/unit/footprint_check.h"

/* Waves and folds that a hundred photons do not resolve. */
static void wavy(double u, double v, double to[2])
{
	double s = 2 * u - 1;
	to[0] = s * s + 0.05 * sin(14 * s);
	to[1] = v;
}

/* One that they do. */
static void gentle(double u, double v, double to[2])
{
	double s = 2 * u - 1;
	to[0] = s * s + 0.05 * sin(4 * s);
	to[1] = v;
}

/* The density of light from x - pixel / 2 to x + pixel / 2. */
static double folded_truth(KnownWay *way, double x, double pixel)
{
	enum { STEPS = 20000 };
	double to[2];
	int inside = 0;
	for (int i = 0; i < STEPS; i++) {
		way((i + 0.5) / STEPS, 0, to);
		inside += fabs(to[0] - x) < 0.5 * pixel;
	}
	return inside / (STEPS * pixel);
}

/* Some passes, of few photons each; radius: of the first, of the one that a render without a word
 * about it has; it falls with this power of the pass. */
typedef struct Passes {
	int count;
	double radius, power;
} Passes;

static DensityEstimator *make_pass(const PhotonMap *map, const Passes *passes, int pass)
{
	double whole = map->spacing * sqrt(50 / M_PI);
	return footprint_estimator(map, passes->radius * whole * pow(pass + 1, -passes->power));
}

/* Root mean square distance from the truth, relative to it, beside the fold, of the passes' mean
 * along it. */
static double folded_error(KnownWay *way, Passes passes)
{
	enum { POINTS = 20, ALONG = 12, PHOTONS = 150 };
	static const double pixel = 0.02;
	double sums[POINTS] = {0}, error = 0;
	for (int pass = 0; pass < passes.count; pass++) {
		PhotonMap *map = map_by_way(PHOTONS, (uint64_t)pass * PHOTONS, way);
		DensityEstimator *estimator = make_pass(map, &passes, pass);
		for (int i = 0; i < POINTS * ALONG; i++)
			sums[i % POINTS] += footprint_light(estimator, 0.01 + 0.03 * (i % POINTS),
						    0.1 + 0.8 * i / (POINTS * ALONG), pixel) /
					    (passes.count * ALONG);
		estimator_destroy(estimator);
		photon_map_destroy(map);
	}
	for (int i = 0; i < POINTS; i++)
		error += pow(sums[i] / folded_truth(way, 0.01 + 0.03 * i, pixel) - 1, 2) / POINTS;
	return sqrt(error);
}

/* The mean of passes converges as their patches shrink; else the few photons' polygons stay: 256
 * passes are no better than these 32. */
static void test_passes(void)
{
	double even = folded_error(wavy, (Passes){32, 1, 0});
	CHECK(folded_error(wavy, (Passes){256, 1, 1.0 / 3}) < 0.8 * even);
	CHECK(folded_error(wavy, (Passes){256, 0.01, 0}) < 0.4 * even);
}

/* What is right already stays whole for long: all shrinking alike, these have .015. */
static void test_gentle_passes(void)
{
	CHECK(folded_error(gentle, (Passes){64, 1, 1.0 / 6}) < 0.008);
}

/* Where light of this hue lands moves along x; an even sheet's border is an edge of colours. */
static double hue_shift(double hue) { return 0.2 * (hue - 0.5); }

static PhotonMap *make_parted(uint32_t count, uint64_t first)
{
	PhotonMap *map = known_map_photons(&(KnownMap){even_way, 0, 1}, count, first);
	for (uint32_t i = 0; i < count; i++) {
		double hue = random_halton(first + i + 1, 4);
		map->photons[i].position[0] += (float)hue_shift(hue);
		photon_set_flux(&map->photons[i],
				rgb_scale(interior_hue_color(hue), 1 / (float)count));
	}
	photon_map_index(map, 0);
	return map;
}

/* What all hues bring to x: those whose sheet has begun there. */
static Rgb parted_truth(double x)
{
	enum { STEPS = 1000 };
	Rgb sum = {0, 0, 0};
	for (int i = 0; i < STEPS; i++) {
		double hue = (i + 0.5) / STEPS;
		if (x > hue_shift(hue))
			sum = rgb_add(sum, interior_hue_color(hue));
	}
	return rgb_scale(sum, 1.0f / STEPS);
}

/* Root mean square distance from the truth across the border, of the mean along it and of the
 * passes. */
static double parted_error(Passes passes)
{
	enum { POINTS = 24, ALONG = 60 };
	Rgb sums[POINTS] = {{0, 0, 0}};
	double squares = 0;
	for (int pass = 0; pass < passes.count; pass++) {
		PhotonMap *map = make_parted(1000, (uint64_t)pass * 1000);
		DensityEstimator *estimator = make_pass(map, &passes, pass);
		for (int i = 0; i < POINTS * ALONG; i++) {
			GatherPoint point = {.position = vec3(-0.12 + 0.01 * (i % POINTS), 0,
			                                      0.2 + 0.6 * i / (POINTS * ALONG)),
			                     .normal = vec3(0, 1, 0), .footprint = 0.01};
			GatherResult result;
			estimator_gather(estimator, &point, known_map_white, NULL, &result);
			sums[i % POINTS] = rgb_add(sums[i % POINTS], result.radiance);
		}
		estimator_destroy(estimator);
		photon_map_destroy(map);
	}
	for (int i = 0; i < POINTS; i++) {
		Rgb off = rgb_sub(rgb_scale(sums[i], 1 / (float)(passes.count * ALONG)),
				  parted_truth(-0.12 + 0.01 * i));
		squares += (off.r * off.r + off.g * off.g + off.b * off.b) / (3 * POINTS);
	}
	return sqrt(squares);
}

/* So they do across a border of parted light. */
static void test_parted_passes(void)
{
	double even = parted_error((Passes){32, 1, 0});
	CHECK(parted_error((Passes){256, 1, 1.0 / 3}) < 0.9 * even);
	CHECK(parted_error((Passes){64, 0.01, 0}) < 0.7 * even);
}

int main(void)
{
	parallel_set_threads(1); /* more would wait for each other: passes' sheets are small */
	test_passes();
	test_gentle_passes();
	test_parted_passes();
	return CHECK_RESULT();
}
