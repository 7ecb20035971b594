/* What contains an isosurface or a parametric surface: a box or a sphere. */
#ifndef GEOM_CONTAINER_H
#define GEOM_CONTAINER_H

#include "geom/shape.h"

typedef struct Container {
	bool sphere;
	Box3 box;      /* when not a sphere */
	Vec3 center;   /* when a sphere */
	double radius;
} Container;

/* The box from <-1,-1,-1> to <1,1,1>. */
Container container_default(void);
Box3 container_bounds(const Container *container);
/* The part of the line that lies inside, whatever the ray's own ends; faces as box_cross, 0 for
 * a sphere. */
bool container_cross(const Container *container, const Ray *ray, double t[2], int faces[2]);
bool container_inside(const Container *container, Vec3 p);
/* Outward normal at a point of the surface; face from container_cross. */
Vec3 container_normal(const Container *container, int face, Vec3 p);

#endif
