#include "geom/csg.h"

#include "geom/box_tree.h"
#include "geom/ray_box.h"

enum {
	TREE_MIN_CHILDREN = 12, /* fewer children than this are looked at one by one */
	CUT_PASSES = 3, /* so often children cut each other's bounds: each needs those before it */
};

struct CsgTree {
	const BoxTree *surfaces, *regions;
};

typedef enum CsgOperation { CSG_UNION, CSG_INTERSECTION, CSG_MERGE } CsgOperation;

/* A CSG shape as it acts, with `inverted` taken in. */
typedef struct CsgView {
	CsgOperation operation;
	const Csg *csg;
	bool flip; /* the children count as inverted */
} CsgView;

bool csg_is(const Shape *shape)
{
	return shape->class == &csg_union_class || shape->class == &csg_intersection_class ||
	       shape->class == &csg_merge_class;
}

static CsgView csg_view(const Shape *shape)
{
	CsgOperation operation = CSG_UNION;
	if (shape->class == &csg_intersection_class)
		operation = shape->inverted ? CSG_MERGE : CSG_INTERSECTION;
	else if (shape->inverted)
		operation = CSG_INTERSECTION;
	else if (shape->class == &csg_merge_class)
		operation = CSG_MERGE;
	return (CsgView){operation, shape->data, shape->inverted};
}

/* ---- bounds ---- */

static Box3 infinite_box(void)
{
	return (Box3){vec3_all(-INFINITY), vec3_all(INFINITY)};
}

static Box3 child_region(const CsgView *view, int i)
{
	if (!view->flip)
		return shape_region_box(view->csg->children[i]);
	/* A clipped shape, inverted, is not the complement of what it was; be careful and bound
	 * nothing. */
	Shape flipped = *view->csg->children[i];
	flipped.inverted = !flipped.inverted;
	return flipped.clip_count ? infinite_box() : shape_region_box(&flipped);
}

/* What the children cut off each other: planes and quadrics that bound nothing alone do together.
 */
static Box3 cut_region(const CsgView *view, Box3 box)
{
	for (int pass = 0; pass < CUT_PASSES; pass++)
		for (int i = 0; i < view->csg->count; i++) {
			Shape child = *view->csg->children[i];
			child.inverted = child.inverted != view->flip;
			if (child.class->cut && !child.clip_count)
				box = shape_region_cut(&child, box);
		}
	return box;
}

static Box3 combined_region(const CsgView *view)
{
	bool intersect = view->operation == CSG_INTERSECTION;
	Box3 box = intersect ? infinite_box() : box3_empty();
	for (int i = 0; i < view->csg->count; i++) {
		Box3 region = child_region(view, i);
		box = intersect ? box3_intersect(box, region) : box3_union(box, region);
	}
	return intersect ? cut_region(view, box) : box;
}

Box3 csg_region_box(const Shape *shape)
{
	CsgView view = csg_view(shape);
	return combined_region(&view);
}

Box3 csg_surface_box(const Shape *shape)
{
	CsgView view = csg_view(shape);
	Box3 box = box3_empty();
	for (int i = 0; i < view.csg->count; i++)
		box = box3_union(box, view.csg->children[i]->box);
	return view.operation == CSG_INTERSECTION ? box3_intersect(box, combined_region(&view))
						  : box;
}

const Csg *csg_create(Arena *arena, const Shape *const *children, int count)
{
	Csg *csg = ARENA_NEW(arena, Csg);
	csg->children = children;
	csg->count = count;
	if (count < TREE_MIN_CHILDREN)
		return csg;
	CsgTree *tree = ARENA_NEW(arena, CsgTree);
	Box3 *boxes = ARENA_ARRAY(arena, Box3, count);
	for (int i = 0; i < count; i++)
		boxes[i] = children[i]->box;
	tree->surfaces = box_tree_create(arena, boxes, count);
	for (int i = 0; i < count; i++)
		boxes[i] = shape_region_box(children[i]);
	tree->regions = box_tree_create(arena, boxes, count);
	csg->tree = tree;
	return csg;
}

/* ---- inside ---- */

typedef struct InsideQuery {
	const Csg *csg;
	Vec3 p;
	int skip; /* a child that is not asked; -1: none */
} InsideQuery;

static bool visit_inside(void *data, int item)
{
	InsideQuery *query = data;
	return item != query->skip && shape_inside(query->csg->children[item], query->p);
}

