/*
 * The gradient of density from the sheet's map, against maps whose density is known; and that
 * relaxation under constraints does not level what it tells.
 */
#include "photon/relax_gradient.h"

#include <stdlib.h>
#include <string.h>

#include "base/arena.h"
#include "base/random.h"
#include "photon/features.h"
#include "tests/unit/check.h"

static const RelaxSurfaces EVERYWHERE = {.project = NULL};

/* Where light from (a, b) falls, its emitter coordinates, and the relative gradient there. */
typedef struct Truth {
	double emitter[3], x, z, gradient[2];
} Truth;

typedef void Map(double a, double b, Truth *truth);

/* Parallel light; det J = (1 + 0.6 a + 0.2 b) (1 - 0.5 b), which the fit can have to the digit. */
static void bend(double a, double b, Truth *truth)
{
	double ja = 1 + 0.6 * a + 0.2 * b, jb = 1 - 0.5 * b;
	*truth = (Truth){{a, b, 0}, a + 0.3 * a * a + 0.2 * a * b, b - 0.25 * b * b, {0, 0}};
	/* J = (ja, 0.2 a; 0, jb), grad rho / rho = -J^-T grad log det J */
	double by_a = 0.6 / ja, by_b = 0.2 / ja - 0.5 / jb;
	truth->gradient[0] = -by_a / ja;
	truth->gradient[1] = -(by_b - 0.2 * a / ja * by_a) / jb;
}

/* A point light one above the plane: as many photons a solid angle. */
static void shine(double a, double b, Truth *truth)
{
	double square = 1 + a * a + b * b, length = sqrt(square);
	*truth = (Truth){{a / length, b / length, 1 / length}, a, b,
			 {-3 * a / square, -3 * b / square}};
}

/* The same seen from the side: where b is a half, light leaves exactly level. */
static void level(double a, double b, Truth *truth)
{
	double y = a - 0.5, z = b - 0.5, square = 1 + y * y + z * z, length = sqrt(square);
	*truth = (Truth){{1 / length, y / length, z / length}, a, b,
			 {-3 * y / square, -3 * z / square}};
}

/* A fold at x = 0, on both sides of which light lands at x > 0. */
static void fold(double a, double b, Truth *truth)
{
	double c = a - 0.5;
	*truth = (Truth){{a, b, 0}, c * c, b, {-0.5 / (c * c), 0}};
}

enum { PHOTONS = 4000 };

/* Anywhere in the unit square; some exactly level. */
static void start(Map *map, uint32_t i, double *a, double *b)
{
	*a = random_uniform(1, i, 0);
	*b = map == level && i % 50 == 0 ? 0.5 : random_uniform(1, i, 1);
}

/* shift: of the blue half of the photons along x. */
static PhotonMap *make_map(Map *map, double shift)
{
	PhotonMap *photons = photon_map_create();
	photons->photons = memory_alloc(sizeof(Photon) * PHOTONS);
	photons->count = PHOTONS;
	photons->lights = memory_alloc(sizeof(PhotonLight));
	photons->lights[0] = (PhotonLight){PHOTONS, 1, map == bend || map == fold ? 2 : 3};
	photons->light_count = 1;
	for (uint32_t i = 0; i < PHOTONS; i++) {
		Photon *photon = &photons->photons[i];
		bool blue = shift > 0 && i % 2 == 0;
		double a, b;
		Truth t;
		start(map, i, &a, &b);
		map(a, b, &t);
		*photon = (Photon){.position = {(float)(t.x + (blue ? shift : 0)), 0, (float)t.z},
				   .edges = 2};
		for (int k = 0; k < 3; k++)
			photon->emitter[k] = (float)t.emitter[k];
		photon_set_flux(photon, blue ? rgb(0, 0.5f, 1) : rgb(1, 0.5f, 0));
		photon_set_normal(photon, vec3(0, 1, 0));
	}
	return photons;
}

/* Largest difference from the truth over photons away from the light's edges. */
static double worst(Map *map, double shift)
{
	PhotonMap *photons = make_map(map, shift);
	RelaxSet set;
	Relaxation settings = relaxation_default();
	double most = 0;
	relax_set_init(&set, photons, &EVERYWHERE, false);
	features_detect(&set, &settings);
	for (uint32_t i = 0; i < set.count; i++) {
		uint32_t number = set.points[i].photon;
		const float *g = set.bases[i].gradient;
		double a, b;
		Truth t;
		start(map, number, &a, &b);
		map(a, b, &t);
		if (fmin(fmin(a, b), fmin(1 - a, 1 - b)) > 0.1)
			most = fmax(most, hypot((double)g[0] - t.gradient[0],
						(double)g[2] - t.gradient[1]));
	}
	relax_set_free(&set);
	photon_map_destroy(photons);
	return most;
}

