/*
 * Warps: what bends the space of a pattern. A pattern holds them as a list of immutable nodes, the
 * one written last in the scene first, because it is the first to be applied to a point (a
 * transformation brings the point back to the space of what was written before it). Lists can share
 * their tails, so a copied pattern goes on where the original ended.
 *
 * lang builds a list by calling the warp_add functions in the order of the scene's text.
 */
#ifndef SURFACE_WARP_H
#define SURFACE_WARP_H

#include "base/arena.h"
#include "base/transform.h"
#include "surface/noise.h"
#include "surface/pattern.h"

typedef enum WarpKind {
	WARP_TRANSFORM,
	WARP_CLASSIC, /* the words turbulence, octaves, lambda, omega in a pattern itself; at most
			 one, see warp_add_classic */
	WARP_TURBULENCE, /* warp { turbulence } */
	WARP_REPEAT,
	WARP_BLACK_HOLE,
	WARP_PLANAR,
	WARP_CYLINDRICAL,
	WARP_SPHERICAL,
	WARP_TOROIDAL,
	WARP_CUBIC,
} WarpKind;

typedef struct WarpRepeat {
	int axis;     /* 0 x, 1 y, 2 z */
	double width; /* not 0 */
	Vec3 flip;    /* not 0: that axis is mirrored in every other copy */
	Vec3 offset;  /* added for each copy */
} WarpRepeat;

typedef struct WarpBlackHole {
	Vec3 center;
	double radius;
	double strength; /* 1 */
	double falloff;  /* 2 */
	bool inverse;
	int type; /* 0: spherical, the only one */
	bool repeats;
	Vec3 repeat; /* 0 on an axis: none there */
	bool uncertain;
	Vec3 uncertainty; /* the word turbulence */
} WarpBlackHole;

/* planar, cylindrical, spherical, toroidal */
typedef struct WarpMapping {
	Vec3 orientation;    /* the mapped image's normal; z */
	double distance;     /* planar: the constant off-plane coordinate; others: dist_exp; 0 */
	double major_radius; /* toroidal; 1 */
} WarpMapping;

struct Warp {
	WarpKind kind;
	const Warp *next;
	union {
		Transform transform;
		Turbulence turbulence; /* CLASSIC and TURBULENCE */
		WarpRepeat repeat;
		WarpBlackHole black_hole;
		WarpMapping mapping;
	} u;
};

WarpMapping warp_mapping_default(void);
WarpBlackHole warp_black_hole_default(void);

/* Put a warp behind what was written before. *list is a Pattern's warps. Transforms that follow
 * each other become one. */
void warp_add_transform(Arena *arena, const Warp **list, const Transform *transform);
void warp_add(Arena *arena, const Warp **list, const Warp *warp);
/* The turbulence that the words turbulence, octaves, lambda and omega of a pattern change: fetch
 * with warp_classic (defaults when there is none), change, put back with warp_set_classic. */
Turbulence warp_classic(const Warp *list);
/* The list's classic turbulence, or NULL. */
const Turbulence *warp_find_classic(const Warp *list);
void warp_set_classic(Arena *arena, const Warp **list, const Turbulence *turbulence);

/* Applies the list to p. The classic turbulence is left out when skip_classic (patterns that use it
 * in their own way). */
Vec3 warp_apply(const Warp *list, Vec3 p, int generator, bool skip_classic);

#endif
