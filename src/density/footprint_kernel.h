/*
 * A photon's kernel on the surface: Epanechnikov's over an ellipse, cut at the borders of the
 * photon's sheet and mirrored there.
 */
#ifndef DENSITY_FOOTPRINT_KERNEL_H
#define DENSITY_FOOTPRINT_KERNEL_H

#include <stdint.h>

#include "base/color.h"
#include "base/vec.h"
#include "density/footprint_border.h"

/* The kernel's variance along an axis over that axis' square. */
static const double footprint_variance = 1.0 / 6;

/* The ellipse's plane: two unit vectors of the photon's surface. */
typedef struct FootprintPlane { Vec3 u, v, normal; } FootprintPlane;

/* What the kernel should be, in the plane's coordinates relative to the photon. */
typedef struct FootprintShape {
	double center[2];
	Symmetric covariance;
	/* Borders: lines through a point, and the side that is cut off. */
	int borders;
	double point[MOST_BORDERS][2], along[MOST_BORDERS][2], out[MOST_BORDERS][2];
} FootprintShape;

/* A half plane that is cut off, in a footprint's coordinates: a, b unit; the light is where the
 * product is under distance. */
typedef struct FootprintCut { float a, b, distance; } FootprintCut;

/* Distances from `at` along the axes, over their lengths, are a . x and b . x; a is the shorter
 * one. */
typedef struct Footprint {
	float at[3], a[3], b[3];
	float least, most; /* lengths of the axes */
	float share; /* of the kernel that the cuts leave, mirror images included; 1: no cuts */
	int32_t cuts;
	FootprintCut cut[MOST_BORDERS];
	uint32_t photon;
	Rgb flux;          /* that it spreads */
} Footprint;

/* least_variance keeps axes from vanishing. */
Footprint footprint_make(const FootprintShape *shape, Vec3 photon, const FootprintPlane *plane,
                         double least_variance);
/* All that the kernel covers, as far along the normal as photons are accepted (gather.h). */
Box3 footprint_box(const Footprint *footprint, Vec3 normal);

/* At x relative to `at`, with pixel2 added to the axes' squares: the kernel's value per area, and
 * the longer axis as it is then; 0: not covered. */
double footprint_value(const Footprint *footprint, const float x[3], double pixel2, double *radius);

#endif
