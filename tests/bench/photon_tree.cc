/*
 * The photon map's search tree beside nanoflann and FLANN, in one run on one thread: 1,000,000
 * clustered points, 262,144 queries in random and in Morton order, k = 50 nearest and a fixed
 * radius with about 50 hits, and the build. The three take turns, so that what else the machine
 * does meets all of them; prints medians of five turns, the medians' ratios, and beside them what
 * is asked. First, all three must find the same distances. C++ because both peers are; the project
 * itself does not use this.
 */
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <memory>
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
constexpr int k = 50, libraries = 3;
/* The peers' default is 10; 20 is the better one for both here. */
int peers_leaf = 20;

/* ---- points and queries ---- */

using Floats = std::vector<float>;

/* Photons of a caustic: clusters of very different density, flat ones among them. */
Floats make_points()
{
	std::mt19937 random(1);
	std::normal_distribution<float> normal;
	std::uniform_real_distribution<float> uniform;
	Floats p;
	for (int cluster = 0; p.size() < 3 * points; cluster++) {
		float center[3] = {uniform(random), uniform(random), uniform(random)};
		float size = 0.002f * std::pow(50.0f, uniform(random));
		float extent[3] = {size, size * (cluster % 2 ? 1.0f : 0.02f), size};
		for (int i = 0; i < 10000 && p.size() < 3 * points; i++)
			for (int axis = 0; axis < 3; axis++)
				p.push_back(center[axis] + extent[axis] * normal(random));
	}
	return p;
}

/* Near the points. */
Floats make_queries(const Floats &p)
{
	std::mt19937 random(2);
	Floats q(3 * queries);
	for (size_t i = 0; i < queries; i++) {
		size_t from = random() % points;
		for (int d = 0; d < 3; d++)
			q[3 * i + d] = p[3 * from + d] + 1e-4f * (random() % 1000 / 500.0f - 1);
	}
	return q;
}

Floats in_morton_order(const Floats &q)
{
	std::vector<uint32_t> order(queries);
	Floats ordered(3 * queries);
	photon_tree_morton(q.data(), queries, 12, order.data());
	for (size_t i = 0; i < queries; i++)
		std::copy_n(&q[3 * order[i]], 3, &ordered[3 * i]);
	return ordered;
}

/* ---- the libraries ---- */

struct Cloud {
	const Floats &p;
	size_t kdtree_get_point_count() const { return points; }
	float kdtree_get_pt(size_t i, size_t d) const { return p[3 * i + d]; }
	template <class B> bool kdtree_get_bbox(B &) const { return false; }
};

using Distance = nanoflann::L2_Simple_Adaptor<float, Cloud>;
using Nano = nanoflann::KDTreeSingleIndexAdaptor<Distance, Cloud, 3, uint32_t>;
using NanoParameters = nanoflann::KDTreeSingleIndexAdaptorParams;
using Flann = flann::Index<flann::L2_3D<float>>;

struct Library {
	virtual ~Library() = default;
	virtual void build(Floats &p) = 0;
	/* Squared distances of the k nearest in no order, d2 has k of them. */
	virtual void nearest(const float *at, float *d2) = 0;
	/* How many are within. */
	virtual size_t within(const float *at, float radius) = 0;
};

void count_found(void *data, const Neighbor *, int count)
{
	*static_cast<size_t *>(data) += static_cast<size_t>(count);
}

struct Ours : Library {
	PhotonTree *tree = nullptr;
	std::vector<Neighbor> found = std::vector<Neighbor>(k + 8 * TREE_SLACK);
	~Ours() override { photon_tree_destroy(tree); }
	void build(Floats &p) override
	{
		photon_tree_destroy(tree);
		TreePoints given = {p.data(), nullptr, nullptr, points, 12, 0};
		tree = photon_tree_create(&given);
	}
	void nearest(const float *at, float *d2) override
	{
		NearestQuery query = {{at[0], at[1], at[2]}, INFINITY, k, nullptr};
		photon_tree_nearest(tree, &query, found.data());
		for (int i = 0; i < k; i++)
			d2[i] = found[i].distance2;
	}
	size_t within(const float *at, float radius) override
	{
		size_t count = 0;
		photon_tree_within(tree, at, radius, count_found, &count);
		return count;
	}
};

