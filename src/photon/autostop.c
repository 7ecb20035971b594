#include "photon/autostop.h"

#include <math.h>

#include "scene/accel.h"

enum { CIRCLES = 100, PROBES = 180 };

static bool is_target(void *data, const Ray *ray, const Hit *hit)
{
	const PhotonAim *aim = data;
	const Surface *surface = hit->shape->owner;
	(void)ray;
	return surface->id == aim->target;
}

static bool circle_meets(const Scene *scene, const PhotonAim *aim, double radius)
{
	for (int i = 0; i < PROBES; i++) {
		double turn = 2 * M_PI * i / PROBES;
		Vec2 at = {radius * cos(turn), radius * sin(turn)};
		Emission emission = emission_from_disc(&aim->region, at);
		Ray ray = {emission.origin, emission.direction, 0, INFINITY};
		Hit hit;
		if (accel_nearest(scene->accel, &ray, is_target, (void *)aim, &hit))
			return true;
	}
	return false;
}

double photon_autostop(const Scene *scene, const PhotonAim *aim)
{
	double least = scene->settings.photons.autostop;
	bool met = false;
	if (least >= 1 || aim->region.own || aim->region.rise >= 2)
		return 1;
	for (int i = 0; i < CIRCLES; i++) {
		double radius = (i + 0.5) / CIRCLES;
		if (circle_meets(scene, aim, radius))
			met = true;
		else if (met && radius > least)
			return radius;
	}
	return 1;
}
