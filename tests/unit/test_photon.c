/* The photon record, and photon maps as files. */
#include "photon/group.h"
#include "photon/map.h"

#include <stdlib.h>
#include <unistd.h>

#include "base/arena.h"
#include "base/parallel.h"
#include "base/random.h"
#include "tests/unit/check.h"

static Vec3 random_direction(Sampler *s)
{
	double z = 2 * sampler_next(s) - 1, phi = 2 * M_PI * sampler_next(s), r = sqrt(1 - z * z);
	return vec3(r * cos(phi), r * sin(phi), z);
}

static void test_record(void)
{
	Sampler s = {1, 0, 0};
	for (int i = 0; i < 20000; i++) {
		Photon p;
		Vec3 d = i < 6 ? vec3(i % 3 == 0 ? 1 - 2 * (i / 3) : 0,
				      i % 3 == 1 ? 1 - 2 * (i / 3) : 0,
				      i % 3 == 2 ? 1 - 2 * (i / 3) : 0)
			       : random_direction(&s);
		photon_set_direction(&p, d);
		photon_set_normal(&p, d);
		double fine = vec3_distance(photon_direction(&p), d),
		       coarse = vec3_distance(photon_normal(&p), d);
		CHECK(i < 6 ? fine == 0 && coarse == 0 : fine < 1e-4 && coarse < 0.02);
		float scale = (float)exp(60 * (sampler_next(&s) - 0.5));
		Rgb flux = rgb(scale * (float)sampler_next(&s), scale * (float)sampler_next(&s),
			       scale * (float)sampler_next(&s)),
		    got;
		photon_set_flux(&p, flux);
		got = photon_flux(&p);
		CHECK_NEAR(got.r, flux.r, 1.6e-5 * rgb_max(flux));
		CHECK_NEAR(got.g, flux.g, 1.6e-5 * rgb_max(flux));
	}
	Photon p;
	const float hard[] = {0, 1, 0.99999994f, 65535.5f, 1e-30f, 1e30f};
	for (int i = 0; i < 6; i++) {
		photon_set_flux(&p, rgb(hard[i], 0, hard[i] / 3));
		CHECK_NEAR(photon_flux(&p).r, hard[i], 1.6e-5 * hard[i]);
		CHECK(photon_flux(&p).g == 0);
	}
}

/* ---- maps and files ---- */

static PhotonMap *make_map(uint32_t count)
{
	PhotonMap *map = photon_map_create();
	Sampler s = {3, 0, 0};
	map->photons = calloc(count, sizeof(Photon));
	map->count = count;
	map->lights = calloc(2, sizeof(PhotonLight));
	map->light_count = 2;
	map->lights[1] = (PhotonLight){123456, 3.5, 2};
	for (uint32_t i = 0; i < count; i++) {
		Photon *p = &map->photons[i];
		p->position[0] = (float)sampler_next(&s);
		p->position[2] = (float)sampler_next(&s);
		p->emitter[1] = (float)sampler_next(&s);
		p->length = (float)i;
		p->light = (uint16_t)(i & 1);
		p->object = (uint16_t)i;
		p->edges = 3;
		photon_set_flux(p, rgb(1, 0.5f, (float)sampler_next(&s)));
		photon_set_direction(p, random_direction(&s));
		photon_set_normal(p, vec3(0, 1, 0));
	}
	return map;
}

static void check_round_trip(const PhotonMap *map, const char *path, Diag *diag)
{
	CHECK(photon_map_write(map, path, diag));
	PhotonMap *back = photon_map_read(path, diag);
	CHECK(back && back->count == map->count && back->light_count == 2 &&
	      back->lights[1].paths == 123456);
	for (uint32_t i = 0; back && i < map->count; i++)
		CHECK(memcmp(&back->photons[i], &map->photons[i], sizeof(Photon)) == 0);
	CHECK(back && back->relaxed == map->relaxed && !back->constraints == !map->constraints);
	for (uint32_t i = 0; back && map->constraints && i < map->count; i++) {
		const PhotonConstraint *a = &back->constraints[i], *b = &map->constraints[i];
		CHECK(memcmp(a->along, b->along, sizeof a->along) == 0);
		CHECK_NEAR(a->freedom, b->freedom, 1e-6);
	}
	photon_map_destroy(back);
}