struct NanoLibrary : Library {
	std::unique_ptr<Cloud> cloud;
	std::unique_ptr<Nano> tree;
	std::vector<uint32_t> index = std::vector<uint32_t>(k);
	std::vector<std::pair<uint32_t, float>> hits;
	const nanoflann::SearchParams unsorted{32, 0, false};
	void build(Floats &p) override
	{
		tree.reset();
		cloud.reset(new Cloud{p});
		tree.reset(new Nano(3, *cloud, NanoParameters(peers_leaf)));
		tree->buildIndex();
	}
	void nearest(const float *at, float *d2) override
	{
		nanoflann::KNNResultSet<float, uint32_t> result(k);
		result.init(index.data(), d2);
		tree->findNeighbors(result, at, unsorted);
	}
	size_t within(const float *at, float radius) override
	{
		return tree->radiusSearch(at, radius * radius, hits, unsorted);
	}
};

struct FlannLibrary : Library {
	std::unique_ptr<Flann> tree;
	std::vector<size_t> index = std::vector<size_t>(k);
	std::vector<std::vector<size_t>> hits;
	std::vector<Floats> distances;
	flann::SearchParams exact{flann::FLANN_CHECKS_UNLIMITED, 0, false};
	void build(Floats &p) override
	{
		tree.reset(new Flann(flann::Matrix<float>(p.data(), points, 3),
				     flann::KDTreeSingleIndexParams(peers_leaf)));
		tree->buildIndex();
		exact.max_neighbors = -1;
	}
	void nearest(const float *at, float *d2) override
	{
		flann::Matrix<size_t> indices(index.data(), 1, k);
		flann::Matrix<float> found(d2, 1, k);
		flann::Matrix<float> one(const_cast<float *>(at), 1, 3);
		tree->knnSearch(one, indices, found, k, exact);
	}
	size_t within(const float *at, float radius) override
	{
		flann::Matrix<float> one(const_cast<float *>(at), 1, 3);
		int count = tree->radiusSearch(one, hits, distances, radius * radius, exact);
		return static_cast<size_t>(count);
	}
};

/* ---- the same results ---- */

/* To what single precision leaves of sums in another order. */
bool agree(float a, float b) { return std::fabs(a - b) <= 1e-5f * std::fabs(a); }

/* The distances of every query's neighbours, one by one; sets the radius that holds them. Returns
 * how many queries differ. */
size_t compare_nearest(Library *const *all, const Floats &q, Floats &radius)
{
	size_t wrong = 0;
	std::vector<float> d2[libraries];
	for (auto &d : d2)
		d.resize(k);
	for (size_t i = 0; i < queries; i++) {
		bool same = true;
		for (int n = 0; n < libraries; n++) {
			all[n]->nearest(&q[3 * i], d2[n].data());
			std::sort(d2[n].begin(), d2[n].end());
			for (int j = 0; j < k; j++)
				same = same && agree(d2[0][j], d2[n][j]);
		}
		wrong += !same;
		radius[i] = std::sqrt(d2[0][k - 1]);
	}
	return wrong;
}

/* The numbers of hits; one at the very radius may fall to either side. */
size_t compare_within(Library *const *all, const Floats &q, const Floats &radius)
{
	size_t wrong = 0;
	for (size_t i = 0; i < queries; i++) {
		long ours = static_cast<long>(all[0]->within(&q[3 * i], radius[i]));
		for (int n = 1; n < libraries; n++) {
			long theirs = static_cast<long>(all[n]->within(&q[3 * i], radius[i]));
			wrong += std::labs(ours - theirs) > 2;
		}
	}
	return wrong;
}

