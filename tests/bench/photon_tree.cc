/*
 * The photon map's search tree beside nanoflann and FLANN, in one run on one thread: 1,000,000 clustered points, 262,144
 * queries in random and in Morton order, k = 50 nearest and fixed radius with about 50 hits, and the build. Prints a table of
 * medians of five runs and the ratios. C++ because both peers are; the project itself does not use this.
 */
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <random>
#include <vector>

#include <flann/flann.hpp>
#include <nanoflann.hpp>
#include <omp.h>

extern "C" {
#include "photon/tree.h"
}

namespace {

constexpr size_t points = 1000000, queries = 262144;
constexpr int k = 50;
int runs = 5;

/* Of this thread, so that what else the machine does shows less. */
double cpu_time()
{
	timespec t;
	clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
	return t.tv_sec + 1e-9 * t.tv_nsec;
}

double seconds(const std::function<void()> &work)
{
	double start = cpu_time();
	work();
	return cpu_time() - start;
}

double median_of(const std::function<double()> &measure)
{
	std::vector<double> all;
	for (int i = 0; i < runs; i++)
		all.push_back(measure());
	std::sort(all.begin(), all.end());
	return all[all.size() / 2];
}

/* Photons of a caustic: clusters of very different density, flat ones among them. */
std::vector<float> make_points()
{
	std::mt19937 random(1);
	std::normal_distribution<float> normal;
	std::uniform_real_distribution<float> uniform;
	std::vector<float> p;
	for (int cluster = 0; p.size() < 3 * points; cluster++) {
		float center[3] = {uniform(random), uniform(random), uniform(random)};
		float size = 0.002f * std::pow(50.0f, uniform(random)), flat = cluster % 2 ? 1.0f : 0.02f;
		for (int i = 0; i < 10000 && p.size() < 3 * points; i++)
			for (int axis = 0; axis < 3; axis++)
				p.push_back(center[axis] + size * (axis == 1 ? flat : 1) * normal(random));
	}
	return p;
}

struct Cloud {
	const std::vector<float> &p;
	size_t kdtree_get_point_count() const { return points; }
	float kdtree_get_pt(size_t i, size_t d) const { return p[3 * i + d]; }
	template <class B> bool kdtree_get_bbox(B &) const { return false; }
};

using Nano = nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<float, Cloud>, Cloud, 3>;

struct Row { const char *name; double ours, nano, flann; };

void print(const Row &row, bool rate)
{
	if (rate)
		std::printf("%-34s %10.0f %10.0f %10.0f   %6.2f %6.2f\n", row.name, queries / row.ours, queries / row.nano,
		            queries / row.flann, row.nano / row.ours, row.flann / row.ours);
	else
		std::printf("%-34s %10.3f %10.3f %10.3f   %6.2f %6.2f\n", row.name, row.ours, row.nano, row.flann,
		            row.nano / row.ours, row.flann / row.ours);
}

/* What every library must agree on: the sum of the k-th distances, and the number of hits. */
double checks[3];

void nearest(const char *name, const PhotonTree *tree, const Nano &nano, flann::Index<flann::L2_3D<float>> &flann_tree,
             const std::vector<float> &q)
{
	Row row = {name, 0, 0, 0};
	row.ours = median_of([&] {
		return seconds([&] {
			std::vector<Neighbor> found(k + 8 * TREE_SLACK);
			checks[0] = 0;
			for (size_t i = 0; i < queries; i++) {
				NearestQuery query = {{q[3 * i], q[3 * i + 1], q[3 * i + 2]}, INFINITY, k, nullptr};
				int n = photon_tree_nearest(tree, &query, found.data());
				checks[0] += std::sqrt(photon_tree_farthest(found.data(), n));
			}
		});
	});
	row.nano = median_of([&] {
		return seconds([&] {
			std::vector<uint32_t> index(k);
			std::vector<float> d2(k);
			checks[1] = 0;
			for (size_t i = 0; i < queries; i++) {
				nanoflann::KNNResultSet<float, uint32_t> result(k);
				result.init(index.data(), d2.data());
				nano.findNeighbors(result, &q[3 * i], nanoflann::SearchParams());
				checks[1] += std::sqrt(d2[k - 1]);
			}
		});
	});
	row.flann = median_of([&] {
		return seconds([&] {
			std::vector<size_t> index(k);
			std::vector<float> d2(k);
			flann::SearchParams parameters(flann::FLANN_CHECKS_UNLIMITED, 0, false);
			checks[2] = 0;
			for (size_t i = 0; i < queries; i++) {
				flann::Matrix<float> one(const_cast<float *>(&q[3 * i]), 1, 3), d(d2.data(), 1, k);
				flann::Matrix<size_t> n(index.data(), 1, k);
				flann_tree.knnSearch(one, n, d, k, parameters);
				checks[2] += std::sqrt(*std::max_element(d2.begin(), d2.end()));
			}
		});
	});
	print(row, true);
}

void count_visit(void *data, const Neighbor *found, int count)
{
	double *sum = static_cast<double *>(data);
	for (int i = 0; i < count; i++)
		*sum += found[i].distance2;
	sum[1] += count;
}

void within(const char *name, const PhotonTree *tree, const Nano &nano, flann::Index<flann::L2_3D<float>> &flann_tree,
            const std::vector<float> &q, const std::vector<float> &radius)
{
	Row row = {name, 0, 0, 0};
	row.ours = median_of([&] {
		return seconds([&] {
			double sum[2] = {0, 0};
			for (size_t i = 0; i < queries; i++)
				photon_tree_within(tree, &q[3 * i], radius[i], count_visit, sum);
			checks[0] = sum[1];
		});
	});
	row.nano = median_of([&] {
		return seconds([&] {
			std::vector<std::pair<uint32_t, float>> result;
			nanoflann::SearchParams parameters(32, 0, false);
			checks[1] = 0;
			for (size_t i = 0; i < queries; i++)
				checks[1] += nano.radiusSearch(&q[3 * i], radius[i] * radius[i], result, parameters);
		});
	});
	row.flann = median_of([&] {
		return seconds([&] {
			std::vector<std::vector<size_t>> index;
			std::vector<std::vector<float>> d2;
			flann::SearchParams parameters(flann::FLANN_CHECKS_UNLIMITED, 0, false);
			parameters.max_neighbors = -1;
			checks[2] = 0;
			for (size_t i = 0; i < queries; i++) {
				flann::Matrix<float> one(const_cast<float *>(&q[3 * i]), 1, 3);
				checks[2] += flann_tree.radiusSearch(one, index, d2, radius[i] * radius[i], parameters);
			}
		});
	});
	print(row, true);
}

/* Agreement to what single precision leaves: a point at the very radius may fall to either side. */
int disagree(const char *what)
{
	for (int i = 1; i < 3; i++) {
		if (std::fabs(checks[i] - checks[0]) > 1e-4 * std::fabs(checks[0])) {
			std::printf("%s: the libraries disagree: %.9g %.9g %.9g\n", what, checks[0], checks[1], checks[2]);
			return 1;
		}
	}
	return 0;
}

} // namespace

