/*
 * Blobs: the surface where the sum of the components' fields is the threshold. A component's field
 * at distance r from its centre or axis is strength (1 - (r / radius)^2)^2, zero beyond the radius;
 * cylinders end in half spheres.
 */
#ifndef GEOM_BLOB_H
#define GEOM_BLOB_H

#include "base/arena.h"
#include "geom/shape.h"

typedef struct BlobComponent {
	bool cylinder;
	Vec3 center, end;           /* end: of a cylinder */
	double radius, strength;
	const Transform
		*transform; /* from the component's own space to the blob's; NULL: the same */
	int texture; /* number of its own texture for the class' textures(); -1: none */
} BlobComponent;

typedef struct BlobDesc {
	const BlobComponent *components;
	int count;
	double threshold; /* 1 when a scene says nothing */
} BlobDesc;

/* NULL with *error set when there is no component or a cylinder has no length. */
const void *blob_create(Arena *arena, const BlobDesc *desc, const char **error);
extern const ShapeClass blob_class;

#endif
