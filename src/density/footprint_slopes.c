/*
 * The map's derivatives at a photon, from its neighbours in the triangulation and theirs, by a fit
 * that photons across a crease hardly change (footprint_fit.h).
 */
#include "density/footprint_mesh.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/arena.h"
#include "base/median.h"
#include "base/parallel.h"
#include "density/footprint_fit.h"

enum { RING_MOST = 40 };

/* Which vertices are known: a table with open places. */
enum { TABLE_BITS = 7, TABLE = 1 << TABLE_BITS };
static const uint32_t free_place = UINT32_MAX;

/* Whether it was not there. */
static bool put(uint32_t table[TABLE], uint32_t vertex)
{
	uint32_t place = vertex * 2654435769u >> (32 - TABLE_BITS);
	while (table[place] != free_place && table[place] != vertex)
		place = (place + 1) % TABLE;
	bool is_new = table[place] == free_place;
	table[place] = vertex;
	return is_new;
}

/* Neighbours and theirs, each once, without the vertex. */
static int find_neighbors(const Sheet *s, uint32_t vertex, int rings, uint32_t *found)
{
	uint32_t table[TABLE];
	memset(table, 0xff, sizeof table);
	put(table, vertex);
	int count = 1, from = 0;
	found[0] = vertex;
	for (int r = 0; r < rings; r++) {
		int to = count;
		for (int i = from; i < to; i++)
			for (uint32_t k = s->first[found[i]]; k < s->first[found[i] + 1]; k++)
				if (count < RING_MOST && put(table, s->ring[k]))
					found[count++] = s->ring[k];
		from = to;
	}
	memmove(found, found + 1, sizeof *found * (size_t)(count - 1));
	return count - 1;
}

/* Roughness from which a fit starts to be doubted, and from which it counts no more. */
static double doubt_of(double roughness)
{
	static const double low = 0.02, high = 0.3;
	double t = fmax(0, fmin(1, (roughness - low) / (high - low)));
	return t * t * (3 - 2 * t);
}

/* Whether hues are still to be told apart. */
static bool asks_for_hues(const Sheet *s) { return s->task->hues && !s->task->hue_slopes; }

static int take_samples(const Sheet *s, uint32_t vertex, Vec3 u, Vec3 v, double scale,
                        FitSample *samples)
{
	uint32_t found[RING_MOST];
	const Vertex *p = &s->vertices[vertex];
	int around = find_neighbors(s, vertex, asks_for_hues(s) ? 3 : 2, found), count = 0;
	for (int i = 0; i < around; i++) {
		const Vertex *q = &s->vertices[found[i]];
		Vec3 x = vec3_sub(q->at, p->at);
		if (vec3_dot(q->normal, p->normal) < 0.5)
			continue;
		samples[count++] = (FitSample){
			{scale * (q->e[0] - p->e[0]), scale * (q->e[1] - p->e[1])},
			{vec3_dot(x, u), vec3_dot(x, v)},
			asks_for_hues(s) ? footprint_mesh_hue(s, found[i]) -
						   footprint_mesh_hue(s, vertex)
					 : 0};
	}
	return count;
}

static double stretch_of(const Sheet *s, const Vertex *v, uint32_t vertex)
{
	enum { MOST = 32 };
	double ratios[MOST];
	int count = 0;
	for (uint32_t k = s->first[vertex]; k < s->first[vertex + 1] && count < MOST; k++) {
		const Vertex *next = &s->vertices[s->ring[k]];
		double du = next->e[0] - v->e[0], dv = next->e[1] - v->e[1];
		ratios[count++] = vec3_distance(next->at, v->at) / sqrt(du * du + dv * dv);
	}
	return count > 0 ? median(ratios, count) : 0;
}

/* Slopes by hue are averaged: some vertices' do. */
enum { HUE_EVERY = 4 };

static void fit_vertex(void *data, long item, int thread)
{
	(void)thread;
	Sheet *s = data;
	Vertex *p = &s->vertices[item];
	if (!p->used || footprint_mesh_is_stopped(s) ||
	    (asks_for_hues(s) && item % HUE_EVERY != 0))
		return;
	static const double unit = 24; /* photons in the disc of radius 1 of the fit */
	double scale = sqrt(M_PI * p->count / (unit * p->area));
	Vec3 u, v;
	vec3_frame(p->normal, &u, &v);
	FitSample samples[RING_MOST];
	FootprintFit fit;
	int count = take_samples(s, (uint32_t)item, u, v, scale, samples);
	p->fitted = footprint_fit(samples, count, &fit);
	if (!p->fitted)
		return;
	p->stretch = stretch_of(s, p, (uint32_t)item);
	p->trust = 1 - doubt_of(fit.roughness);
	p->roughness = fit.roughness;
	for (int k = 0; k < 2; k++)
		p->slope[k] = vec3_add(vec3_scale(u, scale * fit.jacobian[0][k]),
		                       vec3_scale(v, scale * fit.jacobian[1][k]));
	if (asks_for_hues(s))
		p->hue_slope = vec3_add(vec3_scale(u, fit.hue[0]), vec3_scale(v, fit.hue[1]));
}

/* Single fits' slopes by hue are uncertain: the neighbours' mean counts. */
void footprint_slopes_spread_hues(Sheet *s)
{
	enum { ROUNDS = 12 };
	Pair(*sums)[2] = memory_alloc(sizeof *sums * s->count);
	for (uint32_t i = 0; i < s->count; i++) {
		const Vertex *v = &s->vertices[i];
		Vec3 slope = vec3_scale(v->hue_slope, v->trust);
		sums[i][0] = (Pair){slope.x, slope.y};
		sums[i][1] = (Pair){slope.z, v->trust};
	}
	footprint_mesh_spread(s, sums[0], 2, ROUNDS);
	for (uint32_t i = 0; i < s->count; i++) {
		double total = sums[i][1][1];
		if (total > 1e-3)
			s->vertices[i].hue_slope = vec3_scale(
				vec3(sums[i][0][0], sums[i][0][1], sums[i][1][0]), 1 / total);
	}
	free(sums);
}

void footprint_slopes_fit(Sheet *s)
{
	parallel_for(s->count, 64, fit_vertex, s);
}