int main(int argc, char **argv)
{
	if (argc > 1)
		runs = std::atoi(argv[1]);
	omp_set_num_threads(1);
	std::vector<float> p = make_points(), q(3 * queries), ordered(3 * queries), radius(queries), ordered_radius(queries);
	std::mt19937 random(2);
	for (size_t i = 0; i < queries; i++) {
		size_t from = random() % points;
		for (int d = 0; d < 3; d++)
			q[3 * i + d] = p[3 * from + d] + 1e-4f * (random() % 1000 / 500.0f - 1);
	}
	TreePoints given = {p.data(), nullptr, nullptr, points, 12, 0};
	PhotonTree *tree = photon_tree_create(&given);
	std::vector<Neighbor> found(k + 8 * TREE_SLACK);
	for (size_t i = 0; i < queries; i++) {
		NearestQuery query = {{q[3 * i], q[3 * i + 1], q[3 * i + 2]}, INFINITY, k, nullptr};
		int n = photon_tree_nearest(tree, &query, found.data());
		radius[i] = std::sqrt(photon_tree_farthest(found.data(), n));
	}
	std::vector<uint32_t> order(queries);
	photon_tree_morton(q.data(), queries, 12, order.data());
	for (size_t i = 0; i < queries; i++) {
		ordered_radius[i] = radius[order[i]];
		for (int d = 0; d < 3; d++)
			ordered[3 * i + d] = q[3 * order[i] + d];
	}
	Cloud cloud{p};
	Nano nano(3, cloud, nanoflann::KDTreeSingleIndexAdaptorParams(10));
	nano.buildIndex();
	flann::Matrix<float> matrix(p.data(), points, 3);
	flann::Index<flann::L2_3D<float>> flann_tree(matrix, flann::KDTreeSingleIndexParams(10));
	flann_tree.buildIndex();

	std::printf("%-34s %10s %10s %10s   %6s %6s\n", "", "ours", "nanoflann", "FLANN", "/nano", "/FLANN");
	Row build = {"build, seconds", 0, 0, 0};
	build.ours = median_of([&] { return seconds([&] { photon_tree_destroy(photon_tree_create(&given)); }); });
	build.nano = median_of([&] {
		return seconds([&] {
			Nano again(3, cloud, nanoflann::KDTreeSingleIndexAdaptorParams(10));
			again.buildIndex();
		});
	});
	build.flann = median_of([&] {
		return seconds([&] {
			flann::Index<flann::L2_3D<float>> again(matrix, flann::KDTreeSingleIndexParams(10));
			again.buildIndex();
		});
	});
	print(build, false);
	int bad = 0;
	nearest("50 nearest, random, queries/s", tree, nano, flann_tree, q);
	bad += disagree("nearest");
	nearest("50 nearest, Morton, queries/s", tree, nano, flann_tree, ordered);
	bad += disagree("nearest, Morton");
	within("radius, random, queries/s", tree, nano, flann_tree, q, radius);
	bad += disagree("radius");
	within("radius, Morton, queries/s", tree, nano, flann_tree, ordered, ordered_radius);
	bad += disagree("radius, Morton");
	photon_tree_destroy(tree);
	return bad != 0;
}