/* As if relaxation under constraints had moved the photons, which lie on a plane across y. */
static void constrain(PhotonMap *map)
{
	map->relaxed = true;
	map->constraints = memory_alloc(sizeof(PhotonConstraint) * (map->count + 1));
	for (uint32_t i = 0; i < map->count; i++) {
		double angle = 2 * M_PI * random_uniform(5, i, 0);
		map->constraints[i] = (PhotonConstraint){{(float)cos(angle), 0, (float)sin(angle)},
							 (float)random_uniform(5, i, 1)};
	}
}

/* What no photon and no light can be is refused. */
static void test_unsound(void)
{
	char path[] = "/tmp/photon-map-XXXXXX";
	close(mkstemp(path));
	for (int what = 0; what < 6; what++) {
		Diag *diag = diag_create(NULL);
		PhotonMap *map = make_map(10);
		if (what == 1)
			map->photons[3].position[1] = NAN;
		if (what == 2)
			map->photons[9].emitter[2] = INFINITY;
		if (what == 3)
			map->photons[0].light = (uint16_t)map->light_count;
		if (what == 4)
			map->lights[1].parameter_area = NAN;
		if (what == 5)
			map->lights[1].paths = UINT64_MAX;
		CHECK(photon_map_write(map, path, diag));
		PhotonMap *back = photon_map_read(path, diag);
		CHECK(!back == (what > 0) && diag_errors(diag) == (what > 0));
		photon_map_destroy(back);
		photon_map_destroy(map);
		diag_destroy(diag);
	}
	unlink(path);
}

static void test_map(void)
{
	Diag *diag = diag_create(NULL);
	char path[] = "/tmp/photon-map-XXXXXX";
	close(mkstemp(path));
	PhotonMap *map = make_map(20000);
	photon_map_index(map, 0);
	CHECK_NEAR(map->spacing, sqrt(1.0 / 20000),
		   0.15 * sqrt(1.0 / 20000)); /* a unit square of uniform photons */
	check_round_trip(map, path, diag);
	constrain(map);
	check_round_trip(map, path, diag);
	CHECK(diag_errors(diag) == 0);
	CHECK(truncate(path, 5000) == 0 && !photon_map_read(path, diag) && diag_errors(diag) == 1);
	CHECK(truncate(path, 20) == 0 && !photon_map_read(path, diag) && diag_errors(diag) == 2);
	CHECK(!photon_map_read("/nowhere/map.ply", diag) &&
	      !photon_map_write(map, "/nowhere/map.ply", diag));
	photon_map_destroy(map);
	map = make_map(0);
	photon_map_index(map, 0);
	check_round_trip(map, path, diag);
	photon_map_destroy(map);
	unlink(path);
	diag_destroy(diag);
}

/* Photons of equal keys stand together, in their order; keys differ in high and low digits. */
static void check_group(uint32_t count)
{
	uint64_t *keys = malloc(sizeof *keys * count);
	uint32_t *order = malloc(sizeof *order * count);
	for (uint32_t i = 0; i < count; i++)
		keys[i] = (uint64_t)(i * 7 % 5) << 62 | (uint64_t)(i * 13 % 11) << 30 | i * 17 % 19;
	photon_group(keys, count, order);
	for (uint32_t i = 1; i < count; i++) {
		uint64_t before = keys[order[i - 1]], key = keys[order[i]];
		CHECK(before < key || (before == key && order[i - 1] < order[i]));
	}
	free(keys);
	free(order);
}

static void test_group(void)
{
	check_group(1);
	check_group(300);
	check_group(20000);
	const uint32_t pairs[5][2] = {{3, 1}, {3, 2}, {3, 3}, {4, 4}, {3, 5}};
	CHECK(photon_group_size(pairs[0], sizeof *pairs, 5) == 3);
	CHECK(photon_group_size(pairs[0], sizeof *pairs, 2) == 2);
	CHECK(photon_group_size(pairs[3], sizeof *pairs, 2) == 1);
}

int main(void)
{
	test_group();
	test_record();
	test_map();
	test_unsound();
	return CHECK_RESULT();
}
