/*
 * Along a ray the squared distance to a component, in units of its radius, is a quadratic q(t) on
 * up to three pieces (a cylinder's two end spheres and its side), and its field s (1 - q)^2 a
 * quartic there, zero elsewhere. The ends of all pieces cut the ray into spans; on each span the
 * quartics of the pieces that cover it add up, in a parameter that counts from the span's middle so
 * that nothing cancels, and the crossings are the roots of the sum less the threshold.
 */
#include "geom/blob.h"

#include <float.h>
#include <stdint.h>
#include <stdlib.h>

#include "geom/box_tree.h"
#include "geom/polynomial.h"

enum { INLINE_PIECES = 96 };

/* A component in its own frame: along the axis from the centre (cylinders), scaled by nothing. */
typedef struct Component {
	BlobComponent given;
	Vec3 axis; /* unit, of a cylinder */
	double length;
	double inverse_radius2;
} Component;

typedef struct Blob {
	const Component *components;
	int count;
	double threshold;
	Box3 box;
	const BoxTree *tree;
	bool has_textures;
} Blob;

static Box3 component_box(const Component *component)
{
	const BlobComponent *given = &component->given;
	Vec3 half = vec3_all(given->radius), end = given->cylinder ? given->end : given->center;
	Box3 box = {vec3_sub(vec3_min(given->center, end), half),
		    vec3_add(vec3_max(given->center, end), half)};
	return given->transform ? transform_box(given->transform, box) : box;
}

static bool component_prepare(Component *out, const BlobComponent *given, const char **error)
{
	*out = (Component){.given = *given};
	out->given.radius = fabs(given->radius);
	/* Without a radius there is no field; some finite number keeps it so. */
	out->inverse_radius2 = given->radius != 0 ? 1 / (given->radius * given->radius) : DBL_MAX;
	if (given->radius == 0)
		out->given.strength = 0;
	if (!given->cylinder)
		return true;
	Vec3 along = vec3_sub(given->end, given->center);
	out->length = vec3_length(along);
	out->axis = vec3_normalize(along);
	if (out->length == 0)
		*error = "a cylindrical blob component needs a length";
	return out->length > 0;
}

const void *blob_create(Arena *arena, const BlobDesc *desc, const char **error)
{
	if (desc->count < 1) {
		*error = "a blob needs a component";
		return NULL;
	}
	Blob *blob = ARENA_NEW(arena, Blob);
	Component *components = ARENA_ARRAY(arena, Component, desc->count);
	Box3 *boxes = ARENA_ARRAY(arena, Box3, desc->count);
	blob->box = box3_empty();
	for (int i = 0; i < desc->count; i++) {
		if (!component_prepare(&components[i], &desc->components[i], error))
			return NULL;
		boxes[i] = component_box(&components[i]);
		blob->box = box3_union(blob->box, boxes[i]);
		blob->has_textures |= components[i].given.texture >= 0;
	}
	blob->components = components;
	blob->count = desc->count;
	blob->threshold = desc->threshold;
	blob->tree = box_tree_create(arena, boxes, desc->count);
	return blob;
}

static bool blob_bounds(const void *data, Box3 *box)
{
	*box = ((const Blob *)data)->box;
	return true;
}

/* ---- the field at a point ---- */

/* From the nearest point of the component's centre or axis to p, both in the component's own
 * space. */
static Vec3 component_away(const Component *component, Vec3 own)
{
	Vec3 away = vec3_sub(own, component->given.center);
	if (!component->given.cylinder)
		return away;
	double along = vec3_dot(away, component->axis);
	return vec3_mad(away, -fmax(0, fmin(component->length, along)), component->axis);
}

static Vec3 into_component(const Component *component, Vec3 p)
{
	return component->given.transform ? transform_point_inverse(component->given.transform, p)
					  : p;
}

/* The field of one component; its gradient in the blob's space is added to *gradient unless that
 * is NULL. */
static double component_field(const Component *component, Vec3 p, Vec3 *gradient)
{
	Vec3 away = component_away(component, into_component(component, p));
	double left = 1 - vec3_length2(away) * component->inverse_radius2;
	if (left <= 0)
		return 0;
	double strength = component->given.strength;
	if (gradient) {
		Vec3 slope = vec3_scale(away, -4 * strength * left * component->inverse_radius2);
		if (component->given.transform)
			slope = transform_normal(component->given.transform, slope);
		*gradient = vec3_add(*gradient, slope);
	}
	return strength * left * left;
}

typedef struct FieldQuery {
	const Blob *blob;
	Vec3 p, gradient;
	double value;
	bool with_gradient;
} FieldQuery;

static bool visit_field(void *data, int item)
{
	FieldQuery *query = data;
	Vec3 *gradient = query->with_gradient ? &query->gradient : NULL;
	query->value += component_field(&query->blob->components[item], query->p, gradient);
	return false;
}

static bool blob_inside(const void *data, Vec3 p)
{
	const Blob *blob = data;
	FieldQuery query = {.blob = blob, .p = p};
	box_tree_walk_point(blob->tree, p, visit_field, &query);
	return query.value > blob->threshold;
}

