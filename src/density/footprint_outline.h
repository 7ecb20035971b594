/*
 * The outline of a region that points fill evenly, from those along its border: the fewest straight
 * stretches that the points' chance allows. Chance makes the way along the outermost points jagged
 * by half a point's distance; a stretch along many knows the border to a small part of it, and
 * corners are where two stretches meet.
 */
#ifndef DENSITY_FOOTPRINT_OUTLINE_H
#define DENSITY_FOOTPRINT_OUTLINE_H

/* A point along a closed way, the inside to its left. */
typedef struct OutlineNode {
	double at[2];
	double space;   /* area of a point around */
	double missing; /* area between the way and the outline that belongs to this node */
} OutlineNode;

/* out[i]: where the outline passes node i; anticlockwise as the nodes are. */
void footprint_outline(const OutlineNode *nodes, int count, double (*out)[2]);

#endif
