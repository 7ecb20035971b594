#include "density/footprint_mesh.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/arena.h"
#include "density/footprint_outline.h"

bool footprint_mesh_is_border(const Sheet *s, uint32_t a, uint32_t b)
{
	for (uint32_t k = s->first[b]; k < s->first[b + 1]; k++)
		if (s->ring[k] == a)
			return false;
	return true;
}

static EdgeList find_border(Sheet *s)
{
	EdgeList list = {memory_alloc(sizeof(Edge) * (3 * (size_t)s->triangle_count + 1)), 0};
	for (uint32_t t = 0; t < s->triangle_count; t++) {
		for (int k = 0; k < 3; k++) {
			uint32_t a = s->triangles[t][k], b = s->triangles[t][(k + 1) % 3];
			if (footprint_mesh_is_border(s, a, b))
				list.all[list.count++] =
					(Edge){a, b, s->triangles[t][(k + 2) % 3], {{0}}};
		}
	}
	return list;
}

/* How much of the full angle the triangles around fill. */
static void set_covered(Sheet *s)
{
	for (uint32_t t = 0; t < s->triangle_count; t++) {
		for (int k = 0; k < 3; k++) {
			Vertex *a = &s->vertices[s->triangles[t][k]];
			const double *b = s->vertices[s->triangles[t][(k + 1) % 3]].e,
				     *c = s->vertices[s->triangles[t][(k + 2) % 3]].e;
			double along = (b[0] - a->e[0]) * (c[0] - a->e[0]) +
				       (b[1] - a->e[1]) * (c[1] - a->e[1]);
			a->covered += atan2(footprint_cross(a->e, b, c), along) / (2 * M_PI);
		}
	}
}

/* ---- loops ---- */

/* Border edges by the vertex that they start at. */
typedef struct Starts { uint32_t *first, *edges; } Starts;

static Starts sort_by_start(const Sheet *s, const EdgeList *border)
{
	Starts starts = {memory_alloc(sizeof(uint32_t) * ((size_t)s->count + 2)),
			 memory_alloc(sizeof(uint32_t) * ((size_t)border->count + 1))};
	memset(starts.first, 0, sizeof(uint32_t) * ((size_t)s->count + 2));
	for (uint32_t i = 0; i < border->count; i++)
		starts.first[border->all[i].a + 2]++;
	for (uint32_t i = 2; i < s->count + 2; i++)
		starts.first[i] += starts.first[i - 1];
	for (uint32_t i = 0; i < border->count; i++)
		starts.edges[starts.first[border->all[i].a + 1]++] = i;
	return starts;
}

/* The border's next edge: of those that start where one ends the first clockwise from it, so that
 * what is between is inside. */
static uint32_t next_edge(const Sheet *s, const EdgeList *border, const Starts *starts,
			  uint32_t edge)
{
	const Edge *e = &border->all[edge];
	const double *from = s->vertices[e->a].e, *at = s->vertices[e->b].e;
	double least = INFINITY;
	uint32_t best = edge;
	for (uint32_t k = starts->first[e->b]; k < starts->first[e->b + 1]; k++) {
		const double *to = s->vertices[border->all[starts->edges[k]].b].e;
		double along = (from[0] - at[0]) * (to[0] - at[0]) +
			       (from[1] - at[1]) * (to[1] - at[1]);
		double angle = atan2(-footprint_cross(at, from, to), along);
		angle += angle <= 0 ? 2 * M_PI : 0;
		if (angle < least) {
			least = angle;
			best = starts->edges[k];
		}
	}
	return best;
}

/*
 * A vertex on the border has room inside the triangles for the part of its light that its angle
 * there is of the full one; for the rest the sheet goes on outside.
 */
static OutlineNode node_of(const Sheet *s, const Starts *starts, uint32_t vertex)
{
	const Vertex *v = &s->vertices[vertex];
	double space = v->area / v->count;
	uint32_t passes = starts->first[vertex + 1] - starts->first[vertex];
	return (OutlineNode){{v->e[0], v->e[1]}, space, (1 - v->covered) * space / passes};
}

static void set_outward(const Sheet *s, EdgeList *border, const uint32_t *loop, int count,
			const double (*out)[2])
{
	for (int i = 0; i < count; i++) {
		Edge *e = &border->all[loop[i]];
		for (int k = 0; k < 2; k++) {
			e->out[0][k] = out[i][k] - s->vertices[e->a].e[k];
			e->out[1][k] = out[(i + 1) % count][k] - s->vertices[e->b].e[k];
		}
	}
}

static void draw_outline(const Sheet *s, EdgeList *border)
{
	size_t room = (size_t)border->count + 1;
	Starts starts = sort_by_start(s, border);
	OutlineNode *nodes = memory_alloc(sizeof *nodes * room);
	uint32_t *loop = memory_alloc(sizeof *loop * room);
	double (*out)[2] = memory_alloc(sizeof *out * room);
	bool *done = memory_alloc(sizeof *done * room);
	memset(done, 0, sizeof *done * room);
	for (uint32_t i = 0; i < border->count; i++) {
		int count = 0;
		for (uint32_t e = i; !done[e]; e = next_edge(s, border, &starts, e)) {
			done[e] = true;
			loop[count] = e;
			nodes[count++] = node_of(s, &starts, border->all[e].a);
		}
		if (count == 0)
			continue;
		footprint_outline(nodes, count, out);
		set_outward(s, border, loop, count, (const double (*)[2])out);
	}
	free(starts.first);
	free(starts.edges);
	free(nodes);
	free(loop);
	free(out);
	free(done);
}

EdgeList footprint_border_make(Sheet *s)
{
	EdgeList border = find_border(s);
	set_covered(s);
	for (uint32_t i = 0; i < s->count; i++)
		s->vertices[i].kept = s->vertices[i].used;
	draw_outline(s, &border);
	return border;
}