static bool is_inside_any(const Csg *csg, Vec3 p, int skip)
{
	InsideQuery query = {csg, p, skip};
	if (csg->tree)
		return box_tree_walk_point(csg->tree->regions, p, visit_inside, &query);
	for (int i = 0; i < csg->count; i++)
		if (visit_inside(&query, i))
			return true;
	return false;
}

static bool is_inside_all(const Csg *csg, Vec3 p, int skip)
{
	for (int i = 0; i < csg->count; i++)
		if (i != skip && !shape_inside(csg->children[i], p))
			return false;
	return true;
}

static bool union_inside(const void *data, Vec3 p)
{
	return is_inside_any(data, p, -1);
}

static bool intersection_inside(const void *data, Vec3 p)
{
	return is_inside_all(data, p, -1);
}

/* Whether a crossing of child i, at p, belongs to the surface of the whole. */
static bool is_on_surface(const CsgView *view, int i, Vec3 p)
{
	switch (view->operation) {
	case CSG_INTERSECTION:
		return view->flip ? !is_inside_any(view->csg, p, i)
				  : is_inside_all(view->csg, p, i);
	case CSG_MERGE:
		return view->flip ? is_inside_all(view->csg, p, i)
				  : !is_inside_any(view->csg, p, i);
	case CSG_UNION:
		break;
	}
	return true;
}

/* Of a child that the ray nowhere crosses: whether it leaves nothing of the others' surfaces along
 * the ray, since that is outside of what they intersect with, or inside of what they merge with.
 * Far from the ends, which may lie on the child's surface. */
static bool leaves_nothing(const CsgView *view, int i, const Ray *ray)
{
	const Shape *child = view->csg->children[i];
	if (!child->closed || !(ray->tmax < INFINITY))
		return false;
	bool leaving = (view->operation == CSG_INTERSECTION) != view->flip;
	return shape_inside(child, ray_at(ray, 0.5 * (ray->tmin + ray->tmax))) != leaving;
}

/* ---- all crossings ---- */

typedef struct RayQuery {
	CsgView view;
	const Ray *ray;
	HitList *out;
} RayQuery;

static bool visit_crossings(void *data, int item)
{
	RayQuery *query = data;
	HitList *out = query->out;
	int kept = out->count;
	shape_intersect(query->view.csg->children[item], query->ray, out);
	if (query->view.operation == CSG_UNION)
		return false;
	if (out->count == kept)
		return leaves_nothing(&query->view, item, query->ray);
	for (int i = kept; i < out->count; i++)
		if (is_on_surface(&query->view, item, ray_at(query->ray, out->hits[i].t)))
			out->hits[kept++] = out->hits[i];
	out->count = kept;
	return false;
}

/* Calls visit for the children whose boxes the ray may touch until one says that it was the last.
 * slabs.tmax may shrink meanwhile. */
static void walk_children(const Csg *csg, const RaySlabs *slabs, BoxTreeVisit *visit, void *data)
{
	if (csg->tree) {
		box_tree_walk_ray(csg->tree->surfaces, slabs, visit, data);
		return;
	}
	for (int i = 0; i < csg->count; i++)
		if (ray_slabs_hit(slabs, &csg->children[i]->box) && visit(data, i))
			return;
}

/* The ray where it is in the box, and a little more for rounding: of an operation that removes
 * crossings all others are removed. */
static Ray ray_within(const Ray *ray, const RaySlabs *slabs, const Box3 *box)
{
	double t[2];
	ray_slabs_range(slabs, box, t);
	double slack = 1e-9 * (fabs(t[0]) + fabs(t[1]));
	double enter = t[0] - slack, leave = t[1] + slack;
	return (Ray){ray->origin, ray->direction, enter > ray->tmin ? enter : ray->tmin,
		     leave < ray->tmax ? leave : ray->tmax};
}

static void csg_intersect(const Shape *self, const Ray *ray, HitList *out)
{
	RaySlabs slabs = ray_slabs(ray);
	if (!ray_slabs_hit(&slabs, &self->box))
		return;
	RayQuery query = {csg_view(self), ray, out};
	Ray within = ray_within(ray, &slabs, &self->box);
	if (query.view.operation != CSG_UNION)
		query.ray = &within;
	walk_children(query.view.csg, &slabs, visit_crossings, &query);
}

