/*
 * Triangles: single ones in double precision, and meshes with shared vertices in single precision.
 * A mesh knows normals, texture coordinates and, per corner, the number of a texture; all optional.
 * Arrays are the caller's and must outlive the mesh.
 */
#ifndef GEOM_MESH_H
#define GEOM_MESH_H

#include <stdbool.h>

#include "base/arena.h"
#include "geom/shape.h"

typedef struct Triangle {
	Vec3 corner[3];
	Vec3 normal[3]; /* of a smooth_triangle */
	bool smooth;
	Vec2 uv[3];
	bool has_uv;
} Triangle;

extern const ShapeClass triangle_class, smooth_triangle_class; /* data: Triangle */

/* What a mesh or mesh2 block says. Indices are checked by mesh_create. */
typedef struct MeshDesc {
	const float (*vertices)[3]; int vertex_count;
	const int (*triangles)[3]; int triangle_count;
	const float (*normals)[3]; int normal_count;   /* NULL: flat */
	const int (*normal_indices)[3]; /* NULL: as triangles; a row of -1: that triangle is flat */
	const float (*uvs)[2]; int uv_count;           /* NULL: none */
	const int (*uv_indices)[3];                    /* NULL: as triangles */
	const int (*textures)[3]; /* per corner, -1: the object's; NULL: none */
	bool has_inside_vector;
	Vec3 inside_vector;
} MeshDesc;

typedef struct MeshTree MeshTree;

typedef struct Mesh {
	MeshDesc desc;
	/* Each triangle's own, one step to memory instead of two: corners, and unit normals, 0
	 * for a flat one (NULL: all are). */
	const float (*corners)[3][3], (*normals)[3][3];
	Box3 box;
	MeshTree *tree; /* for rays outside the scene's accelerator (CSG, trace()); made at the
			   first need */
} Mesh;

extern const ShapeClass mesh_class; /* data: Mesh. hit.part is the triangle, u and v the weights of
				       corners 1 and 2 */

/* Degenerate triangles are dropped silently (they cannot be hit). NULL and *error set when an index
 * is out of range. */
Mesh *mesh_create(Arena *arena, const MeshDesc *desc, const char **error);

/* The crossing of a ray with one triangle of the mesh, in double precision; false when it misses.
 */
bool mesh_hit_triangle(const Mesh *mesh, int triangle, const Ray *ray, Hit *hit);

#endif
