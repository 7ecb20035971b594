#include "density/footprint_mesh.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/arena.h"
#include "base/median.h"
#include "density/footprint_delaunay.h"
#include "density/footprint_strangers.h"
#include "photon/tree.h"

static const Photon *photon_of(const Sheet *s, uint32_t vertex)
{
	return &s->task->map->photons[s->task->photons[vertex]];
}

bool footprint_mesh_is_stopped(const Sheet *s) { return s->task->stop && *s->task->stop; }

/* ---- chart ---- */

static Chart make_chart(const SheetTask *task)
{
	const PhotonMap *map = task->map;
	const Photon *p = &map->photons[task->photons[0]];
	Chart chart = {.plane = photon_map_on_plane(map, p)};
	Vec3 sum = vec3(0, 0, 0);
	for (uint32_t i = 0; i < task->count; i++)
		sum = vec3_add(sum, vec3_of_floats(map->photons[task->photons[i]].emitter));
	double length = vec3_length(sum);
	chart.middle = length > 0 ? vec3_scale(sum, 1 / length) : vec3(0, 0, 1);
	vec3_frame(chart.middle, &chart.u, &chart.v);
	return chart;
}

void footprint_mesh_chart(const Sheet *s, const float emitter[3], double out[2])
{
	const Chart *chart = &s->chart;
	static const double least = 1e-3; /* the point across from the middle is infinitely far */
	Vec3 e = vec3_of_floats(emitter);
	double scale = chart->plane ? 1 : 2 / fmax(least, 1 + vec3_dot(e, chart->middle));
	out[0] = chart->plane ? e.x : scale * vec3_dot(e, chart->u);
	out[1] = chart->plane ? e.y : scale * vec3_dot(e, chart->v);
}

double footprint_mesh_hue(const Sheet *s, uint32_t vertex)
{
	return s->task->hues ? s->task->hues[vertex] : 0;
}

double footprint_mesh_hue_shrink(const Sheet *s)
{
	return fmin(1, s->task->scale * s->task->shrink);
}

/* Moves the vertex to where it were if it had the slice's hue; as patches shrink, less far. */
static void settle_hue(Sheet *s, uint32_t vertex)
{
	Vertex *v = &s->vertices[vertex];
	double off = footprint_mesh_hue_shrink(s) * (s->task->hue - footprint_mesh_hue(s, vertex));
	v->hue_slope = vec3_of_floats(s->task->hue_slopes[vertex]);
	v->at = vec3_mad(v->at, off, v->hue_slope);
}

static void make_vertices(Sheet *s)
{
	s->chart = make_chart(s->task);
	s->count = s->task->count;
	s->vertices = memory_alloc_wide(sizeof *s->vertices * s->count);
	for (uint32_t i = 0; i < s->count; i++) {
		const Photon *p = photon_of(s, i);
		Rgb flux = photon_flux(p);
		s->vertices[i] = (Vertex){.at = vec3_of_floats(p->position),
		                          .normal = photon_normal(p),
		                          .flux = {flux.r, flux.g, flux.b},
		                          .own = {flux.r, flux.g, flux.b}};
		footprint_mesh_chart(s, p->emitter, s->vertices[i].e);
		if (s->task->hue_slopes)
			settle_hue(s, i);
	}
}

/* ---- triangles ---- */

static double area_of(const Sheet *s, const uint32_t t[3])
{
	const Vertex *v = s->vertices;
	return 0.5 * footprint_cross(v[t[0]].e, v[t[1]].e, v[t[2]].e);
}

static double distance2(const double a[2], const double b[2])
{
	return (a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1]);
}

static double circle_radius2(const Sheet *s, const uint32_t t[3])
{
	const double *a = s->vertices[t[0]].e, *b = s->vertices[t[1]].e, *c = s->vertices[t[2]].e;
	double area = area_of(s, t);
	return distance2(a, b) * distance2(b, c) * distance2(c, a) / (16 * area * area);
}

/* Each vertex' list of what follows it in its triangles; of the inner ones, all neighbours once.
 * take: the triangle's number instead. */
static void make_rings(Sheet *s, bool take)
{
	uint32_t *first = s->first;
	memset(first, 0, sizeof *first * ((size_t)s->count + 2));
	for (uint32_t t = 0; t < s->triangle_count; t++)
		for (int k = 0; k < 3; k++)
			first[s->triangles[t][k] + 2]++;
	for (uint32_t i = 2; i < s->count + 2; i++)
		first[i] += first[i - 1];
	for (uint32_t t = 0; t < s->triangle_count; t++)
		for (int k = 0; k < 3; k++)
			s->ring[first[s->triangles[t][k] + 1]++] =
				take ? t : s->triangles[t][(k + 1) % 3];
}

/* From the median triangle around: across gaps and along the border they are large. */
static void set_space(Sheet *s, uint32_t vertex)
{
	enum { MOST = 32 };
	double areas[MOST];
	int count = 0;
	for (uint32_t k = s->first[vertex]; k < s->first[vertex + 1] && count < MOST; k++)
		areas[count++] = area_of(s, s->triangles[s->ring[k]]);
	s->vertices[vertex].space = count > 0 ? 2 * median(areas, count) : 0;
}