/* ---- nearest crossing ---- */

typedef struct NearestQuery {
	CsgView view;
	Ray ray;        /* tmax shrinks to the best hit */
	RaySlabs slabs; /* the same */
	Hit *best;
	bool found;
} NearestQuery;

static void nearest_take(NearestQuery *query, const Hit *hit)
{
	*query->best = *hit;
	query->ray.tmax = query->slabs.tmax = hit->t;
	query->found = true;
}

static bool visit_union_nearest(void *data, int item)
{
	NearestQuery *query = data;
	Hit hit;
	if (shape_nearest(query->view.csg->children[item], &query->ray, &hit))
		nearest_take(query, &hit);
	return false;
}

/* The first crossing of the child that is on the whole's surface. */
static bool visit_surface_nearest(void *data, int item)
{
	NearestQuery *query = data;
	HitList list;
	hit_list_init(&list);
	shape_intersect(query->view.csg->children[item], &query->ray, &list);
	hit_list_sort(&list);
	bool done = list.count == 0 && !query->found &&
		    leaves_nothing(&query->view, item, &query->ray);
	for (int i = 0; i < list.count; i++) {
		if (!is_on_surface(&query->view, item, ray_at(&query->ray, list.hits[i].t)))
			continue;
		nearest_take(query, &list.hits[i]);
		break;
	}
	hit_list_free(&list);
	return done;
}

static bool csg_nearest(const Shape *self, const Ray *ray, Hit *out)
{
	NearestQuery query = {csg_view(self), *ray, ray_slabs(ray), out, false};
	if (!ray_slabs_hit(&query.slabs, &self->box))
		return false;
	bool simple = query.view.operation == CSG_UNION;
	if (!simple)
		query.ray = ray_within(ray, &query.slabs, &self->box);
	walk_children(query.view.csg, &query.slabs,
		      simple ? visit_union_nearest : visit_surface_nearest, &query);
	return query.found;
}

/* ---- inversion ---- */

static const ShapeClass *inverse_class(const Shape *shape)
{
	return shape->class == &csg_intersection_class ? &csg_merge_class : &csg_intersection_class;
}

static void invert_children(Arena *arena, Shape *shape)
{
	const Csg *csg = shape->data;
	const Shape **children = ARENA_ARRAY(arena, const Shape *, csg->count);
	for (int i = 0; i < csg->count; i++)
		children[i] = csg_invert(arena, csg->children[i]);
	shape->data = csg_create(arena, children, csg->count);
}

const Shape *csg_invert(Arena *arena, const Shape *shape)
{
	Shape *copy = arena_copy(arena, shape, sizeof(*shape));
	if (!csg_is(shape)) {
		copy->inverted = !copy->inverted;
	} else if (shape->inverted) {
		copy->inverted = false;
	} else {
		copy->class = inverse_class(shape);
		invert_children(arena, copy);
	}
	shape_finish(copy);
	return copy;
}

/* ---- classes ---- */

static bool csg_closed(const void *data)
{
	const Csg *csg = data;
	for (int i = 0; i < csg->count; i++)
		if (!csg->children[i]->closed)
			return false;
	return true;
}

/* Never asked: shape_finish takes csg_surface_box, and hits belong to primitives. */
static bool csg_bounds(const void *data, Box3 *box)
{
	(void)data;
	*box = infinite_box();
	return false;
}

static Vec3 csg_normal(const void *data, const Hit *hit, Vec3 p)
{
	(void)data;
	(void)hit;
	(void)p;
	return vec3(0, 1, 0);
}

const ShapeClass csg_union_class = {
	.name = "union",
	.bounds = csg_bounds,
	.intersect = csg_intersect,
	.inside = union_inside,
	.normal = csg_normal,
	.nearest = csg_nearest,
	.closed = csg_closed,
};

const ShapeClass csg_intersection_class = {
	.name = "intersection",
	.bounds = csg_bounds,
	.intersect = csg_intersect,
	.inside = intersection_inside,
	.normal = csg_normal,
	.nearest = csg_nearest,
	.closed = csg_closed,
};

const ShapeClass csg_merge_class = {
	.name = "merge",
	.bounds = csg_bounds,
	.intersect = csg_intersect,
	.inside = union_inside,
	.normal = csg_normal,
	.nearest = csg_nearest,
	.closed = csg_closed,
};