/* ---- times ---- */

/* Of this thread, so that what else the machine does shows less. */
double cpu_time()
{
	timespec t;
	clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
	return t.tv_sec + 1e-9 * t.tv_nsec;
}

struct Row {
	const char *name;
	double work; /* queries; 0: the table shows seconds */
	double asked[libraries]; /* least ratio to each peer */
	std::function<void(Library &)> run;
};

/* Returns whether what is asked was reached. */
bool measure(Library *const *all, const Row &row, int runs)
{
	std::vector<double> seconds[libraries];
	for (int run = 0; run < runs; run++) {
		for (int n = 0; n < libraries; n++) {
			double start = cpu_time();
			row.run(*all[n]);
			seconds[n].push_back(cpu_time() - start);
		}
	}
	bool reached = true;
	double median[libraries];
	std::printf("%-28s", row.name);
	for (int n = 0; n < libraries; n++) {
		std::sort(seconds[n].begin(), seconds[n].end());
		median[n] = seconds[n][static_cast<size_t>(runs / 2)];
		if (row.work > 0)
			std::printf(" %10.0f", row.work / median[n]);
		else
			std::printf(" %10.3f", median[n]);
	}
	for (int n = 1; n < libraries; n++) {
		std::printf("   %6.2f %5.1f", median[n] / median[0], row.asked[n]);
		reached = reached && median[n] >= row.asked[n] * median[0];
	}
	std::printf("   %s\n", reached ? "reached" : "missed");
	std::fflush(stdout);
	return reached;
}

std::function<void(Library &)> nearest_of(const Floats &q)
{
	return [&q](Library &library) {
		float d2[k];
		for (size_t i = 0; i < queries; i++)
			library.nearest(&q[3 * i], d2);
	};
}

std::function<void(Library &)> within_of(const Floats &q, const Floats &radius)
{
	return [&q, &radius](Library &library) {
		for (size_t i = 0; i < queries; i++)
			library.within(&q[3 * i], radius[i]);
	};
}

} // namespace

/* usage: photon_tree [RUNS [LEAF]]; LEAF: points in a peer's leaf. */
int main(int argc, char **argv)
{
	int runs = argc > 1 ? std::atoi(argv[1]) : 5;
	peers_leaf = argc > 2 ? std::atoi(argv[2]) : peers_leaf;
	omp_set_num_threads(1);
	Ours ours;
	NanoLibrary nano;
	FlannLibrary flann;
	Library *const all[libraries] = {&ours, &nano, &flann};
	Floats p = make_points(), q = make_queries(p), ordered = in_morton_order(q);
	Floats radius(queries), ordered_radius(queries);
	for (Library *library : all)
		library->build(p);
	size_t wrong = compare_nearest(all, q, radius);
	wrong += compare_nearest(all, ordered, ordered_radius);
	wrong += compare_within(all, ordered, ordered_radius);
	std::printf("queries whose distances or hits differ among the three: %zu of %zu\n", wrong,
		    3 * queries);
	std::printf("%-28s %10s %10s %10s   %6s %5s   %6s %5s\n", "medians of runs in turn", "ours",
		    "nanoflann", "FLANN", "/nano", "asked", "/FLANN", "asked");
	const Row rows[] = {
		{"build, seconds", 0, {0, 2, 2}, [&p](Library &library) { library.build(p); }},
		{"50 nearest, random, 1/s", queries, {0, 4, 1.2}, nearest_of(q)},
		{"50 nearest, Morton, 1/s", queries, {0, 4, 1.2}, nearest_of(ordered)},
		{"radius, random, 1/s", queries, {0, 3, 3}, within_of(q, radius)},
		{"radius, Morton, 1/s", queries, {0, 3, 3}, within_of(ordered, ordered_radius)},
	};
	for (const Row &row : rows)
		measure(all, row, runs);
	return wrong != 0;
}
