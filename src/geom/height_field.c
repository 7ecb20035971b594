/*
 * A quadtree of lowest and highest heights over the cells (a mip map: each level halves the grid)
 * tells a ray which blocks of cells to skip; in a cell that is left, two triangles are met. Smooth
 * fields interpolate normals of the samples.
 */
#include "geom/height_field.h"

#include <limits.h>

#include "geom/ray_box.h"

enum { MAX_LEVELS = 32 };

typedef struct Level {
	int width, depth; /* blocks */
	float *low, *high;
} Level;

typedef struct HeightField {
	HeightFieldDesc desc;
	double floor; /* triangles below are not there */
	Level levels[MAX_LEVELS]; /* 0: cells */
	int level_count;
	float low, high;
} HeightField;

static float height(const HeightField *field, int x, int z)
{
	return field->desc.heights[(size_t)z * (size_t)field->desc.width + (size_t)x];
}

/* ---- making ---- */

static void allocate_level(Arena *arena, Level *level, int width, int depth)
{
	*level = (Level){width, depth, ARENA_ARRAY(arena, float, (size_t)width * (size_t)depth),
	                 ARENA_ARRAY(arena, float, (size_t)width * (size_t)depth)};
}

static void fill_cells(HeightField *field)
{
	Level *level = &field->levels[0];
	for (int z = 0; z < level->depth; z++) {
		for (int x = 0; x < level->width; x++) {
			float a = height(field, x, z), b = height(field, x + 1, z),
			      c = height(field, x, z + 1);
			float d = height(field, x + 1, z + 1);
			size_t i = (size_t)z * (size_t)level->width + (size_t)x;
			level->low[i] = fminf(fminf(a, b), fminf(c, d));
			level->high[i] = fmaxf(fmaxf(a, b), fmaxf(c, d));
		}
	}
}

static void merge_block(const Level *fine, Level *coarse, int x, int z)
{
	size_t i = (size_t)z * (size_t)coarse->width + (size_t)x;
	coarse->low[i] = INFINITY;
	coarse->high[i] = -INFINITY;
	for (int k = 0; k < 4; k++) {
		int fx = 2 * x + (k & 1), fz = 2 * z + (k >> 1);
		if (fx >= fine->width || fz >= fine->depth)
			continue;
		size_t j = (size_t)fz * (size_t)fine->width + (size_t)fx;
		coarse->low[i] = fminf(coarse->low[i], fine->low[j]);
		coarse->high[i] = fmaxf(coarse->high[i], fine->high[j]);
	}
}

static void build_levels(Arena *arena, HeightField *field)
{
	allocate_level(arena, &field->levels[0], field->desc.width - 1, field->desc.depth - 1);
	fill_cells(field);
	field->level_count = 1;
	for (Level *fine = field->levels; fine->width > 1 || fine->depth > 1; fine++) {
		Level *coarse = fine + 1;
		allocate_level(arena, coarse, (fine->width + 1) / 2, (fine->depth + 1) / 2);
		for (int z = 0; z < coarse->depth; z++) {
			for (int x = 0; x < coarse->width; x++)
				merge_block(fine, coarse, x, z);
		}
		field->level_count++;
	}
	field->low = field->levels[field->level_count - 1].low[0];
	field->high = field->levels[field->level_count - 1].high[0];
}

const void *height_field_create(Arena *arena, const HeightFieldDesc *desc, const char **error)
{
	*error = desc->width < 2 || desc->depth < 2
			 ? "a height field needs at least two samples each way"
			 : NULL;
	if (*error)
		return NULL;
	HeightField *field = ARENA_NEW(arena, HeightField);
	field->desc = *desc;
	field->floor = desc->water_level;
	build_levels(arena, field);
	return field;
}

/* ---- tracing ---- */

static bool height_field_bounds(const void *data, Box3 *box)
{
	const HeightField *field = data;
	*box = (Box3){{0, fmax(field->low, field->floor), 0},
		      {1, fmax(field->high, field->floor), 1}};
	return true;
}

static Vec3 sample_point(const HeightField *field, int x, int z)
{
	return vec3(x / (double)(field->desc.width - 1), height(field, x, z),
		    z / (double)(field->desc.depth - 1));
}

