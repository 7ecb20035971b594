/*
 * A bounding volume hierarchy over a mesh's triangles, for rays that do not go through the scene's
 * accelerator: CSG, clipping, trace(), inside tests. Built at the first visit, once, by whichever
 * thread comes first.
 */
#ifndef GEOM_MESH_TREE_H
#define GEOM_MESH_TREE_H

#include "geom/mesh.h"

/* For so many triangles, not built yet; in the arena. */
MeshTree *mesh_tree_create(Arena *arena, int triangles);

/* Calls visit for every triangle whose leaf's box the ray meets within (tmin, tmax), near leaves
 * first; visit may lower ray->tmax. */
typedef void MeshVisit(void *data, int triangle, Ray *ray);
void mesh_tree_visit(const Mesh *mesh, Ray *ray, MeshVisit *visit, void *data);

#endif
