#include "geom/patch.h"

/* ---- polygon ---- */

typedef struct Edge { Vec2 a, b; } Edge;

typedef struct Polygon {
	Vec3 origin, u, v, n; /* an orthonormal frame of the plane */
	const Edge *edges;
	int count;
	Vec2 lo, hi;
	Box3 box;
} Polygon;

/* Newell's normal: robust for any simple polygon, and of a first part with holes behind it. */
static Vec3 newell_normal(const Vec3 *p, int count)
{
	Vec3 n = vec3(0, 0, 0);
	for (int i = 0; i < count; i++)
		n = vec3_add(n,
			     vec3_cross(vec3_sub(p[i], p[0]), vec3_sub(p[(i + 1) % count], p[0])));
	return n;
}

static bool same(Vec3 a, Vec3 b) { return a.x == b.x && a.y == b.y && a.z == b.z; }

/* Points from the first one to the one that repeats it; all of them when none does. */
static int part_points(const Vec3 *p, int count)
{
	for (int i = 1; i < count; i++) {
		if (same(p[i], p[0]))
			return i + 1;
	}
	return count;
}

static Vec2 flatten(const Polygon *polygon, Vec3 p)
{
	Vec3 d = vec3_sub(p, polygon->origin);
	return (Vec2){vec3_dot(d, polygon->u), vec3_dot(d, polygon->v)};
}

static void add_edges(Polygon *polygon, Edge *edges, const Vec3 *p, int count)
{
	for (int i = 0; i < count; i++) {
		Edge edge = {flatten(polygon, p[i]), flatten(polygon, p[(i + 1) % count])};
		polygon->lo = (Vec2){fmin(polygon->lo.u, edge.a.u), fmin(polygon->lo.v, edge.a.v)};
		polygon->hi = (Vec2){fmax(polygon->hi.u, edge.a.u), fmax(polygon->hi.v, edge.a.v)};
		polygon->box = box3_add(polygon->box, p[i]);
		if (edge.a.u != edge.b.u || edge.a.v != edge.b.v)
			edges[polygon->count++] = edge;
	}
}

static bool is_flat(const Polygon *polygon, const Vec3 *p, int count)
{
	double size = vec3_distance(polygon->box.lo, polygon->box.hi);
	for (int i = 0; i < count; i++) {
		if (fabs(vec3_dot(vec3_sub(p[i], polygon->origin), polygon->n)) > 1e-5 * size)
			return false;
	}
	return true;
}

const void *polygon_create(Arena *arena, const Vec3 *points, int count, const char **error)
{
	*error = count < 3 ? "a polygon needs at least three points" : NULL;
	if (*error)
		return NULL;
	Polygon *polygon = ARENA_NEW(arena, Polygon);
	Edge *edges = ARENA_ARRAY(arena, Edge, count);
	Vec3 n = newell_normal(points, part_points(points, count));
	if (!(vec3_length(n) > 0)) {
		*error = "the points of a polygon must not lie in a line";
		return NULL;
	}
	*polygon = (Polygon){.origin = points[0],
			     .n = vec3_normalize(n),
			     .edges = edges,
			     .lo = {INFINITY, INFINITY},
			     .hi = {-INFINITY, -INFINITY},
			     .box = box3_empty()};
	vec3_frame(polygon->n, &polygon->u, &polygon->v);
	for (int start = 0; start < count;) {
		int length = part_points(points + start, count - start);
		add_edges(polygon, edges, points + start, length);
		start += length;
	}
	if (!is_flat(polygon, points, count))
		*error = "the points of a polygon must lie in a plane";
	return *error ? NULL : polygon;
}

static bool polygon_bounds(const void *data, Box3 *box)
{
	*box = ((const Polygon *)data)->box;
	return true;
}

static bool covers(const Polygon *polygon, Vec2 p)
{
	if (p.u < polygon->lo.u || p.u > polygon->hi.u || p.v < polygon->lo.v ||
	    p.v > polygon->hi.v)
		return false;
	bool inside = false;
	for (int i = 0; i < polygon->count; i++) {
		Vec2 a = polygon->edges[i].a, b = polygon->edges[i].b;
		if ((a.v > p.v) != (b.v > p.v))
			inside ^= p.u < a.u + (p.v - a.v) * (b.u - a.u) / (b.v - a.v);
	}
	return inside;
}

static bool polygon_nearest(const Shape *self, const Ray *ray, Hit *out)
{
	const Polygon *polygon = self->data;
	double along = vec3_dot(ray->direction, polygon->n);
	double t = vec3_dot(vec3_sub(polygon->origin, ray->origin), polygon->n) / along;
	if (along == 0 || !(t > ray->tmin && t < ray->tmax) ||
	    !covers(polygon, flatten(polygon, ray_at(ray, t))))
		return false;
	*out = (Hit){.t = t, .shape = self};
	return true;
}

static void polygon_intersect(const Shape *self, const Ray *ray, HitList *out)
{
	Hit hit;
	if (polygon_nearest(self, ray, &hit))
		hit_list_push(out, hit);
}

static Vec3 polygon_normal(const void *data, const Hit *hit, Vec3 p)
{
	(void)hit, (void)p;
	return ((const Polygon *)data)->n;
}

const ShapeClass polygon_class = {
	.name = "polygon",
	.flat = true,
	.bounds = polygon_bounds,
	.intersect = polygon_intersect,
	.normal = polygon_normal,
	.nearest = polygon_nearest,
};

/* ---- bicubic patch ---- */

enum { MOST_STEPS = 8 };

