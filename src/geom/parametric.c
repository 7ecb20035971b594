/*
 * The range of (u, v) is divided into a grid of cells whose boxes, a little larger than their
 * corners and middles ask for, stand in a tree. In each cell that a ray may touch, the two
 * triangles of its corners give a first guess and Newton's iteration on surface(u, v) = origin + t
 * direction finds the crossing. Details finer than the grid may be missed.
 */
#include "geom/parametric.h"

#include "geom/box_tree.h"

enum { GRID_DEFAULT = 64, GRID_FINE = 160, NEWTON_STEPS = 24 };

typedef struct Parametric {
	ParametricDesc desc;
	int grid;            /* cells along u and along v */
	Vec2 step;           /* size of a cell */
	const Vec3 *corners; /* (grid + 1)^2, u fastest */
	const BoxTree *tree;
	Box3 box;
} Parametric;

ParametricDesc parametric_default(void)
{
	return (ParametricDesc){
		.container = container_default(), .accuracy = 0.001, .max_gradient = 1};
}

static Vec3 point_at(const Parametric *shape, Vec2 at)
{
	return shape->desc.point(shape->desc.function, at.u, at.v);
}

static Vec2 grid_place(const Parametric *shape, double column, double row)
{
	return (Vec2){shape->desc.lo.u + column * shape->step.u,
		      shape->desc.lo.v + row * shape->step.v};
}

/* The box of a cell: its corners and middle, wider by how far the middle bulges. */
static Box3 cell_box(const Parametric *shape, int cell)
{
	int column = cell % shape->grid, row = cell / shape->grid, width = shape->grid + 1;
	const Vec3 *corner = shape->corners + row * width + column;
	Box3 box = box3_empty();
	const Vec3 corners[] = {corner[0], corner[1], corner[width], corner[width + 1]};
	Vec3 sum = vec3_all(0);
	for (int i = 0; i < 4; i++) {
		if (!vec3_is_finite(corners[i]))
			return box3_empty();
		box = box3_add(box, corners[i]);
		sum = vec3_mad(sum, 0.25, corners[i]);
	}
	Vec3 middle = point_at(shape, grid_place(shape, column + 0.5, row + 0.5));
	double bulge = 1.5 * vec3_distance(sum, middle) + 0.05 * vec3_distance(box.lo, box.hi);
	if (!vec3_is_finite(middle))
		return box3_empty();
	Vec3 margin = vec3_all(bulge);
	return (Box3){vec3_sub(box.lo, margin), vec3_add(box.hi, margin)};
}

static void compute_corners(Arena *arena, Parametric *shape)
{
	int width = shape->grid + 1;
	Vec3 *corners = ARENA_ARRAY(arena, Vec3, width * width);
	for (int row = 0; row < width; row++)
		for (int column = 0; column < width; column++)
			corners[row * width + column] = point_at(shape,
								 grid_place(shape, column, row));
	shape->corners = corners;
}

const void *parametric_create(Arena *arena, const ParametricDesc *desc, const char **error)
{
	if (!(desc->lo.u < desc->hi.u && desc->lo.v < desc->hi.v)) {
		*error = "the range of u and v is empty";
		return NULL;
	}
	Parametric *shape = ARENA_NEW(arena, Parametric);
	shape->desc = *desc;
	shape->grid = desc->precompute > 12 ? GRID_FINE : GRID_DEFAULT;
	shape->step = (Vec2){(desc->hi.u - desc->lo.u) / shape->grid,
			     (desc->hi.v - desc->lo.v) / shape->grid};
	compute_corners(arena, shape);
	int count = shape->grid * shape->grid;
	Box3 *boxes = ARENA_ARRAY(arena, Box3, count),
	     container = container_bounds(&desc->container);
	shape->box = box3_empty();
	for (int i = 0; i < count; i++) {
		boxes[i] = box3_intersect(cell_box(shape, i), container);
		if (!box3_is_empty(boxes[i]))
			shape->box = box3_union(shape->box, boxes[i]);
	}
	shape->tree = box_tree_create(arena, boxes, count);
	return shape;
}

static bool parametric_bounds(const void *data, Box3 *box)
{
	*box = ((const Parametric *)data)->box;
	return true;
}

/* Tangents by central differences. */
static void tangents_at(const Parametric *shape, Vec2 at, Vec3 *u, Vec3 *v)
{
	double du = 1e-4 * shape->step.u, dv = 1e-4 * shape->step.v;
	*u = vec3_scale(vec3_sub(point_at(shape, (Vec2){at.u + du, at.v}),
				 point_at(shape, (Vec2){at.u - du, at.v})),
			0.5 / du);
	*v = vec3_scale(vec3_sub(point_at(shape, (Vec2){at.u, at.v + dv}),
				 point_at(shape, (Vec2){at.u, at.v - dv})),
			0.5 / dv);
}

