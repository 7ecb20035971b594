/*
 * Delaunay's triangulation of points of a plane: of all triangulations the one whose triangles'
 * circumcircles hold no other point.
 */
#ifndef DENSITY_FOOTPRINT_DELAUNAY_H
#define DENSITY_FOOTPRINT_DELAUNAY_H

#include <stdint.h>

/* Corners anticlockwise. The block is the caller's to free. */
typedef struct Triangulation {
	uint32_t (*corners)[3];
	uint32_t count;
} Triangulation;

/* Quick for points along a curve that fills the plane. Points are taken on a grid of 2^22 steps a
 * side, on which the result is exact; of points at one place the first counts. Thin triangles along
 * the hull may be missing. Fewer than three points, or all in a line: no triangles. */
Triangulation footprint_triangulate(const double (*points)[2], uint32_t count);

#endif