static void bernstein(double s, double b[4], double db[4])
{
	double r = 1 - s;
	b[0] = r * r * r;
	b[1] = 3 * s * r * r;
	b[2] = 3 * s * s * r;
	b[3] = s * s * s;
	db[0] = -3 * r * r;
	db[1] = 3 * r * r - 6 * s * r;
	db[2] = 6 * s * r - 3 * s * s;
	db[3] = 3 * s * s;
}

/* A point of the patch at (u, v), v along the control rows, and its normal. */
static Vec3 patch_point(const Vec3 control[16], double u, double v, Vec3 *normal)
{
	double bu[4], du[4], bv[4], dv[4];
	bernstein(u, bu, du);
	bernstein(v, bv, dv);
	Vec3 p = vec3(0, 0, 0), along_u = p, along_v = p;
	for (int i = 0; i < 4; i++) {
		for (int j = 0; j < 4; j++) {
			p = vec3_mad(p, bv[i] * bu[j], control[4 * i + j]);
			along_u = vec3_mad(along_u, bv[i] * du[j], control[4 * i + j]);
			along_v = vec3_mad(along_v, dv[i] * bu[j], control[4 * i + j]);
		}
	}
	*normal = vec3_cross(along_u, along_v);
	return p;
}

/* At a degenerate corner the normal vanishes: take the one a little further inside. */
static Vec3 patch_normal(const Vec3 control[16], double u, double v, Vec3 normal)
{
	if (vec3_length2(normal) < 1e-20)
		patch_point(control, u + (0.5 - u) * 1e-3, v + (0.5 - v) * 1e-3, &normal);
	return vec3_normalize(normal);
}

static double plane_distance(Vec3 a, Vec3 b, Vec3 c, Vec3 p)
{
	Vec3 n = vec3_normalize(vec3_cross(vec3_sub(b, a), vec3_sub(c, a)));
	return fabs(vec3_dot(n, vec3_sub(p, a)));
}

/* Doublings needed until cells are as flat as asked; the bow of a Bezier patch falls by four with
 * each. */
static int steps_for(const PatchDesc *desc, int most)
{
	most = most < 0 ? 0 : most > MOST_STEPS ? MOST_STEPS : most;
	if (desc->flatness <= 0)
		return most;
	double bow = 0;
	for (int i = 0; i < 16; i++)
		bow = fmax(bow, plane_distance(desc->control[0], desc->control[3],
					       desc->control[12], desc->control[i]));
	int steps = 0;
	for (; steps < most && bow > desc->flatness; steps++)
		bow /= 4;
	return steps;
}

typedef struct PatchGrid {
	float (*points)[3], (*normals)[3], (*uvs)[2];
	int (*triangles)[3];
	int columns, rows; /* cells */
} PatchGrid;

static Vec2 patch_uv(const PatchDesc *desc, double u, double v)
{
	if (!desc->uv)
		return (Vec2){u, v};
	const Vec2 *k = desc->uv;
	double w[4] = {(1 - u) * (1 - v), u * (1 - v), u * v, (1 - u) * v};
	Vec2 sum = {0, 0};
	for (int i = 0; i < 4; i++)
		sum = (Vec2){sum.u + w[i] * k[i].u, sum.v + w[i] * k[i].v};
	return sum;
}

static void fill_points(const PatchDesc *desc, PatchGrid *grid)
{
	for (int row = 0, i = 0; row <= grid->rows; row++) {
		for (int column = 0; column <= grid->columns; column++, i++) {
			double u = column / (double)grid->columns, v = row / (double)grid->rows;
			Vec3 normal, p = patch_point(desc->control, u, v, &normal);
			Vec2 uv = patch_uv(desc, u, v);
			vec3_to_floats(p, grid->points[i]);
			vec3_to_floats(patch_normal(desc->control, u, v, normal), grid->normals[i]);
			grid->uvs[i][0] = (float)uv.u;
			grid->uvs[i][1] = (float)uv.v;
		}
	}
}

static void fill_triangles(PatchGrid *grid)
{
	for (int row = 0, i = 0; row < grid->rows; row++) {
		for (int column = 0; column < grid->columns; column++, i += 2) {
			int a = row * (grid->columns + 1) + column, b = a + 1,
			    c = a + grid->columns + 1, d = c + 1;
			int cell[2][3] = {{a, b, d}, {a, d, c}};
			for (int k = 0; k < 3; k++) {
				grid->triangles[i][k] = cell[0][k];
				grid->triangles[i + 1][k] = cell[1][k];
			}
		}
	}
}

Mesh *bicubic_patch_create(Arena *arena, const PatchDesc *desc)
{
	PatchGrid grid = {.columns = 1 << steps_for(desc, desc->u_steps),
			  .rows = 1 << steps_for(desc, desc->v_steps)};
	int points = (grid.columns + 1) * (grid.rows + 1), triangles = 2 * grid.columns * grid.rows;
	grid.points = arena_alloc(arena, sizeof(float[3]) * (size_t)points);
	grid.normals = arena_alloc(arena, sizeof(float[3]) * (size_t)points);
	grid.uvs = arena_alloc(arena, sizeof(float[2]) * (size_t)points);
	grid.triangles = arena_alloc(arena, sizeof(int[3]) * (size_t)triangles);
	fill_points(desc, &grid);
	fill_triangles(&grid);
	MeshDesc mesh = {.vertices = grid.points,
			 .vertex_count = points,
			 .triangles = grid.triangles,
			 .triangle_count = triangles,
			 .normals = grid.normals,
			 .normal_count = points,
			 .uvs = grid.uvs,
			 .uv_count = points};
	const char *error;
	return mesh_create(arena, &mesh, &error);
}
