/*
 * The photons under relaxation: a working copy along a space-filling curve, so that neighbours lie
 * near in memory, the trees over it and the lists of neighbours that repel. Inside the room only.
 */
#ifndef PHOTON_RELAX_SET_H
#define PHOTON_RELAX_SET_H

#include "photon/relax.h"

typedef struct RelaxPoint {
	float position[3];
	float range2;      /* square of the search range in parameter space, SJ13 eq. 1 */
	float emitter[3];
	uint32_t photon;   /* number in the map */
	float normal[3];
	float flux[3];     /* 1: the mean of all photons */
	uint16_t sheet; /* hash of light, object, way and slice of the spectrum: photons of one
			   sheet of the caustic have the same */
	uint16_t object;
	bool on_plane; /* emitter: two coordinates; else a direction */
} RelaxPoint;

/*
 * How a photon may move: freely along u, by v_length of the force along v; both unit and tangent
 * to the surface. gradient: of its sheet's density, relative (relax_gradient.h).
 */
typedef struct RelaxBasis {
	float u[3], v[3], v_length;
	float gradient[3];
} RelaxBasis;

/*
 * The points near each one, some of which push it: rows of `most` indices, the first counts[i] of
 * them used.
 */
typedef struct RelaxLists {
	uint32_t *index;
	uint8_t *counts;
	int most; /* at most RELAX_MOST */
} RelaxLists;

enum { RELAX_MOST = 255 };

typedef struct RelaxSet {
	RelaxPoint *points;
	RelaxBasis *bases;  /* NULL: unconstrained */
	uint32_t count;
	RelaxLists lists;
	const RelaxSurfaces *surfaces;
} RelaxSet;

typedef struct RelaxForest RelaxForest; /* relax_forest.h */

/* What makes two points neighbours. */
typedef enum RelaxSpace {
	RELAX_PARAMETER, /* near in world space, of one sheet, within range where they left */
	RELAX_WORLD,     /* near in world space, on one object */
	RELAX_EMITTER,   /* near where they left the light, of one sheet */
} RelaxSpace;

/* All photons but those on fixed objects, and those whose place is no number. by_hue: sheets of
 * parted light are told apart by hue (relax_slices.h). */
void relax_set_init(RelaxSet *set, const PhotonMap *map, const RelaxSurfaces *surfaces,
		    bool by_hue);
void relax_set_free(RelaxSet *set);
/* The axes of emitter space about a photon: the plane's, or tangent to the unit sphere of
 * directions. */
void relax_emitter_axes(const float emitter[3], bool on_plane, Vec3 axes[2]);
/* Positions and normals back to the photons they belong to. */
void relax_set_store(const RelaxSet *set, PhotonMap *map);

/* Fills in the lists with the up to `most` nearest in the forest on the same side of the object. */
void relax_lists_fill(RelaxSet *set, const RelaxForest *forest, int most);
/* They take the most memory of all, which something else may need in between. */
void relax_lists_drop(RelaxSet *set);

/* Whether somebody wants relaxation to end: then what it has is of no use. */
bool relax_set_is_stopped(const RelaxSet *set);

/* run(set, first, end, data) over all points, in parallel, or over some of them when stopped. */
typedef void RelaxRun(RelaxSet *set, uint32_t first, uint32_t end, void *data);
void relax_set_each(RelaxSet *set, RelaxRun *run, void *data);

#endif
