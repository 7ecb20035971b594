#include "scene/mesh_camera.h"

static Vec3 vertex(const Mesh *mesh, int index)
{
	return vec3_of_floats(mesh->desc.vertices[index]);
}

static Vec2 corner_uv(const Mesh *mesh, int face, int corner)
{
	const int (*indices)[3] = mesh->desc.uv_indices ? mesh->desc.uv_indices
							: mesh->desc.triangles;
	const float *uv = mesh->desc.uvs[indices[face][corner]];
	return (Vec2){uv[0], uv[1]};
}

/* ---- faces by texture coordinates ---- */

bool mesh_camera_index(Arena *arena, MeshCameraPart *part)
{
	const Mesh *mesh = part->mesh;
	if (!mesh->desc.uvs)
		return false;
	Box3 *boxes = ARENA_ARRAY(arena, Box3, mesh->desc.triangle_count);
	for (int i = 0; i < mesh->desc.triangle_count; i++) {
		boxes[i] = box3_empty();
		for (int k = 0; k < 3; k++) {
			Vec2 uv = corner_uv(mesh, i, k);
			boxes[i] = box3_add(boxes[i], vec3(uv.u, uv.v, 0));
		}
	}
	part->by_uv = box_tree_create(arena, boxes, mesh->desc.triangle_count);
	return true;
}

/* The first face of the mesh that covers a place in texture space. */
typedef struct FaceSearch {
	const Mesh *mesh;
	Vec2 at;
	int face;     /* -1: none yet */
	double u, v;  /* weights of its corners 1 and 2 */
} FaceSearch;

static bool visit_face(void *data, int face)
{
	FaceSearch *search = data;
	Vec2 a = corner_uv(search->mesh, face, 0), b = corner_uv(search->mesh, face, 1),
	     c = corner_uv(search->mesh, face, 2);
	double bu = b.u - a.u, bv = b.v - a.v, cu = c.u - a.u, cv = c.v - a.v,
	       pu = search->at.u - a.u, pv = search->at.v - a.v;
	double area = bu * cv - bv * cu;
	if (area == 0 || (search->face >= 0 && face > search->face))
		return false;
	double u = (pu * cv - pv * cu) / area, v = (bu * pv - bv * pu) / area;
	if (u >= 0 && v >= 0 && u + v <= 1) {
		search->face = face;
		search->u = u;
		search->v = v;
	}
	return false;
}

/* ---- a ray from a face ---- */

typedef struct FacePlace {
	const MeshCameraPart *part;
	int face;
	double u, v;
} FacePlace;

/* Its length does not count; as POV-Ray has it, it points against the side from which the corners
 * turn clockwise. */
static Vec3 face_normal(const Mesh *mesh, int face)
{
	const int *corners = mesh->desc.triangles[face];
	Vec3 a = vertex(mesh, corners[0]), b = vertex(mesh, corners[1]),
	     c = vertex(mesh, corners[2]);
	return vec3_cross(vec3_sub(c, a), vec3_sub(b, a));
}

static Vec3 smooth_normal(const Mesh *mesh, const FacePlace *place)
{
	Hit hit = {.part = place->face, .u = place->u, .v = place->v};
	return mesh_class.shading_normal(mesh, &hit, vec3_all(0));
}

static void ray_from(const MeshCamera *camera, const FacePlace *place, Ray *out)
{
	const Mesh *mesh = place->part->mesh;
	const int *corners = mesh->desc.triangles[place->face];
	bool smooth = camera->smooth && camera->distribution == 3 && mesh->desc.normals;
	Vec3 origin = vec3_scale(vertex(mesh, corners[0]), 1 - place->u - place->v);
	origin = vec3_mad(origin, place->u, vertex(mesh, corners[1]));
	origin = vec3_mad(origin, place->v, vertex(mesh, corners[2]));
	Vec3 normal = smooth ? smooth_normal(mesh, place) : face_normal(mesh, place->face);
	normal = vec3_normalize(transform_normal(&place->part->transform, normal));
	out->direction = camera->reversed ? vec3_neg(normal) : normal;
	out->origin = vec3_mad(transform_point(&place->part->transform, origin), camera->offset,
			       normal);
	out->tmin = 0;
	out->tmax = camera->max_distance > 0 ? camera->max_distance : INFINITY;
}

static bool find_by_uv(const MeshCamera *camera, Vec2 uv, FacePlace *place)
{
	for (int i = 0; i < camera->part_count; i++) {
		FaceSearch search = {camera->parts[i].mesh, uv, -1, 0, 0};
		box_tree_walk_point(camera->parts[i].by_uv, vec3(uv.u, uv.v, 0), visit_face,
				    &search);
		if (search.face >= 0) {
			*place = (FacePlace){&camera->parts[i], search.face, search.u, search.v};
			return true;
		}
	}
	return false;
}

/* The middle of a face by its number; false when the mesh has fewer. */
static bool find_by_number(const MeshCamera *camera, int part, long face, FacePlace *place)
{
	if (part >= camera->part_count || face >= camera->parts[part].mesh->desc.triangle_count)
		return false;
	*place = (FacePlace){&camera->parts[part], (int)face, 1 / 3.0, 1 / 3.0};
	return true;
}

static bool find_in_all(const MeshCamera *camera, long face, FacePlace *place)
{
	int part = 0;
	while (part < camera->part_count && face >= camera->parts[part].mesh->desc.triangle_count)
		face -= camera->parts[part++].mesh->desc.triangle_count;
	return find_by_number(camera, part, face, place);
}

static bool find_place(const MeshCamera *camera, int number, Vec2 at, const int size[2],
		       FacePlace *place)
{
	long x = (long)at.u, y = (long)at.v;
	long width = camera->distribution == 2 ? size[0] / camera->part_count : size[0];
	switch (camera->distribution) {
	case 0:
		return find_by_number(camera, number, x + y * width, place);
	case 1:
		return find_in_all(camera, (long)size[0] * size[1] * number + x + y * width, place);
	case 2:
		return width > 0 &&
		       find_by_number(camera, (int)(x / width), x % width + y * width, place);
	default:
		return find_by_uv(camera, (Vec2){at.u / size[0], 1 - at.v / size[1]}, place);
	}
}

bool mesh_camera_ray(const MeshCamera *camera, int number, Vec2 at, const int size[2], Ray *out)
{
	FacePlace place;
	if (!find_place(camera, number, at, size, &place))
		return false;
	ray_from(camera, &place, out);
	return true;
}
