/* Footprints where light that leaves side by side lands apart. */
#include "tests/unit/footprint_check.h"

/* A crease: one half of the sheet lands elsewhere. No light falls in between, none is lost. */
static void torn(double u, double v, double to[2])
{
	to[0] = u + (u + 0.3 * v > 0.7 ? 1 : 0);
	to[1] = v;
}

static void test_crease(void)
{
	PhotonMap *map = map_by_way(3000, 0, torn);
	DensityEstimator *estimator = footprint_estimator(map, 0);
	double between = 0;
	for (double v = 0.05; v < 0.95; v += 0.01)
		for (double off = 0.1; off < 0.9; off += 0.1)
			between += footprint_light(estimator, 0.7 - 0.3 * v + off, v, 0.01) *
				   0.01 * 0.1;
	CHECK(between < 0.01);
	CHECK_NEAR(footprint_total(estimator, -0.5, 3, 300), 1, 0.005);
	estimator_destroy(estimator);
	photon_map_destroy(map);
}

/* ---- light that goes elsewhere ---- */

/* How likely a photon that leaves within a strip of u, or beyond it, goes elsewhere. */
typedef struct Leak {
	double from, to;
	double within, beyond;
	uint64_t seed;
} Leak;

/* An even sheet; what leaks is of another kind, and lands at another place. */
static PhotonMap *make_leaking(const Leak *leak)
{
	PhotonMap *map = known_map_photons(&(KnownMap){even_way, 0, 1}, 4000, 0);
	for (uint32_t i = 0; i < map->count; i++) {
		Photon *p = &map->photons[i];
		bool within = p->emitter[0] > leak->from && p->emitter[0] < leak->to;
		if (random_uniform(leak->seed, i, 0) < (within ? leak->within : leak->beyond)) {
			p->position[0] += 10;
			p->path = 7;
		}
	}
	photon_map_index(map, 0);
	return map;
}

/* The mean along a line of this u. */
static double density_along(const DensityEstimator *estimator, double u)
{
	double sum = 0;
	for (double v = 0.05; v < 0.95; v += 0.01)
		sum += footprint_light(estimator, u, v, 0) / 90;
	return sum;
}

/* The share of a strip's places that have less than this. */
static double dark_share(const DensityEstimator *estimator, double from, double to, double least)
{
	int dark = 0, points = 0;
	for (double v = 0.05; v < 0.95; v += 0.01)
		for (double u = from; u < to; u += 0.005, points++)
			dark += footprint_light(estimator, u, v, 0) < least;
	return dark / (double)points;
}

/* A gap hardly wider than photons are apart, known from the photons that went elsewhere. */
static void test_gap(void)
{
	static const Leak leak = {.from = 0.48, .to = 0.52, .within = 1};
	PhotonMap *map = make_leaking(&leak);
	DensityEstimator *estimator = footprint_estimator(map, 0);
	CHECK(density_along(estimator, 0.5 * (leak.from + leak.to)) < 0.2);
	CHECK_NEAR(footprint_total(estimator, -0.5, 2, 200), 1 - (leak.to - leak.from), 0.005);
	estimator_destroy(estimator);
	photon_map_destroy(map);
}

/* One in ten, at random, goes elsewhere: no gaps. */
static void test_split(void)
{
	PhotonMap *map = make_leaking(&(Leak){.beyond = 0.1, .seed = 12});
	DensityEstimator *estimator = footprint_estimator(map, 0);
	for (double u = 0.1; u < 0.9; u += 0.02)
		for (double v = 0.1; v < 0.9; v += 0.02)
			CHECK_NEAR(footprint_light(estimator, u, v, 0.01), 0.9, 0.3);
	estimator_destroy(estimator);
	photon_map_destroy(map);
}

/* A kind that is all of the light in a gap and, at random, a fortieth elsewhere: the gap stays one,
 * and there are hardly others. By chance alone, one place in a thousand is among triangles so large
 * that they are taken for gaps. */
static void test_gap_and_split(void)
{
	static const Leak leak = {
		.from = 0.48, .to = 0.56, .within = 1, .beyond = 0.025, .seed = 13};
	PhotonMap *map = make_leaking(&leak);
	DensityEstimator *estimator = footprint_estimator(map, 0);
	CHECK(density_along(estimator, 0.5 * (leak.from + leak.to)) < 0.02);
	CHECK(dark_share(estimator, 0.05, 0.43, 0.5) < 0.004);
	estimator_destroy(estimator);
	photon_map_destroy(map);
}

/* A kind that is all of the light on both sides of a strip and three tenths of it, at random, in
 * the strip, as between where total reflection begins: there the sheet has no gaps. */
static void test_split_strip(void)
{
	static const Leak leak = {
		.from = 0.45, .to = 0.55, .within = 0.3, .beyond = 1, .seed = 14};
	static const double edge = 0.02;
	PhotonMap *map = make_leaking(&leak);
	DensityEstimator *estimator = footprint_estimator(map, 0);
	CHECK(density_along(estimator, leak.from - edge) < 0.02);
	CHECK(dark_share(estimator, leak.from + edge, leak.to - edge, 0.2) < 0.01);
	estimator_destroy(estimator);
	photon_map_destroy(map);
}

/* ---- thinned out ---- */

typedef double Share(double u);

static double gentle_share(double u) { return 0.2 + 0.6 * u; }

/* Over the way of some five photons. */
static double steep_share(double u)
{
	double t = fmax(0, fmin(1, (u - 0.5) / 0.04 + 0.5));
	return 0.1 + 0.8 * t * t * (3 - 2 * t);
}

/* Of photons that a surface thins out at random to a share that depends on u: the
 * density's relative error between two places. */
static double thinned_error(Share *share, double from, double to)
{
	PhotonMap *map = known_map_photons(&(KnownMap){even_way, 0, 1}, 16000, 0);
	uint32_t kept = 0;
	for (uint32_t i = 0; i < map->count; i++)
		if (random_uniform(11, i, 0) < share(map->photons[i].emitter[0]))
			map->photons[kept++] = map->photons[i];
	map->count = kept;
	photon_map_index(map, 0);
	DensityEstimator *estimator = footprint_estimator(map, 0);
	double squares = 0;
	int points = 0;
	for (double u = from; u < to; u += (to - from) / 40) {
		for (double v = 0.1; v < 0.9; v += 0.02, points++) {
			double off = footprint_light(estimator, u, v, 0) / share(u) - 1;
			squares += off * off;
		}
	}
	estimator_destroy(estimator);
	photon_map_destroy(map);
	return sqrt(squares / points);
}

/* One way in some places and another in others: the density stays smooth, yet follows. */
static void test_thinned(void)
{
	/* A window of 30 photons' noise would be 0.18. */
	CHECK_NEAR(thinned_error(gentle_share, 0.1, 0.9), 0, 0.1);
	/* 0.65 by a window of 120 photons alone. */
	CHECK_NEAR(thinned_error(steep_share, 0.44, 0.56), 0, 0.6);
}

int main(void)
{
	test_crease();
	test_gap();
	test_split();
	test_gap_and_split();
	test_split_strip();
	test_thinned();
	return CHECK_RESULT();
}
