/*
 * What the estimators share: which photons belong to the gather point's surface, and sums over
 * them.
 *
 * A photon is refused when its surface's normal deviates from the gather point's by more than 60
 * degrees, or when it lies farther along the normal than a quarter of the radius: so the two sides
 * of a thin wall, a shelf over a table and the sides of a box's edge stay apart, while a surface
 * that curves with twice the radius keeps its photons.
 */
#ifndef DENSITY_GATHER_H
#define DENSITY_GATHER_H

#include "density/method.h"
#include "density/window.h"

/* How far along the normal photons may lie. */
double gather_thickness(double radius);
/* Whether the photon lies on the point's surface: about in its plane, on the side that is lit. */
bool gather_accepts(const GatherPoint *point, const Photon *photon, double radius);

/* Sums in double precision, so that the photons' order hardly shows. */
typedef struct GatherSum {
	const GatherTask *task;
	double radiance[3], parameter[3], edges, constraint;
	int photons;
} GatherSum;

/* kernel: per area. Photons of kernel 0 count as found. */
void gather_add(GatherSum *sum, const Photon *photon, double kernel);
/* The same with a flux that is not the photon's own. */
void gather_add_flux(GatherSum *sum, const Photon *photon, Rgb flux, double kernel);
/* The sums, and the means of what is no light; radius: of the photons. */
void gather_finish(const GatherSum *sum, double radius, GatherResult *result);

/* Drops the neighbours that are not accepted from found, keeping the order; returns how many
 * stay. */
int gather_filter(const GatherTask *task, double radius, Neighbor *found, int count);

/*
 * The wanted number of nearest accepted photons within reach, in no order; *radius2: the square of
 * the radius of the disc they stand for, which is the farthest's distance, or the reach when there
 * are fewer. found has GATHER_ROOM(wanted): when some are refused, farther ones are asked for.
 * Returns how many.
 */
enum { GATHER_TRIES = 3 };
#define GATHER_ROOM(wanted) (((wanted) << (GATHER_TRIES - 1)) + 8 * TREE_SLACK)
int gather_nearest(const GatherTask *task, int wanted, double reach, Neighbor *found,
                   double *radius2);

/* A photon's weight at so large a squared distance, per area; negative: it does not belong. */
typedef double GatherKernel(const void *data, const Photon *photon, double distance2);
/* All accepted photons within the radius, by their weights. */
void gather_within(const GatherTask *task, double radius, GatherKernel *kernel, const void *data,
		   GatherResult *result);

/*
 * No kernel is narrower than a pixel, or what lies between the pixels' middles would be missed. The
 * square of the radius from which on discs are used: their paraboloid's variance, r^2 / 6, is then
 * that of what the pixel sees, a twelfth of its area. 0 when the pixel is not known.
 */
double gather_least_radius2(const Window *pixel);
/* The pixel itself as the kernel: each photon counts in one pixel, there once. */
void gather_pixel(const GatherTask *task, const Window *pixel, GatherResult *result);

/* How far to look at most for so many photons: eight times the radius that holds them at the map's
 * median density; INFINITY when that is unknown. */
double gather_reach(const PhotonMap *map, int count);

#endif
