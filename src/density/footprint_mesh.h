/*
 * A sheet while it is made: its photons as the vertices of a triangulation of emitter space.
 */
#ifndef DENSITY_FOOTPRINT_MESH_H
#define DENSITY_FOOTPRINT_MESH_H

#include <stdbool.h>

#include "base/pair.h"
#include "density/footprint_sheet.h"

/* The chart is a plane picture of emitter space. */
typedef struct Vertex {
	double e[2];    /* chart of emitter space */
	Vec3 at, normal;
	Vec3 slope[2];  /* of the place by the chart's coordinates */
	Vec3 hue_slope; /* and by hue */
	double stretch; /* by how much the map stretches edges around: the median */
	double space;   /* chart's area for one photon */
	double count, area; /* photons and chart area around, in the same window */
	double flux[3];
	double light[3]; /* density of flux in the chart */
	double roughness; /* of the fit */
	double shrink;    /* its patches are drawn so much smaller */
	double trust;
	double covered; /* how much of the full angle triangles fill: 0..1 */
	double kept;    /* share of its light that patches have room for */
	double own[3];  /* its photon's flux */
	double drawn;   /* photons that its patches stand for */
	bool fitted, used;
} Vertex;

/* Directions are charted stereographically around their mean: circles stay circles. */
typedef struct Chart {
	bool plane;
	Vec3 middle, u, v;
} Chart;

/* What footprint_mesh_spread goes along: an edge once for each of its triangles. Each vertex has
 * the first eight of its ring twice, or itself where it has fewer; `more` is what else there is. */
enum { LINKS = 8 };

typedef struct Links {
	uint32_t (*around)[LINKS];
	struct Link { uint32_t to, from; double weight; } *more;
	uint32_t more_count;
} Links;

typedef struct Sheet {
	const SheetTask *task;
	Chart chart;
	Vertex *vertices; /* of the task's photons */
	uint32_t count;
	uint32_t (*triangles)[3];
	uint32_t triangle_count;
	/* Neighbours of vertex i: ring[first[i]] to ring[first[i + 1] - 1]. */
	uint32_t *first, *ring;
	Links links;
	PatchList *patches;
	uint32_t first_patch; /* of this sheet's */
	/* Of each of its patches, when these shrink: towards which vertex, and how many photons it
	 * stands for. */
	struct Aim { uint32_t vertex; double photons; } *aims;
	uint32_t aim_room;
} Sheet;

/* Vertices, triangles that reach over no gap, and the density of photons in the chart. */
void footprint_mesh_make(Sheet *sheet, const SheetTask *task);
void footprint_mesh_free(Sheet *sheet);

/* Where emitter coordinates are in the chart. */
void footprint_mesh_chart(const Sheet *sheet, const float emitter[3], double out[2]);
/* Whether a triangle reaches over a gap of the sheet or along its border. */
bool footprint_mesh_bridges(const Sheet *sheet, const uint32_t triangle[3]);
/* Whether only one triangle has the edge from a to b: none has b followed by a. */
bool footprint_mesh_is_border(const Sheet *sheet, uint32_t a, uint32_t b);

/* Whether somebody wants it to end: then stages may be left out. */
bool footprint_mesh_is_stopped(const Sheet *sheet);
/* The photon's hue; 0 where light is not parted. */
double footprint_mesh_hue(const Sheet *sheet, uint32_t vertex);
/* The share of their way that photons are moved to the slice's hue, and patches smeared over it. */
double footprint_mesh_hue_shrink(const Sheet *sheet);

/* Twice the area of the triangle a b c; over 0: anticlockwise. */
static inline double footprint_cross(const double a[2], const double b[2], const double c[2])
{
	return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

/* By the vertex' slopes. */
static inline Vec3 footprint_moved(const Vertex *v, double du, double dv)
{
	return vec3_mad(vec3_scale(v->slope[0], du), dv, v->slope[1]);
}

/* footprint_spread.c: neighbours exchange a part of their values, again and again, so that the sums
 * stay. values: one pair a vertex, or two; rounds: even. */
enum { SPREAD_MOST = 2 };
void footprint_mesh_spread(const Sheet *sheet, Pair *values, int pairs, int rounds);
/* Sets the links from the rings. */
void footprint_mesh_link(Sheet *sheet);

/* footprint_slopes.c: how the map stretches, turns and shears around each vertex, and by hue when
 * that is asked for. */
void footprint_slopes_fit(Sheet *sheet);
/* Slopes by hue as the mean of the neighbours'. */
void footprint_slopes_spread_hues(Sheet *sheet);

/* footprint_border.c: the sheet's border, and how far it goes on beyond its outermost photons. */
typedef struct Edge {
	uint32_t a, b, across; /* inside to the left of a b */
	double out[2][2];      /* from a and from b: where the sheet ends, in the chart */
} Edge;

typedef struct EdgeList {
	Edge *all;
	uint32_t count;
} EdgeList;

/* Sets the vertices' kept. The block is the caller's to free. */
EdgeList footprint_border_make(Sheet *sheet);

#endif
