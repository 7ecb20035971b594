#include "geom/mesh.h"

#include <string.h>

#include "geom/mesh_tree.h"

/* ---- one triangle in double precision (Moeller & Trumbore 1997) ---- */

typedef struct Corners { Vec3 a, ab, ac; } Corners;

static bool hit_corners(const Corners *tri, const Ray *ray, Hit *hit)
{
	Vec3 p = vec3_cross(ray->direction, tri->ac);
	double determinant = vec3_dot(tri->ab, p);
	if (determinant == 0)
		return false;
	double inverse = 1 / determinant;
	Vec3 from = vec3_sub(ray->origin, tri->a);
	double u = vec3_dot(from, p) * inverse;
	if (!(u >= 0 && u <= 1))
		return false;
	Vec3 q = vec3_cross(from, tri->ab);
	double v = vec3_dot(ray->direction, q) * inverse;
	double t = vec3_dot(tri->ac, q) * inverse;
	if (!(v >= 0 && u + v <= 1 && t > ray->tmin && t < ray->tmax))
		return false;
	hit->t = t;
	hit->u = u;
	hit->v = v;
	return true;
}

static Vec3 interpolate(Vec3 a, Vec3 b, Vec3 c, const Hit *hit)
{
	double w = 1 - hit->u - hit->v;
	return vec3(w * a.x + hit->u * b.x + hit->v * c.x, w * a.y + hit->u * b.y + hit->v * c.y,
	            w * a.z + hit->u * b.z + hit->v * c.z);
}

static bool triangle_bounds(const void *data, Box3 *box)
{
	const Triangle *tri = data;
	*box = box3_empty();
	for (int i = 0; i < 3; i++)
		*box = box3_add(*box, tri->corner[i]);
	return true;
}

static bool triangle_nearest(const Shape *self, const Ray *ray, Hit *out)
{
	const Triangle *tri = self->data;
	Corners corners = {tri->corner[0], vec3_sub(tri->corner[1], tri->corner[0]),
			   vec3_sub(tri->corner[2], tri->corner[0])};
	out->shape = self;
	out->part = 0;
	return hit_corners(&corners, ray, out);
}

static void triangle_intersect(const Shape *self, const Ray *ray, HitList *out)
{
	Hit hit;
	if (triangle_nearest(self, ray, &hit))
		hit_list_push(out, hit);
}

static Vec3 triangle_normal(const void *data, const Hit *hit, Vec3 p)
{
	(void)hit, (void)p;
	const Triangle *tri = data;
	return vec3_cross(vec3_sub(tri->corner[1], tri->corner[0]),
			  vec3_sub(tri->corner[2], tri->corner[0]));
}

static Vec3 triangle_shading_normal(const void *data, const Hit *hit, Vec3 p)
{
	const Triangle *tri = data;
	if (!tri->smooth)
		return triangle_normal(data, hit, p);
	return interpolate(tri->normal[0], tri->normal[1], tri->normal[2], hit);
}

static Vec2 triangle_uv(const void *data, const Hit *hit, Vec3 p)
{
	const Triangle *tri = data;
	if (!tri->has_uv)
		return (Vec2){p.x, p.y};
	double w = 1 - hit->u - hit->v;
	return (Vec2){w * tri->uv[0].u + hit->u * tri->uv[1].u + hit->v * tri->uv[2].u,
	              w * tri->uv[0].v + hit->u * tri->uv[1].v + hit->v * tri->uv[2].v};
}

const ShapeClass triangle_class = {
	.name = "triangle",
	.flat = true,
	.bounds = triangle_bounds,
	.intersect = triangle_intersect,
	.normal = triangle_normal,
	.uv = triangle_uv,
	.nearest = triangle_nearest,
};

const ShapeClass smooth_triangle_class = {
	.name = "smooth_triangle",
	.flat = true,
	.bounds = triangle_bounds,
	.intersect = triangle_intersect,
	.normal = triangle_normal,
	.uv = triangle_uv,
	.nearest = triangle_nearest,
	.shading_normal = triangle_shading_normal,
};

/* ---- meshes ---- */

static bool indices_in_range(const int (*rows)[3], int count, int lowest, int limit)
{
	for (int i = 0; rows && i < count; i++) {
		for (int k = 0; k < 3; k++) {
			if (rows[i][k] < lowest || rows[i][k] >= limit)
				return false;
		}
	}
	return true;
}

