/*
 * What the estimators share: which photons belong to the gather point's surface, and sums over them.
 *
 * A photon is refused when its surface's normal deviates from the gather point's by more than 60 degrees, or when it lies
 * outside a disc of a quarter of the radius' thickness along the normal: so the two sides of a thin wall, a shelf
 * over a table and the sides of a box's edge stay apart, while a surface of twice the radius' curvature keeps its photons.
 */
#ifndef DENSITY_GATHER_H
#define DENSITY_GATHER_H

#include "density/method.h"

bool gather_accepts(const GatherPoint *point, const Photon *photon, double radius);

/* Sums in double precision, so that the photons' order hardly shows. */
typedef struct GatherSum {
	const GatherTask *task;
	double radiance[3], parameter[3], edges;
	int photons;
} GatherSum;

/* kernel: per area. Photons of kernel 0 count as found. */
void gather_add(GatherSum *sum, const Photon *photon, double kernel);
void gather_finish(const GatherSum *sum, double radius, GatherResult *result);

/* Drops the neighbours that are not accepted from found, keeping the order; returns how many stay. */
int gather_filter(const GatherTask *task, double radius, Neighbor *found, int count);

/* How far a gather may reach before it asks nobody's photons: from the map's spacing, for `count` photons; 0: unknown. */
double gather_reach(const PhotonMap *map, int count);

#endif
