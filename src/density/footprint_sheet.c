/*
 * A sheet is triangulated over emitter space, as sheets of dark matter are over phase space (Abel,
 * Hahn & Kaehler 2012). Each triangle brings to the surface the light that leaves the emitter
 * within it: its area times the density of flux there, which is smooth, so that it does not matter
 * where chance or Halton's sequence has put photons. On the way the triangle is stretched, turned
 * over at folds, and bent: the map's derivatives, fitted at each photon (footprint_fit.h), make it
 * a quadratic patch.
 */
#include "density/footprint_sheet.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/arena.h"
#include "density/footprint_mesh.h"

/* ---- flux ---- */

/* Of parted light: the mean of the neighbours', of all the slice's hues. */
static void spread_flux(Sheet *s)
{
	enum { ROUNDS = 24 };
	Pair(*flux)[2] = memory_alloc(sizeof *flux * s->count);
	for (uint32_t i = 0; i < s->count; i++) {
		const double *f = s->vertices[i].flux;
		flux[i][0] = (Pair){f[0], f[1]};
		flux[i][1] = (Pair){f[2], 0};
	}
	footprint_mesh_spread(s, flux[0], 2, ROUNDS);
	for (uint32_t i = 0; i < s->count; i++)
		memcpy(s->vertices[i].flux, flux[i], sizeof s->vertices[i].flux);
	free(flux);
}

static void set_light(Sheet *s)
{
	for (uint32_t i = 0; i < s->count; i++) {
		Vertex *v = &s->vertices[i];
		for (int c = 0; c < 3 && v->area > 0; c++)
			v->light[c] = v->trust * v->flux[c] * v->count / v->area;
	}
}

/* ---- patches ---- */

/* A corner of a patch to be: a place of the chart near a vertex, or the vertex itself. */
typedef struct Corner {
	const Vertex *vertex;
	double e[2];
	Vec3 at;
	bool beyond; /* not the vertex itself */
} Corner;

static Corner corner_at(const Vertex *v)
{
	return (Corner){v, {v->e[0], v->e[1]}, v->at, false};
}

/* By the vertex' own slopes; where they go too far, as fits from one side may, less. */
static Corner corner_near(const Vertex *v, double du, double dv)
{
	static const double most = 1.5;
	Vec3 way = footprint_moved(v, du, dv);
	double length = vec3_length(way), allowed = most * v->stretch * hypot(du, dv);
	if (length > allowed)
		way = vec3_scale(way, allowed / length);
	return (Corner){v, {v->e[0] + du, v->e[1] + dv}, vec3_add(v->at, way), true};
}

/* From the slopes at both ends (Hermite's). */
static Vec3 edge_control(const Corner *a, const Corner *b)
{
	double du = b->e[0] - a->e[0], dv = b->e[1] - a->e[1];
	Vec3 bend = vec3_sub(footprint_moved(a->vertex, du, dv),
			     footprint_moved(b->vertex, du, dv));
	return vec3_mad(vec3_scale(vec3_add(a->at, b->at), 0.5), 0.25, bend);
}

/* photons: that the patch stands for, of the vertex' light or, when it does not shrink, of its
 * corners' alike. */
static void add_patch(Sheet *s, const Patch *patch, const Vertex *vertex, double photons)
{
	PatchList *list = s->patches;
	uint32_t number = list->count - s->first_patch;
	if (list->count == list->room) {
		list->room = list->room ? 2 * list->room : 64;
		list->all = memory_resize(list->all, sizeof *list->all * list->room);
	}
	if (number == s->aim_room) {
		s->aim_room = s->aim_room ? 2 * s->aim_room : 64;
		s->aims = memory_resize(s->aims, sizeof *s->aims * s->aim_room);
	}
	list->all[list->count++] = *patch;
	s->aims[number] = (struct Aim){(uint32_t)(vertex - s->vertices), photons};
}

static double photon_density(const Vertex *v) { return v->trust * v->count / v->area; }

static void add_whole(Sheet *s, Patch *patch, const Corner corners[3], double area)
{
	double light[3] = {0}, photons = 0;
	for (int i = 0; i < 3; i++) {
		photons += area / 3 * photon_density(corners[i].vertex);
		for (int c = 0; c < 3; c++)
			light[c] += area / 3 * corners[i].vertex->light[c];
	}
	patch->flux = rgb((float)light[0], (float)light[1], (float)light[2]);
	add_patch(s, patch, corners[0].vertex, photons);
}

/* The corner towards which the part of a corner shrinks: one that is a vertex, its own if it is
 * here. */
static int anchor_of(const Corner corners[3], int corner)
{
	int anchor = corner;
	for (int i = 2; i >= 0 && corners[anchor].beyond; i--)
		if (!corners[i].beyond && corners[i].vertex == corners[corner].vertex)
			anchor = i;
	for (int i = 2; i >= 0 && corners[anchor].beyond; i--)
		if (!corners[i].beyond)
			anchor = i;
	return anchor;
}

