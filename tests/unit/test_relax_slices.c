/*
 * Slices of the spectrum: how many, which photons are in them, and what relaxation gains.
 */
#include "photon/relax_slices.h"

#include <stdlib.h>
#include <string.h>

#include "base/arena.h"
#include "base/random.h"
#include "photon/relax.h"
#include "surface/texture.h"
#include "tests/unit/check.h"

enum { PHOTONS = 20000 };

static double hue_of(uint32_t i)
{
	return random_uniform(1, i, 2);
}

/* Light through an even pane that parts it: a photon lands beside where it left, by `smear` times
 * its hue, in another direction than those of the emitter's axes. */
static PhotonMap *make_map(double smear, bool on_plane)
{
	PhotonMap *map = photon_map_create();
	map->photons = memory_alloc(sizeof(Photon) * PHOTONS);
	map->count = PHOTONS;
	map->lights = memory_alloc(sizeof *map->lights);
	*map->lights = (PhotonLight){PHOTONS, 1, on_plane ? 2 : 3};
	map->light_count = 1;
	for (uint32_t i = 0; i < PHOTONS; i++) {
		double a = random_uniform(1, i, 0), b = random_uniform(1, i, 1),
		       far = on_plane ? 1 : sqrt(1 + a * a + b * b);
		Photon *p = &map->photons[i];
		*p = (Photon){.length = 1, .edges = 2};
		p->emitter[0] = (float)(a / far);
		p->emitter[1] = (float)(b / far);
		p->emitter[2] = on_plane ? 0 : (float)(1 / far);
		p->position[0] = (float)(a + 0.6 * smear * hue_of(i));
		p->position[2] = (float)(b + 0.8 * smear * hue_of(i));
		photon_set_normal(p, vec3(0, 1, 0));
		photon_set_flux(p, interior_hue_color(hue_of(i)));
	}
	return map;
}

static int count_of(const uint8_t *slices)
{
	int most = 0;
	for (int i = 0; i < PHOTONS; i++)
		most = slices[i] > most ? slices[i] : most;
	return most + 1;
}

/* Slices are those of the hue that the photon was traced with, but beside their borders. */
static double share_right(const uint8_t *slices, int count)
{
	int right = 0;
	for (uint32_t i = 0; i < PHOTONS; i++)
		right += slices[i] == (int)(hue_of(i) * count);
	return (double)right / PHOTONS;
}

/* Photons of one hue would be 1 / sqrt(20000) apart; slices go with about the smear's power 2/3. */
static void test_count(void)
{
	const double spacing = 1 / sqrt(PHOTONS);
	const struct { double smear; int count; } rows[] = {{0, 1}, {1, 1}, {8, 4}, {15, 6}};
	for (int i = 0; i < 4; i++)
		for (int on_plane = 0; on_plane < 2; on_plane++) {
			PhotonMap *map = make_map(rows[i].smear * spacing, on_plane);
			uint8_t *slices = relax_slices(map);
			int count = count_of(slices);
			CHECK(abs(count - rows[i].count) <= i / 2);
			CHECK(share_right(slices, count) > 0.9);
			free(slices);
			photon_map_destroy(map);
		}
}

/* White, and through coloured glass the more the farther: parted by nothing. */
static void test_not_parted(void)
{
	for (int colored = 0; colored < 2; colored++) {
		PhotonMap *map = make_map(0.2, true);
		for (uint32_t i = 0; i < PHOTONS; i++) {
			double thick = colored * random_uniform(1, i, 0);
			photon_set_flux(&map->photons[i],
					rgb(1, (float)exp(-thick), (float)exp(-3 * thick)));
		}
		uint8_t *slices = relax_slices(map);
		CHECK(count_of(slices) == 1);
		free(slices);
		photon_map_destroy(map);
	}
}

/* Variance over square of mean of the red light in cells of a hundred photons, where all hues are.
 */
static double unevenness(const PhotonMap *map, double smear)
{
	enum { CELLS = 12 };
	double cells[CELLS][CELLS] = {{0}}, first = smear, side = (1 - smear) / CELLS, sum = 0,
	       squares = 0;
	for (uint32_t i = 0; i < map->count; i++) {
		const float *p = map->photons[i].position;
		double x = ((double)p[0] - first) / side, z = ((double)p[2] - first) / side;
		if (x >= 0 && x < CELLS && z >= 0 && z < CELLS)
			cells[(int)x][(int)z] += (double)photon_flux(&map->photons[i]).r;
	}
	for (int i = 0; i < CELLS; i++)
		for (int j = 0; j < CELLS; j++) {
			sum += cells[i][j];
			squares += cells[i][j] * cells[i][j];
		}
	double mean = sum / (CELLS * CELLS);
	return squares / (CELLS * CELLS) / (mean * mean) - 1;
}

static double relaxed_unevenness(bool hues)
{
	const double smear = 0.1;
	const RelaxSurfaces everywhere = {.project = NULL};
	PhotonMap *map = make_map(smear, true);
	Relaxation settings = relaxation_default();
	settings.hues = hues;
	CHECK(photon_relax(map, &settings, &everywhere, NULL));
	double result = unevenness(map, smear);
	photon_map_destroy(map);
	return result;
}

static void test_noise(void)
{
	PhotonMap *map = make_map(0.1, true);
	double landed = unevenness(map, 0.1), mixed = relaxed_unevenness(false),
	       sliced = relaxed_unevenness(true);
	CHECK(mixed < landed);
	CHECK(sliced < 0.85 * mixed);
	photon_map_destroy(map);
}

int main(void)
{
	test_count();
	test_not_parted();
	test_noise();
	return CHECK_RESULT();
}
