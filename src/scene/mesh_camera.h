/*
 * The mesh camera: rays that start in the middle of a mesh's faces and go along their normals. How
 * pixels find their faces is the distribution (POV-Ray 3.7's manual, 3.4.2.2.3):
 *
 *     0  pixel i looks from face i; ray n of the pixel from mesh n
 *     1  the same with all meshes as one; ray n of pixel i looks from face width * height * n + i
 *     2  the image is a row of cameras, a mesh each
 *     3  (u, v) is the place in the image; the mesh's face that covers it in texture space, at that
 * place of the face
 *
 * Immutable once made, in the scene arena.
 */
#ifndef SCENE_MESH_CAMERA_H
#define SCENE_MESH_CAMERA_H

#include "geom/box_tree.h"
#include "geom/mesh.h"

typedef struct MeshCameraPart {
	const Mesh *mesh;
	Transform transform;   /* the mesh's own space to the world */
	const BoxTree *by_uv;  /* distribution 3: faces by their boxes in texture space */
} MeshCameraPart;

typedef struct MeshCamera {
	int rays;              /* per pixel */
	int distribution;      /* 0..3 */
	double max_distance;   /* 0: no limit */
	double offset;         /* along the normal, from the face to the ray's start */
	bool reversed;         /* look against the normals */
	bool smooth;           /* distribution 3: along interpolated normals */
	const MeshCameraPart *parts; int part_count;
} MeshCamera;

/* Fills in what looks faces up by texture coordinates; false when a mesh has none. */
bool mesh_camera_index(Arena *arena, MeshCameraPart *part);
/* Ray `number` of the pixel at (x, y), in pixels from the upper left corner; false when no face
 * belongs to it. */
bool mesh_camera_ray(const MeshCamera *camera, int number, Vec2 at, const int size[2], Ray *out);

#endif