/* Corners of a cell's half: 0 has the corner (x, z), 1 the corner (x + 1, z + 1). */
static void half_corners(const HeightField *field, int part, Vec3 corner[3])
{
	int half = part & 1, cell = part >> 1, x = cell % field->levels[0].width,
	    z = cell / field->levels[0].width;
	corner[0] = sample_point(field, x + half, z + half);
	corner[1] = sample_point(field, x + 1, z);
	corner[2] = sample_point(field, x, z + 1);
}

static void cross_half(const Shape *self, const Ray *ray, int part, HitList *out)
{
	const HeightField *field = self->data;
	Vec3 c[3];
	half_corners(field, part, c);
	Vec3 ab = vec3_sub(c[1], c[0]), ac = vec3_sub(c[2], c[0]),
	     p = vec3_cross(ray->direction, ac);
	double determinant = vec3_dot(ab, p), inverse = 1 / determinant;
	Vec3 from = vec3_sub(ray->origin, c[0]), q = vec3_cross(from, ab);
	double u = vec3_dot(from, p) * inverse, v = vec3_dot(ray->direction, q) * inverse,
	       t = vec3_dot(ac, q) * inverse;
	if (u >= 0 && v >= 0 && u + v <= 1 && t > ray->tmin && t < ray->tmax &&
	    ray->origin.y + t * ray->direction.y >= field->floor)
		hit_list_push(out, (Hit){t, self, part, u, v});
}

typedef struct Walk {
	const Shape *self;
	const HeightField *field;
	Ray ray;
	Vec3 inverse; /* of the direction */
	int first; /* of four blocks the one that the ray meets first: bit 0 for x, bit 1 for z */
	bool nearest; /* the first crossing is enough: it ends the ray, and out holds only it */
	HitList *out;
} Walk;

static bool meets_slab(double lo, double hi, double origin, double inverse, double range[2])
{
	ray_slabs_clip(lo, hi, origin, inverse, range);
	return range[0] <= range[1] + 1e-12 * fabs(range[1]);
}

static bool meets_block(const Walk *walk, int level, int x, int z)
{
	const HeightField *field = walk->field;
	const Level *l = &field->levels[level];
	size_t i = (size_t)z * (size_t)l->width + (size_t)x;
	if (l->high[i] < field->floor)
		return false;
	double range[2] = {walk->ray.tmin, walk->ray.tmax};
	double cell_x = 1.0 / (field->desc.width - 1), cell_z = 1.0 / (field->desc.depth - 1);
	double size = (double)(1L << level), x0 = (double)x * size, z0 = (double)z * size;
	double slack = 1e-6 * cell_x;
	Vec3 o = walk->ray.origin, inverse = walk->inverse;
	return meets_slab(l->low[i] - 1e-7, l->high[i] + 1e-7, o.y, inverse.y, range) &&
	       meets_slab(x0 * cell_x - slack, (x0 + size) * cell_x + slack, o.x, inverse.x,
			  range) &&
	       meets_slab(z0 * cell_z - slack, (z0 + size) * cell_z + slack, o.z, inverse.z, range);
}

static void cross_cell(Walk *walk, int x, int z)
{
	HitList *out = walk->out;
	int cell = z * walk->field->levels[0].width + x;
	for (int half = 0; half < 2; half++) {
		cross_half(walk->self, &walk->ray, 2 * cell + half, out);
		if (!walk->nearest || out->count == 0)
			continue;
		out->hits[0] = out->hits[out->count - 1];
		out->count = 1;
		walk->ray.tmax = out->hits[0].t;
	}
}

static void walk_block(Walk *walk, int level, int x, int z)
{
	if (!meets_block(walk, level, x, z))
		return;
	if (level == 0) {
		cross_cell(walk, x, z);
		return;
	}
	const Level *fine = &walk->field->levels[level - 1];
	for (int k = 0; k < 4; k++) {
		int part = k ^ walk->first, fx = 2 * x + (part & 1), fz = 2 * z + (part >> 1);
		if (fx < fine->width && fz < fine->depth)
			walk_block(walk, level - 1, fx, fz);
	}
}