/* The patch once for each corner, smaller, with this one's part of the light. */
static void add_parts(Sheet *s, const Patch *patch, const Corner corners[3], double area)
{
	double parts[3] = {0};
	for (int i = 0; i < 3; i++)
		parts[anchor_of(corners, i)] += 1.0 / 3;
	for (int i = 0; i < 3; i++) {
		const Vertex *v = corners[i].vertex;
		double shrink = v->shrink, at[3][3] = {{0}};
		if (parts[i] == 0)
			continue;
		for (int k = 0; k < 3; k++) {
			at[k][k] = shrink;
			at[k][i] += 1 - shrink;
		}
		Patch part;
		footprint_patch_cut(patch, (const double (*)[3])at, &part);
		double share = area * parts[i];
		for (int k = 0; k < 3; k++)
			part.sweep[k] *= (float)footprint_mesh_hue_shrink(s);
		part.photon = s->task->photons[v - s->vertices];
		part.flux = rgb((float)(share * v->light[0]), (float)(share * v->light[1]),
				(float)(share * v->light[2]));
		add_patch(s, &part, v, share * photon_density(v));
	}
}

/* straight: edges do not follow the slopes. What lies clockwise overlaps, at a hollow of the
 * border, and is left out. */
static void draw(Sheet *s, const Corner corners[3], bool straight)
{
	uint32_t vertex = (uint32_t)(corners[0].vertex - s->vertices);
	Patch patch = {.photon = s->task->photons[vertex]};
	double area = 0.5 * footprint_cross(corners[0].e, corners[1].e, corners[2].e);
	Vec3 sweep = vec3(0, 0, 0);
	bool is_whole = true;
	for (int i = 0; i < 3; i++) {
		is_whole = is_whole && corners[i].vertex->shrink == 1;
		Corner a = corners[i], b = corners[(i + 1) % 3];
		vec3_to_floats(a.at, patch.control[i]);
		Vec3 middle = straight ? vec3_scale(vec3_add(a.at, b.at), 0.5)
				       : edge_control(&a, &b);
		vec3_to_floats(middle, patch.control[3 + i]);
		sweep = vec3_mad(sweep, s->task->hue_width / 3, a.vertex->hue_slope);
	}
	vec3_to_floats(sweep, patch.sweep);
	if (area > 0 && is_whole)
		add_whole(s, &patch, corners, area);
	else if (area > 0)
		add_parts(s, &patch, corners, area);
}

/* Whether both ends' slopes agree with where the ends are: else there is a crease in between. */
static bool is_smooth(const Vertex *a, const Vertex *b)
{
	static const double most_off = 0.25;
	static const double least_trust = 0.5;
	if (a->trust < least_trust || b->trust < least_trust)
		return false;
	double du = b->e[0] - a->e[0], dv = b->e[1] - a->e[1];
	Vec3 from_a = footprint_moved(a, du, dv), from_b = footprint_moved(b, du, dv);
	Vec3 way = vec3_sub(b->at, a->at);
	double off = vec3_distance(way, vec3_scale(vec3_add(from_a, from_b), 0.5));
	double size = vec3_length(way) + fmax(vec3_length(from_a), vec3_length(from_b));
	return vec3_dot(a->normal, b->normal) > 0.5 && off < most_off * size;
}

static void draw_triangle(Sheet *s, const uint32_t t[3])
{
	const Vertex *v[3] = {&s->vertices[t[0]], &s->vertices[t[1]], &s->vertices[t[2]]};
	if (is_smooth(v[0], v[1]) && is_smooth(v[1], v[2]) && is_smooth(v[2], v[0])) {
		Corner corners[3] = {corner_at(v[0]), corner_at(v[1]), corner_at(v[2])};
		draw(s, corners, false);
		return;
	}
	/* Each corner keeps a third to itself. */
	static const double third = 0.57735;
	for (int i = 0; i < 3; i++) {
		const Vertex *a = v[i], *b = v[(i + 1) % 3], *c = v[(i + 2) % 3];
		if (!a->fitted)
			continue;
		Corner corners[3] = {
			corner_at(a),
			corner_near(a, third * (b->e[0] - a->e[0]), third * (b->e[1] - a->e[1])),
			corner_near(a, third * (c->e[0] - a->e[0]), third * (c->e[1] - a->e[1]))};
		draw(s, corners, true);
	}
}

/* Where a triangle's affine map takes what lies off one of its corners. */
static Corner corner_beyond(const Vertex *v, const Vertex *triangle[3], const double off[2])
{
	const double *a = triangle[0]->e, *b = triangle[1]->e, *c = triangle[2]->e;
	double area = footprint_cross(a, b, c), at[2] = {a[0] + off[0], a[1] + off[1]};
	Vec3 to_b = vec3_sub(triangle[1]->at, triangle[0]->at),
	     to_c = vec3_sub(triangle[2]->at, triangle[0]->at);
	double share_b = footprint_cross(a, at, c) / area,
	       share_c = footprint_cross(a, b, at) / area;
	Vec3 way = vec3_mad(vec3_scale(to_b, share_b), share_c, to_c);
	return (Corner){v, {v->e[0] + off[0], v->e[1] + off[1]}, vec3_add(v->at, way), true};
}

