#include "density/footprint_mesh.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/arena.h"

/* No other triangle has b followed by a. */
static bool is_border(const Sheet *s, uint32_t a, uint32_t b)
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
			if (is_border(s, a, b))
				list.all[list.count++] =
					(Edge){a, b, s->triangles[t][(k + 2) % 3]};
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

static void add_normal(Vertex *v, double nu, double nv, double length)
{
	v->out[0] += nu;
	v->out[1] += nv;
	v->border += 0.5 * length;
}

/*
 * A vertex on the border has room inside the triangles for the part of its light that its angle
 * there is of the full one; for the rest the sheet goes on outside as far as it takes. Of what is
 * alone at the end of a spike not all finds room.
 */
static void set_width(Vertex *v)
{
	static const double most = 0.8; /* spaces of a photon */
	double square = v->out[0] * v->out[0] + v->out[1] * v->out[1];
	double space = v->area / v->count, missing = 1 - v->covered;
	double width = missing * space / v->border;
	v->kept = 1;
	if (width > most * sqrt(space)) {
		v->kept = v->covered + missing * most * sqrt(space) / width;
		width = most * sqrt(space);
	}
	/* The sum of two unit normals, cut to the length that makes the strip as wide. */
	double scale = width * fmin(2 / fmax(square, 1e-9), 2 / sqrt(fmax(square, 1e-9)));
	v->out[0] *= scale;
	v->out[1] *= scale;
}

/* Draws each place outside nearer to the middle of the two beside it along the border, which
 * straightens what chance has made of it. */
static void straighten(Sheet *s, const EdgeList *border)
{
	enum { ROUNDS = 2 };
	double (*pull)[3] = memory_alloc(sizeof *pull * s->count);
	for (int round = 0; round < ROUNDS; round++) {
		memset(pull, 0, sizeof *pull * s->count);
		for (uint32_t i = 0; i < border->count; i++) {
			uint32_t a = border->all[i].a, b = border->all[i].b;
			for (int k = 0; k < 2; k++) {
				const Vertex *u = &s->vertices[a], *v = &s->vertices[b];
				double way = v->e[k] + v->out[k] - u->e[k] - u->out[k];
				pull[a][k] += way;
				pull[b][k] -= way;
			}
			pull[a][2]++;
			pull[b][2]++;
		}
		for (uint32_t i = 0; i < s->count; i++)
			for (int k = 0; k < 2 && pull[i][2] == 2; k++)
				s->vertices[i].out[k] += 0.25 * pull[i][k];
	}
	free(pull);
}

static void set_outward(Sheet *s, const EdgeList *border)
{
	set_covered(s);
	for (uint32_t i = 0; i < border->count; i++) {
		Vertex *a = &s->vertices[border->all[i].a], *b = &s->vertices[border->all[i].b];
		double du = b->e[0] - a->e[0], dv = b->e[1] - a->e[1], length = hypot(du, dv);
		if (!(length > 0))
			continue;
		add_normal(a, dv / length, -du / length, length);
		add_normal(b, dv / length, -du / length, length);
	}
	for (uint32_t i = 0; i < s->count; i++) {
		s->vertices[i].kept = s->vertices[i].used;
		if (s->vertices[i].border > 0)
			set_width(&s->vertices[i]);
	}
	straighten(s, border);
}

EdgeList footprint_border_make(Sheet *s)
{
	EdgeList border = find_border(s);
	set_outward(s, &border);
	return border;
}
