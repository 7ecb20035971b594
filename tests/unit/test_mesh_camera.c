/* Which face a pixel of a mesh camera looks from, and where to. */
#include "scene/mesh_camera.h"

#include "tests/unit/check.h"

/* A square of two faces at z = 0 in 0 <= x, y <= 1, turned so that they look along z; texture
 * coordinates are x and y. */
static Mesh *square(Arena *arena)
{
	static const float vertices[4][3] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}},
			   normals[4][3] = {{-1, 0, 1}, {1, 0, 1}, {1, 0, 1}, {-1, 0, 1}};
	static const float uvs[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
	static const int faces[2][3] = {{0, 2, 1}, {0, 3, 2}};
	MeshDesc desc = {.vertices = vertices,
			 .vertex_count = 4,
			 .triangles = faces,
			 .triangle_count = 2,
			 .normals = normals,
			 .normal_count = 4,
			 .uvs = uvs,
			 .uv_count = 4};
	const char *error;
	return mesh_create(arena, &desc, &error);
}

static void check_ray(const MeshCamera *camera, int number, Vec2 at, Vec3 origin, Vec3 direction)
{
	Ray ray = {{9, 9, 9}, {9, 9, 9}, 0, 0};
	CHECK(mesh_camera_ray(camera, number, at, (const int[]){2, 2}, &ray));
	CHECK(vec3_distance(ray.origin, origin) < 1e-6);
	CHECK(vec3_distance(ray.direction, vec3_normalize(direction)) < 1e-6);
}

static void test_numbers(const Mesh *mesh)
{
	MeshCameraPart parts[2] = {{.mesh = mesh, .transform = transform_identity()},
	                           {.mesh = mesh, .transform = transform_translate(vec3(0, 0, 5))}};
	MeshCamera camera = {.rays = 1,
			     .distribution = 0,
			     .offset = 0.5,
			     .parts = parts,
			     .part_count = 2,
			     .max_distance = 7};
	Ray ray;
	check_ray(&camera, 0, (Vec2){0.5, 0.5}, vec3(2 / 3.0, 1 / 3.0, 0.5), vec3(0, 0, 1));
	check_ray(&camera, 1, (Vec2){1.5, 0.5}, vec3(1 / 3.0, 2 / 3.0, 5.5), vec3(0, 0, 1));
	CHECK(!mesh_camera_ray(&camera, 0, (Vec2){0.5, 1.5}, (const int[]){2, 2}, &ray));
	CHECK(mesh_camera_ray(&camera, 0, (Vec2){0.5, 0.5}, (const int[]){2, 2}, &ray) &&
	      ray.tmax == 7);
	camera.distribution = 1;
	check_ray(&camera, 0, (Vec2){0.5, 1.5}, vec3(2 / 3.0, 1 / 3.0, 5.5), vec3(0, 0, 1));
	CHECK(!mesh_camera_ray(&camera, 1, (Vec2){0.5, 0.5}, (const int[]){2, 2}, &ray));
	camera.distribution = 2;
	check_ray(&camera, 0, (Vec2){1.5, 1.5}, vec3(1 / 3.0, 2 / 3.0, 5.5), vec3(0, 0, 1));
	camera.reversed = true;
	check_ray(&camera, 0, (Vec2){0.5, 0.5}, vec3(2 / 3.0, 1 / 3.0, 0.5), vec3(0, 0, -1));
}

static void test_uv(Arena *arena, const Mesh *mesh)
{
	MeshCameraPart part = {.mesh = mesh, .transform = transform_identity()};
	CHECK(mesh_camera_index(arena, &part));
	MeshCamera camera = {.rays = 1, .distribution = 3, .parts = &part, .part_count = 1};
	check_ray(&camera, 0, (Vec2){0.5, 0.2}, vec3(0.25, 0.9, 0), vec3(0, 0, 1));
	camera.smooth = true;
	check_ray(&camera, 0, (Vec2){1, 1.5}, vec3(0.5, 0.25, 0), vec3(0, 0, 1));
	check_ray(&camera, 0, (Vec2){2, 2}, vec3(1, 0, 0), vec3(1, 0, 1));
}

int main(void)
{
	Arena *arena = arena_create();
	const Mesh *mesh = square(arena);
	test_numbers(mesh);
	test_uv(arena, mesh);
	arena_destroy(arena);
	return CHECK_RESULT();
}