static void height_field_cross(const Shape *self, const Ray *ray, int most, HitList *out)
{
	Vec3 d = ray->direction;
	Walk walk = {
		.self = self,
		.field = self->data,
		.ray = *ray,
		.inverse = vec3(1 / d.x, 1 / d.y, 1 / d.z),
		.first = (d.x < 0 ? 1 : 0) | (d.z < 0 ? 2 : 0),
		.nearest = most == 1,
		.out = out,
	};
	walk_block(&walk, walk.field->level_count - 1, 0, 0);
}

static void height_field_intersect(const Shape *self, const Ray *ray, HitList *out)
{
	height_field_cross(self, ray, INT_MAX, out);
}

static bool height_field_nearest(const Shape *self, const Ray *ray, Hit *out)
{
	return hit_nearest_by(height_field_cross, self, ray, out);
}

/* The cell under (x, z) and where in it; false outside the unit square. */
static bool find_cell(const HeightField *field, Vec3 p, int *part, Vec2 *at)
{
	double x = p.x * (field->desc.width - 1), z = p.z * (field->desc.depth - 1);
	if (!(p.x >= 0 && p.x <= 1 && p.z >= 0 && p.z <= 1))
		return false;
	int cx = (int)fmin(floor(x), field->desc.width - 2),
	    cz = (int)fmin(floor(z), field->desc.depth - 2);
	*at = (Vec2){x - cx, z - cz};
	*part = 2 * (cz * field->levels[0].width + cx) + (at->u + at->v > 1);
	return true;
}

static bool height_field_inside(const void *data, Vec3 p)
{
	const HeightField *field = data;
	int part;
	Vec2 at;
	if (p.y < field->floor || !find_cell(field, p, &part, &at))
		return false;
	Vec3 c[3];
	half_corners(field, part, c);
	double u = part & 1 ? 1 - at.v : at.u,
	       v = part & 1 ? 1 - at.u : at.v; /* weights of corners 1 and 2 */
	return p.y < c[0].y + u * (c[1].y - c[0].y) + v * (c[2].y - c[0].y);
}

static Vec3 height_field_normal(const void *data, const Hit *hit, Vec3 p)
{
	(void)p;
	Vec3 c[3];
	half_corners(data, hit->part, c);
	Vec3 n = vec3_cross(vec3_sub(c[2], c[0]), vec3_sub(c[1], c[0]));
	return n.y < 0 ? vec3_neg(n) : n;
}

/* The normal of a sample from its neighbours' heights. */
static Vec3 sample_normal(const HeightField *field, int x, int z)
{
	int x0 = x > 0 ? x - 1 : x, x1 = x < field->desc.width - 1 ? x + 1 : x;
	int z0 = z > 0 ? z - 1 : z, z1 = z < field->desc.depth - 1 ? z + 1 : z;
	double along_x = (height(field, x1, z) - height(field, x0, z)) * (field->desc.width - 1) /
			 (x1 - x0);
	double along_z = (height(field, x, z1) - height(field, x, z0)) * (field->desc.depth - 1) /
			 (z1 - z0);
	return vec3_normalize(vec3(-along_x, 1, -along_z));
}

static Vec3 smooth_normal(const void *data, const Hit *hit, Vec3 p)
{
	(void)p;
	const HeightField *field = data;
	int half = hit->part & 1, cell = hit->part >> 1;
	int x = cell % field->levels[0].width, z = cell / field->levels[0].width;
	Vec3 a = sample_normal(field, x + half, z + half), b = sample_normal(field, x + 1, z);
	Vec3 c = sample_normal(field, x, z + 1);
	return vec3_mad(vec3_mad(vec3_scale(a, 1 - hit->u - hit->v), hit->u, b), hit->v, c);
}

static Vec2 height_field_uv(const void *data, const Hit *hit, Vec3 p)
{
	(void)data, (void)hit;
	return (Vec2){p.x, p.z};
}

const ShapeClass height_field_class = {
	.name = "height_field",
	.bounds = height_field_bounds,
	.intersect = height_field_intersect,
	.nearest = height_field_nearest,
	.inside = height_field_inside,
	.normal = height_field_normal,
	.uv = height_field_uv,
};

const ShapeClass smooth_height_field_class = {
	.name = "height_field",
	.bounds = height_field_bounds,
	.intersect = height_field_intersect,
	.nearest = height_field_nearest,
	.inside = height_field_inside,
	.normal = height_field_normal,
	.uv = height_field_uv,
	.shading_normal = smooth_normal,
};
