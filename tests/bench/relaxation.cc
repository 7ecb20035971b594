/*
 * Relaxation beside one sweep of 16 nearest neighbours with FLANN over the same photons, in one
 * run on one thread: 863,000 photons of the wave's caustic (wave.h), as many as Table I of Spencer
 * & Jones 2013 has. Prints seconds and the ratios to that sweep: feature detection, one iteration.
 * C++ because FLANN is; the project itself does not use it.
 */
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <vector>

#include <flann/flann.hpp>
#include <omp.h>

#define _Static_assert static_assert /* C's word in the headers */
extern "C" {
#include "photon/relax.h"
#include "tests/bench/wave.h"
}

namespace {

constexpr uint32_t photons = 863000;
constexpr int neighbors = 16, iterations = 14;

double now()
{
	return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

PhotonMap *make_photons()
{
	PhotonMap *map = photon_map_create();
	map->photons = static_cast<Photon *>(std::calloc(photons + 1, sizeof(Photon)));
	map->count = photons;
	Vec3 up = {0, 1, 0};
	for (uint32_t i = 0; i < photons; i++) {
		double from[2], to[2];
		wave_start(i + 1, from);
		wave_map(from[0], from[1], to);
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
	flann::Index<flann::L2_3D<float>> tree(flann::Matrix<float>(points.data(), photons, 3), flann::KDTreeSingleIndexParams(10));
	tree.buildIndex();
	flann::SearchParams exact(-1, 0, false);
	exact.cores = 1;
	std::vector<int> index(neighbors);
	std::vector<float> distance(neighbors);
	double start = now();
	for (uint32_t i = 0; i < photons; i++) {
		flann::Matrix<int> indices(index.data(), 1, neighbors);
		flann::Matrix<float> distances(distance.data(), 1, neighbors);
		tree.knnSearch(flann::Matrix<float>(&queries[3 * i], 1, 3), indices, distances, neighbors, exact);
	}
	return now() - start;
}

RelaxStatistics relax(bool constrained)
{
	PhotonMap *map = make_photons();
	Relaxation settings = relaxation_default();
	settings.constrained = constrained;
	settings.parameter_iterations = settings.world_iterations = iterations / 2;
	RelaxSurfaces everywhere = {nullptr, 0, nullptr, nullptr};
	RelaxStatistics statistics;
	photon_relax(map, &settings, &everywhere, &statistics);
	photon_map_destroy(map);
	return statistics;
}

}

int main()
{
	omp_set_num_threads(1);
	PhotonMap *map = make_photons();
	std::vector<uint32_t> order(photons);
	photon_tree_morton(map->photons->position, photons, sizeof(Photon), order.data());
	double emitted = flann_sweep(map, nullptr), sorted = flann_sweep(map, order.data());
	photon_map_destroy(map);
	RelaxStatistics constrained = relax(true), plain = relax(false);
	std::printf("%-44s %8s %10s %10s\n", "", "seconds", "/ emitted", "/ Morton");
	auto row = [&](const char *name, double seconds) {
		std::printf("%-44s %8.3f %10.2f %10.2f\n", name, seconds, seconds / emitted, seconds / sorted);
	};
	row("FLANN, 16 nearest, queries as emitted", emitted);
	row("FLANN, 16 nearest, queries in Morton order", sorted);
	row("feature detection", constrained.feature_seconds);
	row("an iteration, constrained (mean of 14)", constrained.seconds / iterations);
	row("an iteration, plain (mean of 14)", plain.seconds / iterations);
	return 0;
}
