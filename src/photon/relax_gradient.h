/*
 * How density changes around a photon, from its sheet's map. Inside the room, but for its tests.
 *
 * Repulsion cannot tell noise from a gradient: in a density of relative gradient g the mean of SJ13
 * eq. 8 over a disc of radius r is -g r^2 / 12, from dense to thin. So each iteration blurs the
 * caustic by a variance of r^2 / 6 a side, as much as an estimate by Kf photons has, and n
 * iterations as much as one by n Kf: on gentle sheets, where no constraint holds, that is worse
 * than the noise. But where photons fall is a smooth function of where they left the light, which
 * their coordinates tell without noise, and density is the inverse of its Jacobian. With the mean
 * push known and taken off, what is left is noise.
 */
#ifndef PHOTON_RELAX_GRADIENT_H
#define PHOTON_RELAX_GRADIENT_H

#include "photon/relax_set.h"
#include "photon/tree.h"

/* Places spread evenly over the unit disc, each with its opposite: odd terms cancel. */
enum { RELAX_PATTERN = 128 };
typedef struct RelaxPattern { float a[RELAX_PATTERN], b[RELAX_PATTERN]; } RelaxPattern;

RelaxPattern relax_pattern(void);

/* A photon and those of its sheet about it. */
typedef struct RelaxPiece {
	const RelaxSet *set;
	uint32_t point;
	const Neighbor *near;
	int found;
	Vec3 axes[2];   /* unit, tangent, orthogonal */
	double radius;  /* of the farthest found */
	double pushing; /* how many of the found, on the average, push: a share */
} RelaxPiece;

/*
 * The relative gradient of density (grad rho / rho, per scene unit, tangent to the surface) of the
 * photon's sheet. Near a fold, where a gradient says little, the one that would push as the fold
 * does. Zero where the map is not known or not smooth: few neighbours, creases.
 */
Vec3 relax_gradient(const RelaxPiece *piece, const RelaxPattern *pattern);

/* What takes off the mean push on a photon by those within radius: to be added to eq. 8's force. */
void relax_gradient_resist(const float gradient[3], float radius, float force[3]);

#endif