/* Triangles that reach over a gap of the sheet or along its border: their circles are large beside
 * what photons are apart. At random, five in ten thousand are dropped. */
bool footprint_mesh_bridges(const Sheet *s, const uint32_t t[3])
{
	static const double most_radius2 = 4;
	double space = INFINITY;
	for (int k = 0; k < 3; k++)
		space = fmin(space, s->vertices[t[k]].space);
	return !(circle_radius2(s, t) < most_radius2 * space);
}

static void drop_bridges(Sheet *s)
{
	uint32_t kept = 0;
	bool *gaps = memory_alloc(s->triangle_count + 1);
	memset(gaps, 0, s->triangle_count + 1);
	for (uint32_t i = 0; i < s->count; i++)
		set_space(s, i);
	if (s->task->strangers)
		footprint_strangers_find(s, gaps);
	for (uint32_t t = 0; t < s->triangle_count; t++) {
		if (gaps[t] || footprint_mesh_bridges(s, s->triangles[t]))
			continue;
		memmove(s->triangles[kept++], s->triangles[t], sizeof *s->triangles);
	}
	s->triangle_count = kept;
	free(gaps);
}

static void make_triangles(Sheet *s)
{
	double (*points)[2] = memory_alloc(sizeof *points * s->count);
	for (uint32_t i = 0; i < s->count; i++)
		memcpy(points[i], s->vertices[i].e, sizeof *points);
	Triangulation all = footprint_triangulate((const double (*)[2])points, s->count);
	free(points);
	s->triangles = all.corners;
	s->triangle_count = all.count;
	s->first = memory_alloc(sizeof *s->first * ((size_t)s->count + 2));
	s->ring = memory_alloc_wide(sizeof *s->ring * (3 * (size_t)all.count + 1));
	make_rings(s, true);
	drop_bridges(s);
	make_rings(s, false);
	footprint_mesh_link(s);
}

/* ---- density of photons in the chart ---- */

/* Half a photon belongs to each triangle: right at borders, too. */
static void count_photons(Sheet *s)
{
	for (uint32_t t = 0; t < s->triangle_count; t++) {
		double area = area_of(s, s->triangles[t]);
		for (int k = 0; k < 3; k++) {
			s->vertices[s->triangles[t][k]].count += 1.0 / 6;
			s->vertices[s->triangles[t][k]].area += area / 3;
		}
	}
}

/* Windows of some 30 photons and of some 120. */
enum { NEAR_ROUNDS = 8, FAR_ROUNDS = 32 };

static double ratio_of(Pair p) { return p[1] > 0 ? p[0] / p[1] : 0; }

/* Of each vertex, by how much of the far window's density the near one's is off: offs. */
static void set_counts(Sheet *s, double *offs)
{
	Pair *both = memory_alloc(sizeof *both * s->count);
	for (uint32_t i = 0; i < s->count; i++)
		both[i] = (Pair){s->vertices[i].count, s->vertices[i].area};
	footprint_mesh_spread(s, both, 1, NEAR_ROUNDS);
	for (uint32_t i = 0; i < s->count; i++)
		offs[i] = ratio_of(both[i]);
	footprint_mesh_spread(s, both, 1, FAR_ROUNDS - NEAR_ROUNDS);
	for (uint32_t i = 0; i < s->count; i++) {
		s->vertices[i].count = both[i][0];
		s->vertices[i].area = both[i][1];
		offs[i] = both[i][0] > 0 ? offs[i] / ratio_of(both[i]) - 1 : 0;
	}
	free(both);
}

/*
 * The window is large, where density changes within it smaller: where chance cannot make the two
 * differ as much as they do all around, the near one counts by how little of that is chance's part
 * (Stein's shrinkage; James & Stein 1961).
 */
static void spread_counts(Sheet *s)
{
	enum { ROUNDS = 8 };
	static const double chance = 0.03; /* twice what counts of random points would give */
	double *offs = memory_alloc(sizeof *offs * s->count);
	set_counts(s, offs);
	Pair *squares = memory_alloc(sizeof *squares * s->count);
	for (uint32_t i = 0; i < s->count; i++)
		squares[i] = (Pair){offs[i] * offs[i], 1};
	footprint_mesh_spread(s, squares, 1, ROUNDS);
	for (uint32_t i = 0; i < s->count; i++) {
		double square = ratio_of(squares[i]);
		if (square > chance)
			s->vertices[i].count *= 1 + (1 - chance / square) * offs[i];
	}
	free(squares);
	free(offs);
}

void footprint_mesh_make(Sheet *s, const SheetTask *task)
{
	*s = (Sheet){.task = task};
	make_vertices(s);
	make_triangles(s);
	count_photons(s);
	if (!footprint_mesh_is_stopped(s))
		spread_counts(s);
	for (uint32_t i = 0; i < s->count; i++)
		s->vertices[i].used = s->vertices[i].area > 0 && s->vertices[i].count > 0;
}

void footprint_mesh_free(Sheet *s)
{
	free(s->vertices);
	free(s->triangles);
	free(s->first);
	free(s->ring);
	free(s->links.around);
	free(s->links.more);
	free(s->aims);
}
