/*
 * A border shows as a void: a segment of the disc around the photon that neighbours should lie in,
 * and none does. The direction with the largest such segment is taken, then the next one among
 * those that point elsewhere, counting what the first has left.
 */
#include "density/footprint_border.h"

#include <math.h>
#include <stdbool.h>
#include <stddef.h>

enum { DIRECTIONS = 32, POINTS = 64 };

/* So many neighbours must be missing. Roulette at surfaces that split light makes holes by chance:
 * with three, kernels were cut in the midst of sheets. */
static const double least_missing = 5;

/* Points that fill the disc evenly: the sunflower's (Vogel 1979). */
static void sunflower(int i, double radius, double at[2])
{
	double r = radius * sqrt((i + 0.5) / POINTS), angle = i * (M_PI * (3 - sqrt(5)));
	at[0] = r * cos(angle);
	at[1] = r * sin(angle);
}

static double along(const double a[2], const double b[2]) { return a[0] * b[0] + a[1] * b[1]; }

/* How far neighbours reach in a direction, the photon itself included. */
static double reach_of(const BorderSearch *search, const double toward[2])
{
	double reach = 0, window2 = search->window * search->window;
	for (int i = 0; i < search->count; i++) {
		const double *d = search->samples[i].d;
		if (along(d, d) <= window2)
			reach = fmax(reach, along(d, toward));
	}
	return reach;
}

/* Area of the disc's segment beyond the border. */
static double segment_area(double radius, double distance)
{
	double t = fmax(-1, fmin(1, distance / radius));
	return radius * radius * (acos(t) - t * sqrt(1 - t * t));
}

/* The same without what another border cuts off. */
static double area_between(double radius, const Border *border, const Border *other)
{
	int between = 0;
	for (int i = 0; i < POINTS; i++) {
		double at[2];
		sunflower(i, radius, at);
		between += along(at, border->toward) > border->distance &&
		           along(at, other->toward) < other->distance;
	}
	return M_PI * radius * radius * between / POINTS;
}

/* The sheet goes on beyond its outermost photon by what lies between two at that depth. */
static double gap_beyond(const BorderSearch *search, double reach)
{
	double w = search->window, chord = 2 * sqrt(fmax(w * w - reach * reach, 0));
	return chord > 0 ? search->share / chord : 0;
}

/* other: NULL for the first one. */
static bool find_border(const BorderSearch *search, const Border *other, Border *found)
{
	double most = least_missing * search->share;
	bool any = false;
	for (int k = 0; k < DIRECTIONS; k++) {
		double angle = 2 * M_PI * k / DIRECTIONS;
		Border border = {{cos(angle), sin(angle)}, 0};
		border.distance = reach_of(search, border.toward);
		double missing = segment_area(search->window, border.distance);
		if (missing > most && other)
			missing = area_between(search->window, &border, other);
		if (missing <= most)
			continue;
		most = missing;
		*found = border;
		any = true;
	}
	if (any)
		found->distance += gap_beyond(search, found->distance);
	return any;
}

int footprint_borders(const BorderSearch *search, Border out[MOST_BORDERS])
{
	if (!find_border(search, NULL, &out[0]))
		return 0;
	return find_border(search, &out[0], &out[1]) ? 2 : 1;
}