static const char *range_error(const MeshDesc *d)
{
	if (!indices_in_range(d->triangles, d->triangle_count, 0, d->vertex_count))
		return "a face index is out of range";
	if (d->normals &&
	    !indices_in_range(d->normal_indices ? d->normal_indices : d->triangles,
			      d->triangle_count, d->normal_indices ? -1 : 0, d->normal_count))
		return "a normal index is out of range";
	if (d->uvs && !indices_in_range(d->uv_indices ? d->uv_indices : d->triangles,
					d->triangle_count, 0, d->uv_count))
		return "a uv index is out of range";
	return NULL;
}

typedef float Corner3[3][3];

static const Corner3 *copy_corners(Arena *arena, const MeshDesc *desc)
{
	Corner3 *corners = ARENA_ARRAY(arena, Corner3, desc->triangle_count);
	for (int i = 0; i < desc->triangle_count; i++)
		for (int k = 0; k < 3; k++)
			memcpy(corners[i][k], desc->vertices[desc->triangles[i][k]],
			       sizeof corners[i][k]);
	return (const Corner3 *)corners;
}

static void set_unit_normals(const MeshDesc *desc, const int *index, Corner3 out)
{
	for (int k = 0; k < 3; k++) {
		Vec3 n = vec3_of_floats(desc->normals[index[k]]);
		vec3_to_floats(vec3_normalize(n), out[k]);
	}
}

/* Those of flat triangles stay 0. */
static const Corner3 *copy_normals(Arena *arena, const MeshDesc *desc)
{
	if (!desc->normals)
		return NULL;
	Corner3 *normals = ARENA_ARRAY(arena, Corner3, desc->triangle_count);
	for (int i = 0; i < desc->triangle_count; i++) {
		const int *index = (desc->normal_indices ? desc->normal_indices
							 : desc->triangles)[i];
		if (index[0] >= 0 && index[1] >= 0 && index[2] >= 0)
			set_unit_normals(desc, index, normals[i]);
	}
	return (const Corner3 *)normals;
}

Mesh *mesh_create(Arena *arena, const MeshDesc *desc, const char **error)
{
	*error = range_error(desc);
	if (*error)
		return NULL;
	Mesh *mesh = ARENA_NEW(arena, Mesh);
	mesh->desc = *desc;
	mesh->corners = copy_corners(arena, desc);
	mesh->normals = copy_normals(arena, desc);
	mesh->box = box3_empty();
	for (int i = 0; i < desc->vertex_count; i++)
		mesh->box = box3_add(mesh->box, vec3_of_floats(desc->vertices[i]));
	mesh->tree = mesh_tree_create(arena, desc->triangle_count);
	return mesh;
}

static Vec3 vertex(const Mesh *mesh, int triangle, int corner)
{
	return vec3_of_floats(mesh->corners[triangle][corner]);
}

bool mesh_hit_triangle(const Mesh *mesh, int triangle, const Ray *ray, Hit *hit)
{
	if (mesh->normals) /* who is told of a hit will ask for its normal */
		__builtin_prefetch(mesh->normals[triangle]);
	Vec3 a = vertex(mesh, triangle, 0);
	Corners corners = {a, vec3_sub(vertex(mesh, triangle, 1), a),
			   vec3_sub(vertex(mesh, triangle, 2), a)};
	if (!hit_corners(&corners, ray, hit))
		return false;
	hit->part = triangle;
	return true;
}

static bool mesh_bounds(const void *data, Box3 *box)
{
	*box = ((const Mesh *)data)->box;
	return true;
}

typedef struct Collect {
	const Shape *self;
	HitList *out;
} Collect;

static void collect_triangle(void *data, int triangle, Ray *ray)
{
	Collect *collect = data;
	Hit hit;
	if (mesh_hit_triangle(collect->self->data, triangle, ray, &hit)) {
		hit.shape = collect->self;
		hit_list_push(collect->out, hit);
	}
}

static void mesh_intersect(const Shape *self, const Ray *ray, HitList *out)
{
	Collect collect = {self, out};
	Ray copy = *ray;
	mesh_tree_visit(self->data, &copy, collect_triangle, &collect);
}

typedef struct Nearest {
	const Mesh *mesh;
	Hit hit;
	bool found;
} Nearest;

static void nearest_triangle(void *data, int triangle, Ray *ray)
{
	Nearest *nearest = data;
	if (mesh_hit_triangle(nearest->mesh, triangle, ray, &nearest->hit)) {
		nearest->found = true;
		ray->tmax = nearest->hit.t;
	}
}