/* Solves a x + b y + c z = d. */
static bool solve(Vec3 a, Vec3 b, Vec3 c, Vec3 d, Vec3 *out)
{
	Vec3 bc = vec3_cross(b, c);
	double determinant = vec3_dot(a, bc);
	*out = vec3(vec3_dot(d, bc) / determinant, vec3_dot(a, vec3_cross(d, c)) / determinant,
	            vec3_dot(a, vec3_cross(b, d)) / determinant);
	return vec3_is_finite(*out);
}

typedef struct ParametricQuery {
	const Shape *self;
	const Ray *ray;
	HitList *out;
	int first; /* hits before it are someone else's */
} ParametricQuery;

/* Newton from a place in a cell; false when it does not arrive in the cell. */
static bool polish(const Parametric *shape, const Ray *ray, Vec2 low, Vec2 *at, double *t)
{
	Vec2 slack = {0.02 * shape->step.u, 0.02 * shape->step.v};
	for (int i = 0; i < NEWTON_STEPS; i++) {
		Vec3 u, v, change, miss = vec3_sub(ray_at(ray, *t), point_at(shape, *at));
		tangents_at(shape, *at, &u, &v);
		if (!solve(u, v, vec3_neg(ray->direction), miss, &change))
			return false;
		at->u += change.x;
		at->v += change.y;
		*t += change.z;
		if (fabs(at->u - low.u) > 3 * shape->step.u ||
		    fabs(at->v - low.v) > 3 * shape->step.v)
			return false;
		if (fabs(change.x) < 1e-9 * shape->step.u && fabs(change.y) < 1e-9 * shape->step.v)
			break;
	}
	return at->u >= low.u - slack.u && at->u <= low.u + shape->step.u + slack.u &&
	       at->v >= low.v - slack.v && at->v <= low.v + shape->step.v + slack.v &&
	       at->u >= shape->desc.lo.u && at->u <= shape->desc.hi.u &&
	       at->v >= shape->desc.lo.v && at->v <= shape->desc.hi.v;
}

/* Neighbouring cells and guesses may find the same crossing. */
static void add_crossing(const ParametricQuery *query, double t, Vec2 at)
{
	const Parametric *shape = query->self->data;
	const Ray *ray = query->ray;
	double same = 1e-7 * (1 + fabs(t));
	for (int i = query->first; i < query->out->count; i++)
		if (fabs(query->out->hits[i].t - t) < same)
			return;
	if (t > ray->tmin && t < ray->tmax &&
	    container_inside(&shape->desc.container, ray_at(ray, t)))
		hit_list_push(query->out,
			      (Hit){.t = t, .shape = query->self, .u = at.u, .v = at.v});
}

static bool visit_cell(void *data, int cell)
{
	ParametricQuery *query = data;
	const Parametric *shape = query->self->data;
	int column = cell % shape->grid, row = cell / shape->grid, width = shape->grid + 1;
	const Vec3 *corner = shape->corners + row * width + column;
	Vec2 low = grid_place(shape, column, row);
	for (int half = 0; half < 2; half++) {
		Vec3 start = half ? corner[width + 1] : corner[0], guess;
		Vec3 u = half ? vec3_sub(corner[width], start) : vec3_sub(corner[1], start);
		Vec3 v = half ? vec3_sub(corner[1], start) : vec3_sub(corner[width], start);
		if (!solve(u, v, vec3_neg(query->ray->direction),
			   vec3_sub(query->ray->origin, start), &guess))
			continue;
		double a = fmax(0, fmin(1, guess.x)), b = fmax(0, fmin(1, guess.y)), t = guess.z;
		Vec2 at = {low.u + (half ? 1 - a : a) * shape->step.u,
			   low.v + (half ? 1 - b : b) * shape->step.v};
		if (polish(shape, query->ray, low, &at, &t))
			add_crossing(query, t, at);
	}
	return false;
}

static void parametric_intersect(const Shape *self, const Ray *ray, HitList *out)
{
	const Parametric *shape = self->data;
	RaySlabs slabs = ray_slabs(ray);
	ParametricQuery query = {self, ray, out, out->count};
	box_tree_walk_ray(shape->tree, &slabs, visit_cell, &query);
}

static Vec3 parametric_normal(const void *data, const Hit *hit, Vec3 p)
{
	Vec3 u, v;
	(void)p;
	tangents_at(data, (Vec2){hit->u, hit->v}, &u, &v);
	Vec3 n = vec3_cross(u, v);
	return vec3_is_finite(n) && vec3_length2(n) > 0 ? n : vec3(1, 0, 0);
}

static Vec2 parametric_uv(const void *data, const Hit *hit, Vec3 p)
{
	(void)data;
	(void)p;
	return (Vec2){hit->u, hit->v};
}

const ShapeClass parametric_class = {
	.name = "parametric",
	.bounds = parametric_bounds,
	.intersect = parametric_intersect,
	.normal = parametric_normal,
	.uv = parametric_uv,
};