static void draw_border(Sheet *s, const Edge *edge)
{
	const Vertex *a = &s->vertices[edge->a], *b = &s->vertices[edge->b];
	const Vertex *triangle[3] = {a, b, &s->vertices[edge->across]};
	if (!is_smooth(a, b))
		return;
	Corner inner_a = corner_at(a), inner_b = corner_at(b);
	Corner outer_a = corner_beyond(a, triangle, edge->out[0]),
	       outer_b = corner_beyond(b, triangle, edge->out[1]);
	draw(s, (Corner[3]){inner_a, outer_a, inner_b}, true);
	draw(s, (Corner[3]){inner_b, outer_a, outer_b}, true);
}

/*
 * Patches stand for as many photons as have entrusted their light to them. Where they shrink, what
 * they bring goes over from the density's flux, which no chance is in, to that of each photon,
 * which no smoothing is in: so that passes of shrinking patches converge.
 */
static void settle_flux(Sheet *s)
{
	double wanted = 0, drawn = 0;
	uint32_t count = s->patches->count - s->first_patch;
	for (uint32_t i = 0; i < count; i++) {
		drawn += s->aims[i].photons;
		s->vertices[s->aims[i].vertex].drawn += s->aims[i].photons;
	}
	for (uint32_t i = 0; i < s->count; i++)
		wanted += s->vertices[i].trust * s->vertices[i].kept;
	double scale = drawn > 0 ? wanted / drawn : 0;
	for (uint32_t i = 0; i < count; i++) {
		const Vertex *v = &s->vertices[s->aims[i].vertex];
		double smooth = fmin(1, v->shrink * v->shrink);
		Patch *patch = &s->patches->all[s->first_patch + i];
		double own = v->drawn > 0 ? (1 - smooth) * v->trust * v->kept *
						    s->aims[i].photons / v->drawn
					  : 0;
		patch->flux = rgb_scale(patch->flux, (float)(scale * smooth));
		patch->flux = rgb_add(patch->flux, rgb((float)(own * v->own[0]),
		                                       (float)(own * v->own[1]),
		                                       (float)(own * v->own[2])));
	}
}

/*
 * By how much patches shrink. Noise in the mean of passes falls like r^3 with the radius r (which
 * goes with the sixth root of the passes, Knaus & Zwicker 2011): a fit whose residuals are small
 * beside that is good as it is, and shrinking would only open gaps. The least that a residual
 * counts, which borders and density may be wrong by as well, lets all shrink at last. Neighbours
 * shrink alike, or light would gather between them.
 */
static void set_shrink(Sheet *s)
{
	enum { ROUNDS = 8 };
	static const double least = 1e-4;
	double shrink = s->task->shrink, noise = pow(shrink, 6);
	Pair *roughness = memory_alloc(sizeof *roughness * s->count);
	for (uint32_t i = 0; i < s->count; i++)
		roughness[i] = (Pair){s->vertices[i].roughness + least, 0};
	if (shrink < 1)
		footprint_mesh_spread(s, roughness, 1, ROUNDS);
	for (uint32_t i = 0; i < s->count; i++) {
		double power = fmin(1, sqrt(roughness[i][0]) / noise);
		s->vertices[i].shrink = s->task->scale * pow(shrink, power);
	}
	free(roughness);
}

static void draw_all(Sheet *s)
{
	EdgeList border = footprint_border_make(s);
	set_shrink(s);
	for (uint32_t t = 0; t < s->triangle_count; t++)
		draw_triangle(s, s->triangles[t]);
	for (uint32_t i = 0; i < border.count; i++)
		draw_border(s, &border.all[i]);
	free(border.all);
	settle_flux(s);
}

void footprint_sheet(const SheetTask *task, PatchList *patches, float *trust)
{
	Sheet s;
	footprint_mesh_make(&s, task);
	s.patches = patches;
	s.first_patch = patches->count;
	footprint_slopes_fit(&s);
	if (task->hues)
		spread_flux(&s);
	set_light(&s);
	if (!footprint_mesh_is_stopped(&s))
		draw_all(&s);
	for (uint32_t i = 0; i < s.count; i++)
		trust[i] = (float)(s.vertices[i].trust * s.vertices[i].kept);
	footprint_mesh_free(&s);
}

void footprint_sheet_hue_slopes(const SheetTask *task, float (*hue_slopes)[3])
{
	Sheet s;
	footprint_mesh_make(&s, task);
	footprint_slopes_fit(&s);
	footprint_slopes_spread_hues(&s);
	for (uint32_t i = 0; i < s.count; i++)
		vec3_to_floats(s.vertices[i].hue_slope, hue_slopes[i]);
	footprint_mesh_free(&s);
}
