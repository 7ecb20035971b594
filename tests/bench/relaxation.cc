/*
 * Relaxation beside one sweep of 16 nearest neighbours with FLANN over the same photons, in one
 * run on one thread: 863,000 photons of the wave's caustic (wave.h), as many as Table I of Spencer
 * & Jones 2013 has. The sweep's queries go in Morton order, which is FLANN's faster way; the one
 * in the order of emission is shown too. All take turns; prints medians of processor seconds and
 * their ratios to the sweep, and beside them what is asked at most. C++ because FLANN is; the
 * project itself does not use it.
 */
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <vector>

#include <flann/flann.hpp>
#include <omp.h>

#define _Static_assert static_assert /* C's word in the headers */
extern "C" {
#include "base/clock.h"
#include "photon/relax.h"
#include "tests/bench/wave.h"
}

namespace {

constexpr uint32_t photons = 863000;
constexpr int neighbors = 16, iterations = 14;

PhotonMap *make_photons()
{
	PhotonMap *map = photon_map_create();
	map->photons = static_cast<Photon *>(std::calloc(photons + 1, sizeof(Photon)));
	map->count = photons;
	map->lights = static_cast<PhotonLight *>(std::calloc(1, sizeof(PhotonLight)));
	map->lights[0].parameter_dimensions = 2;
	map->light_count = 1;
	Vec3 up = {0, 1, 0};
	for (uint32_t i = 0; i < photons; i++) {
		double from[2], to[2];
		wave_start(&wave_detailed, i + 1, from);
		wave_map(&wave_detailed, from[0], from[1], to);
		Photon *photon = &map->photons[i];
		for (int k = 0; k < 2; k++) {
			photon->position[2 * k] = static_cast<float>(to[k]);
			photon->emitter[k] = static_cast<float>(from[k]);
		}
		photon_set_flux(photon, Rgb{1, 1, 1});
		photon_set_normal(photon, up);
	}
	return map;
}

/* order: of the queries; NULL: as the photons were emitted. */
double flann_sweep(const PhotonMap *map, const uint32_t *order)
{
	std::vector<float> points(3 * photons), queries(3 * photons);
	for (uint32_t i = 0; i < photons; i++) {
		std::memcpy(&points[3 * i], map->photons[i].position, 12);
		std::memcpy(&queries[3 * i], map->photons[order ? order[i] : i].position, 12);
	}
	flann::Matrix<float> given(points.data(), photons, 3);
	flann::Index<flann::L2_3D<float>> tree(given, flann::KDTreeSingleIndexParams(10));
	tree.buildIndex();
	flann::SearchParams exact(-1, 0, false);
	exact.cores = 1;
	std::vector<int> index(neighbors);
	std::vector<float> distance(neighbors);
	double start = clock_cpu();
	for (uint32_t i = 0; i < photons; i++) {
		flann::Matrix<int> indices(index.data(), 1, neighbors);
		flann::Matrix<float> distances(distance.data(), 1, neighbors);
		flann::Matrix<float> query(&queries[3 * i], 1, 3);
		tree.knnSearch(query, indices, distances, neighbors, exact);
	}
	return clock_cpu() - start;
}

/* Processor seconds with that many iterations in all. */
double relax(bool constrained, int count)
{
	PhotonMap *map = make_photons();
	Relaxation settings = relaxation_default();
	settings.constrained = constrained;
	settings.parameter_iterations = settings.world_iterations = count / 2;
	RelaxSurfaces everywhere = {};
	double start = clock_cpu();
	photon_relax(map, &settings, &everywhere, nullptr);
	double seconds = clock_cpu() - start;
	photon_map_destroy(map);
	return seconds;
}

struct Row {
	const char *name;
	double most; /* of the ratio to the sweep; 0: not asked */
	std::vector<double> seconds;
};

enum { EMITTED, SWEEP, FEATURES, CONSTRAINED, PLAIN, ROWS };

double median(std::vector<double> all)
{
	std::sort(all.begin(), all.end());
	return all[all.size() / 2];
}

void measure(Row *rows)
{
	PhotonMap *map = make_photons();
	std::vector<uint32_t> order(photons);
	photon_tree_morton(map->photons->position, photons, sizeof(Photon), order.data());
	rows[EMITTED].seconds.push_back(flann_sweep(map, nullptr));
	rows[SWEEP].seconds.push_back(flann_sweep(map, order.data()));
	photon_map_destroy(map);
	/* No iterations: what comes before them. */
	double features = relax(true, 0), start = relax(false, 0);
	rows[FEATURES].seconds.push_back(features);
	rows[CONSTRAINED].seconds.push_back((relax(true, iterations) - features) / iterations);
	rows[PLAIN].seconds.push_back((relax(false, iterations) - start) / iterations);
}

}

/* usage: relaxation-times [RUNS] */
int main(int argc, char **argv)
{
	int runs = argc > 1 ? std::atoi(argv[1]) : 5;
	omp_set_num_threads(1);
	Row rows[ROWS] = {{"FLANN, 16 nearest, queries as emitted", 0, {}},
			  {"FLANN, 16 nearest, queries in Morton order", 0, {}},
			  {"sorting and feature detection", 3, {}},
			  {"an iteration, constrained (mean of 14)", 1, {}},
			  {"an iteration, plain (mean of 14)", 1, {}}};
	for (int run = 0; run < runs; run++)
		measure(rows);
	double sweep = median(rows[SWEEP].seconds);
	std::printf("%-44s %8s %8s %6s\n", "medians of runs in turn", "seconds", "/ sweep",
		    "asked");
	for (const Row &row : rows) {
		double seconds = median(row.seconds);
		std::printf("%-44s %8.3f %8.2f", row.name, seconds, seconds / sweep);
		if (row.most > 0)
			std::printf(" %6.1f  %s", row.most,
				    seconds <= row.most * sweep ? "reached" : "missed");
		std::printf("\n");
	}
	return 0;
}