static Vec3 blob_normal(const void *data, const Hit *hit, Vec3 p)
{
	FieldQuery query = {.blob = data, .p = p, .with_gradient = true};
	(void)hit;
	box_tree_walk_point(query.blob->tree, p, visit_field, &query);
	return vec3_length2(query.gradient) > 0 ? vec3_neg(query.gradient) : vec3(1, 0, 0);
}

/* ---- textures ---- */

typedef struct TextureQuery {
	const Blob *blob;
	Vec3 p;
	ShapeTextures *out;
	double sum;
} TextureQuery;

static bool visit_texture(void *data, int item)
{
	TextureQuery *query = data;
	ShapeTextures *out = query->out;
	const Component *component = &query->blob->components[item];
	double weight = fabs(component_field(component, query->p, NULL));
	int i = 0;
	if (weight == 0)
		return false;
	while (i < out->count && out->numbers[i] != component->given.texture)
		i++;
	if (i == SHAPE_MAX_TEXTURES)
		return false;
	if (i == out->count) {
		out->numbers[i] = component->given.texture;
		out->weights[i] = 0;
		out->count++;
	}
	out->weights[i] += weight;
	query->sum += weight;
	return false;
}

/* Each component's texture counts by the component's share of the field. */
static int blob_textures(const void *data, const Hit *hit, Vec3 p, ShapeTextures *out)
{
	const Blob *blob = data;
	(void)hit;
	out->count = 0;
	if (!blob->has_textures)
		return 0;
	TextureQuery query = {blob, p, out, 0};
	box_tree_walk_point(blob->tree, p, visit_texture, &query);
	for (int i = 0; i < out->count; i++)
		out->weights[i] /= query.sum;
	return out->count;
}

/* ---- pieces along a ray ---- */

/* q(t) = q[0] + q[1] s + q[2] s^2 with s = t - middle, for lo < t < hi, where it is below 1. */
typedef struct Piece {
	double lo, hi, middle;
	double q[3];
	double strength;
} Piece;

typedef struct PieceList {
	const Blob *blob;
	const Ray *ray;
	Piece *pieces;
	int count, capacity;
	Piece first[INLINE_PIECES];
} PieceList;

static void piece_list_push(PieceList *list, const Piece *piece)
{
	if (list->count == list->capacity) {
		size_t bytes = sizeof(Piece) * (size_t)list->capacity;
		Piece *larger = memory_alloc(2 * bytes);
		for (int i = 0; i < list->count; i++)
			larger[i] = list->pieces[i];
		if (list->pieces != list->first)
			free(list->pieces);
		list->pieces = larger;
		list->capacity *= 2;
	}
	list->pieces[list->count++] = *piece;
}

/* Adds the piece where |from + t step|^2 / radius^2 < 1 within the limits. */
static void add_piece(PieceList *list, const Component *component, Vec3 from, Vec3 step,
		      const double limits[2])
{
	double speed2 = vec3_length2(step), scale = component->inverse_radius2;
	double middle = speed2 > 0 ? -vec3_dot(from, step) / speed2 : 0;
	double nearest = vec3_length2(vec3_mad(from, middle, step)) * scale;
	if (!(nearest < 1))
		return;
	double half = speed2 > 0 ? sqrt((1 - nearest) / (speed2 * scale)) : INFINITY;
	Piece piece = {.middle = middle,
		       .q = {nearest, 0, speed2 * scale},
		       .strength = component->given.strength};
	piece.lo = fmax(limits[0], middle - half);
	piece.hi = fmin(limits[1], middle + half);
	if (piece.lo < piece.hi)
		piece_list_push(list, &piece);
}

/* The three pieces of a cylinder, told apart by where the ray is along the axis. */
static void add_cylinder(PieceList *list, const Component *component, Vec3 from, Vec3 step,
			 const double limits[2])
{
	double along = vec3_dot(from, component->axis),
	       along_step = vec3_dot(step, component->axis);
	double start = -along / along_step, end = (component->length - along) / along_step;
	Vec3 far = vec3_mad(from, -component->length, component->axis);
	Vec3 across = vec3_mad(from, -along, component->axis);
	Vec3 across_step = vec3_mad(step, -along_step, component->axis);
	if (along_step == 0) {
		bool beyond = along > component->length;
		if (along >= 0 && !beyond)
			add_piece(list, component, across, across_step, limits);
		else
			add_piece(list, component, beyond ? far : from, step, limits);
		return;
	}
	bool up = along_step > 0;
	double low = fmin(start, end), high = fmax(start, end);
	add_piece(list, component, up ? from : far, step,
		  (double[]){limits[0], fmin(limits[1], low)});
	add_piece(list, component, across, across_step,
		  (double[]){fmax(limits[0], low), fmin(limits[1], high)});
	add_piece(list, component, up ? far : from, step,
		  (double[]){fmax(limits[0], high), limits[1]});
}