static void test_maps(void)
{
	CHECK_NEAR(worst(bend, 0), 0, 0.01); /* of 0.2 to 0.9; floats' rounding */
	CHECK_NEAR(worst(shine, 0), 0, 0.1); /* of 0 to 1.5; third order and what lies aside */
	CHECK_NEAR(worst(level, 0), 0, 0.1);
	CHECK_NEAR(worst(bend, 0.03), 0, 0.01); /* half a kernel's radius aside */
}

/* No map: where photons fall has nothing to do with where they left. */
static void test_chaos(void)
{
	PhotonMap *photons = make_map(bend, 0);
	for (uint32_t i = 0; i < PHOTONS; i++) {
		photons->photons[i].position[0] = (float)random_uniform(2, i, 0);
		photons->photons[i].position[2] = (float)random_uniform(2, i, 1);
	}
	RelaxSet set;
	Relaxation settings = relaxation_default();
	settings.range = 1000; /* the nearest in the world */
	int doubted = 0;
	relax_set_init(&set, photons, &EVERYWHERE, false);
	features_detect(&set, &settings);
	for (uint32_t i = 0; i < set.count; i++) {
		const float *g = set.bases[i].gradient;
		doubted += g[0] == 0 && g[2] == 0;
		CHECK(isfinite(g[0]) && g[1] == 0 && isfinite(g[2]));
	}
	CHECK(doubted > PHOTONS / 2);
	relax_set_free(&set);
	photon_map_destroy(photons);
}

/* How far the light in the middle has come towards thin density, on the average. */
static double drift(Relaxation settings)
{
	PhotonMap *photons = make_map(bend, 0), *before = make_map(bend, 0);
	double sum = 0;
	int count = 0;
	photon_relax(photons, &settings, &EVERYWHERE, NULL);
	for (uint32_t i = 0; i < PHOTONS; i++) {
		const Photon *p = &photons->photons[i], *q = &before->photons[i];
		Truth t;
		bend((double)q->emitter[0], (double)q->emitter[1], &t);
		if (fmax(fabs(t.emitter[0] - 0.5), fabs(t.emitter[1] - 0.5)) > 0.25)
			continue;
		double dx = (double)p->position[0] - q->position[0],
		       dz = (double)p->position[2] - q->position[2];
		sum -= (dx * t.gradient[0] + dz * t.gradient[1]) /
		       hypot(t.gradient[0], t.gradient[1]);
		count++;
	}
	photon_map_destroy(photons);
	photon_map_destroy(before);
	return sum / count;
}

static void test_drift(void)
{
	Relaxation plain = relaxation_plain(), constrained = relaxation_default(), paper;
	plain.parameter_iterations = constrained.parameter_iterations;
	plain.world_iterations = constrained.world_iterations;
	double blurred = drift(plain);
	CHECK(blurred > 0);
	CHECK(drift(constrained) < 0.35 * blurred);
	paper = constrained;
	paper.gradient = false;
	CHECK(drift(paper) > 0.7 * blurred);
}

/*
 * How much farther from the fold the light beside it has come, as a part of its distance, where
 * discs of those that push are as wide as the fold is away.
 */
static double flight(Relaxation settings)
{
	PhotonMap *photons = make_map(fold, 0), *before = make_map(fold, 0);
	double was = 0, is = 0;
	photon_relax(photons, &settings, &EVERYWHERE, NULL);
	for (uint32_t i = 0; i < PHOTONS; i++) {
		const float *p = photons->photons[i].position, *q = before->photons[i].position;
		if (q[0] > 0.02f || fabsf(q[2] - 0.5f) > 0.4f)
			continue;
		was += (double)q[0];
		is += (double)p[0];
	}
	photon_map_destroy(photons);
	photon_map_destroy(before);
	return is / was - 1;
}

static void test_fold(void)
{
	Relaxation constrained = relaxation_default(), paper = constrained;
	paper.gradient = false;
	CHECK_NEAR(flight(constrained), 0, 0.003); /* a gradient's push taken off: 0.006 */
	CHECK(flight(paper) > 0.05);
}

static void test_resistance(void)
{
	float still[3] = {0, 0, 0}, force[3] = {1, 2, 3}, steep[3] = {0, 0, 1e6f};
	relax_gradient_resist(still, 1, force);
	CHECK(force[0] == 1 && force[1] == 2 && force[2] == 3);
	relax_gradient_resist(steep, 0, force);
	CHECK(force[2] == 3);
	relax_gradient_resist(steep, 1, force);
	CHECK_NEAR(force[2], 3.2122, 1e-4);
}

int main(void)
{
	test_maps();
	test_chaos();
	test_drift();
	test_fold();
	test_resistance();
	return CHECK_RESULT();
}