static bool mesh_nearest(const Shape *self, const Ray *ray, Hit *out)
{
	Nearest nearest = {.mesh = self->data};
	Ray copy = *ray;
	mesh_tree_visit(self->data, &copy, nearest_triangle, &nearest);
	if (!nearest.found)
		return false;
	*out = nearest.hit;
	out->shape = self;
	return true;
}

static void count_triangle(void *data, int triangle, Ray *ray)
{
	Nearest *nearest = data;
	if (mesh_hit_triangle(nearest->mesh, triangle, ray, &nearest->hit))
		nearest->found = !nearest->found;
}

/* Inside when a ray along the inside vector leaves through an odd number of triangles. */
static bool mesh_inside(const void *data, Vec3 p)
{
	const Mesh *mesh = data;
	if (!mesh->desc.has_inside_vector || !box3_contains(mesh->box, p))
		return false;
	Nearest odd = {.mesh = mesh};
	Ray ray = {p, mesh->desc.inside_vector, 0, INFINITY};
	mesh_tree_visit(mesh, &ray, count_triangle, &odd);
	return odd.found;
}

static Vec3 mesh_normal(const void *data, const Hit *hit, Vec3 p)
{
	(void)p;
	Vec3 a = vertex(data, hit->part, 0);
	return vec3_cross(vec3_sub(vertex(data, hit->part, 1), a),
			  vec3_sub(vertex(data, hit->part, 2), a));
}

static Vec3 mesh_shading_normal(const void *data, const Hit *hit, Vec3 p)
{
	const Mesh *mesh = data;
	if (!mesh->normals)
		return mesh_normal(data, hit, p);
	Vec3 n[3];
	for (int k = 0; k < 3; k++)
		n[k] = vec3_of_floats(mesh->normals[hit->part][k]);
	Vec3 smooth = interpolate(n[0], n[1], n[2], hit);
	return vec3_length2(smooth) > 0 ? smooth : mesh_normal(data, hit, p);
}

static bool mesh_bent(const void *data, const Hit *hit)
{
	const Mesh *mesh = data;
	if (!mesh->normals)
		return false;
	const float *a = mesh->normals[hit->part][0], *b = mesh->normals[hit->part][1];
	return fabsf(a[0] - b[0]) + fabsf(a[1] - b[1]) + fabsf(a[2] - b[2]) > 1e-4f;
}

static Vec2 mesh_uv(const void *data, const Hit *hit, Vec3 p)
{
	const MeshDesc *d = &((const Mesh *)data)->desc;
	if (!d->uvs)
		return (Vec2){p.x, p.y};
	const int *index = (d->uv_indices ? d->uv_indices : d->triangles)[hit->part];
	const float *a = d->uvs[index[0]], *b = d->uvs[index[1]], *c = d->uvs[index[2]];
	double w = 1 - hit->u - hit->v;
	return (Vec2){w * a[0] + hit->u * b[0] + hit->v * c[0],
		      w * a[1] + hit->u * b[1] + hit->v * c[1]};
}

static void add_texture(ShapeTextures *out, int number, double weight)
{
	int i = 0;
	while (i < out->count && out->numbers[i] != number)
		i++;
	if (i == out->count) {
		out->numbers[out->count] = number;
		out->weights[out->count++] = 0;
	}
	out->weights[i] += weight;
}

/* Each corner's texture by its barycentric weight. */
static int mesh_textures(const void *data, const Hit *hit, Vec3 p, ShapeTextures *out)
{
	(void)p;
	const MeshDesc *d = &((const Mesh *)data)->desc;
	out->count = 0;
	if (!d->textures || d->textures[hit->part][0] < 0)
		return 0;
	add_texture(out, d->textures[hit->part][0], 1 - hit->u - hit->v);
	add_texture(out, d->textures[hit->part][1], hit->u);
	add_texture(out, d->textures[hit->part][2], hit->v);
	return out->count;
}

const ShapeClass mesh_class = {
	.name = "mesh",
	.flat = true,
	.bounds = mesh_bounds,
	.intersect = mesh_intersect,
	.inside = mesh_inside,
	.normal = mesh_normal,
	.uv = mesh_uv,
	.nearest = mesh_nearest,
	.shading_normal = mesh_shading_normal,
	.bent = mesh_bent,
	.textures = mesh_textures,
};
