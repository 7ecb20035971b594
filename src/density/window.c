#include "density/window.h"

#include <math.h>

/* A square across the view, seen along it. */
static void find_sides(const GatherPoint *point, double width, Vec3 sides[2])
{
	static const double least_cosine = 0.05;
	double cosine = vec3_dot(point->view, point->normal);
	Vec3 along = vec3_scale(point->view, vec3_dot(point->across, point->view));
	Vec3 across = vec3_sub(point->across, along);
	double length = vec3_length(across);
	if (!(length > 0) || fabs(cosine) < least_cosine) {
		vec3_frame(point->normal, &sides[0], &sides[1]);
		cosine = 1;
	} else {
		sides[0] = vec3_scale(across, 1 / length);
		sides[1] = vec3_cross(point->view, sides[0]);
	}
	for (int i = 0; i < 2; i++) {
		double off = vec3_dot(sides[i], point->normal) / cosine;
		sides[i] = vec3_scale(vec3_mad(sides[i], -off, point->view), width);
	}
}

static void to_doubles(Vec3 v, double scale, double out[3])
{
	out[0] = scale * v.x;
	out[1] = scale * v.y;
	out[2] = scale * v.z;
}

Window window_around(const GatherPoint *point, double least_width)
{
	Vec3 s[2];
	Window w;
	find_sides(point, fmax(point->footprint, least_width), s);
	Vec3 normal = vec3_cross(s[0], s[1]);
	double area2 = vec3_dot(normal, normal);
	to_doubles(point->position, 1, w.at);
	to_doubles(vec3_cross(s[1], normal), 1 / area2, w.x);
	to_doubles(vec3_cross(normal, s[0]), 1 / area2, w.y);
	w.area = sqrt(area2);
	w.reach = vec3(0.5 * (fabs(s[0].x) + fabs(s[1].x)), 0.5 * (fabs(s[0].y) + fabs(s[1].y)),
		       0.5 * (fabs(s[0].z) + fabs(s[1].z)));
	return w;
}