static bool visit_pieces(void *data, int item)
{
	PieceList *list = data;
	const Component *component = &list->blob->components[item];
	const Transform *transform = component->given.transform;
	const double limits[2] = {list->ray->tmin, list->ray->tmax};
	Vec3 from = vec3_sub(into_component(component, list->ray->origin), component->given.center);
	Vec3 step = list->ray->direction;
	if (transform)
		step = transform_vector_inverse(transform, step);
	if (component->given.cylinder)
		add_cylinder(list, component, from, step, limits);
	else
		add_piece(list, component, from, step, limits);
	return false;
}

static int compare_pieces(const void *a, const void *b)
{
	double left = ((const Piece *)a)->lo, right = ((const Piece *)b)->lo;
	return (left > right) - (left < right);
}

/* Pieces in the order in which the ray enters them. */
static void sort_pieces(PieceList *list)
{
	if (list->count > 32) {
		qsort(list->pieces, (size_t)list->count, sizeof(Piece), compare_pieces);
		return;
	}
	for (int i = 1; i < list->count; i++) {
		Piece piece = list->pieces[i];
		int at = i;
		for (; at > 0 && list->pieces[at - 1].lo > piece.lo; at--)
			list->pieces[at] = list->pieces[at - 1];
		list->pieces[at] = piece;
	}
}

/* ---- spans ---- */

/* Adds strength (1 - q)^2 of a piece to the quartic c in s = t - middle. */
static void add_quartic(const Piece *piece, double middle, double c[5])
{
	double shift = middle - piece->middle;
	double a = 1 - (piece->q[0] + shift * shift * piece->q[2]), b = -2 * shift * piece->q[2],
	       e = -piece->q[2];
	c[0] += piece->strength * a * a;
	c[1] += piece->strength * 2 * a * b;
	c[2] += piece->strength * (b * b + 2 * a * e);
	c[3] += piece->strength * 2 * b * e;
	c[4] += piece->strength * e * e;
}

typedef struct SpanWalk {
	const Piece *pieces; /* sorted by lo */
	int count;
	int first; /* pieces before it end before the span */
	double threshold;
} SpanWalk;

/* Where the next span ends: at the nearest end or start of a piece after lo. */
static double span_end(const SpanWalk *walk, double lo)
{
	double end = INFINITY;
	for (int i = walk->first; i < walk->count && walk->pieces[i].lo < end; i++) {
		const Piece *piece = &walk->pieces[i];
		if (piece->lo > lo)
			end = piece->lo;
		else if (piece->hi > lo && piece->hi < end)
			end = piece->hi;
	}
	return end;
}

/* Crossings between lo and hi, which no piece's end divides. */
static int span_roots(const SpanWalk *walk, double lo, double hi, double roots[4])
{
	double c[5] = {-walk->threshold, 0, 0, 0, 0}, middle = 0.5 * (lo + hi);
	bool covered = false;
	for (int i = walk->first; i < walk->count && walk->pieces[i].lo < middle; i++) {
		if (walk->pieces[i].hi <= middle)
			continue;
		add_quartic(&walk->pieces[i], middle, c);
		covered = true;
	}
	if (!covered)
		return 0;
	int count = polynomial_roots(c, 4, lo - middle, hi - middle, roots);
	for (int i = 0; i < count; i++)
		roots[i] += middle;
	return count;
}

/* Pushes crossings in rising order; at most `most`. */
static void cross_spans(const Shape *self, const PieceList *list, int most, HitList *out)
{
	const Blob *blob = self->data;
	SpanWalk walk = {list->pieces, list->count, 0, blob->threshold};
	double lo = list->count ? list->pieces[0].lo : INFINITY, roots[4];
	for (;;) {
		double hi = span_end(&walk, lo);
		if (isinf(hi) || most <= 0)
			return;
		int count = span_roots(&walk, lo, hi, roots);
		for (int i = 0; i < count; i++, most--)
			hit_list_add(out, list->ray, self, roots[i], 0);
		lo = hi;
		while (walk.first < walk.count && walk.pieces[walk.first].hi <= lo)
			walk.first++;
	}
}

static void blob_cross(const Shape *self, const Ray *ray, int most, HitList *out)
{
	const Blob *blob = self->data;
	RaySlabs slabs = ray_slabs(ray);
	PieceList list;
	list.blob = blob;
	list.ray = ray;
	list.pieces = list.first;
	list.count = 0;
	list.capacity = INLINE_PIECES;
	box_tree_walk_ray(blob->tree, &slabs, visit_pieces, &list);
	sort_pieces(&list);
	cross_spans(self, &list, most, out);
	if (list.pieces != list.first)
		free(list.pieces);
}

static void blob_intersect(const Shape *self, const Ray *ray, HitList *out)
{
	blob_cross(self, ray, INT32_MAX, out);
}

static bool blob_nearest(const Shape *self, const Ray *ray, Hit *out)
{
	return hit_nearest_by(blob_cross, self, ray, out);
}

const ShapeClass blob_class = {
	.name = "blob",
	.bounds = blob_bounds,
	.intersect = blob_intersect,
	.inside = blob_inside,
	.normal = blob_normal,
	.nearest = blob_nearest,
	.textures = blob_textures,
};
