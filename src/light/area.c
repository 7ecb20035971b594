/* POV-Ray 3.7's manual, section 3.4.4.1.5: the outer points of the grid lie on the area's edge. */
#include "light/area.h"

#include <math.h>

AreaFrame area_frame(const Light *light, Vec3 p)
{
	if (!light->orient)
		return (AreaFrame){light->axis1, light->axis2};
	Vec3 toward = vec3_normalize(vec3_sub(p, light->position));
	Vec3 side = vec3_cross(light->axis2, toward);
	if (vec3_length2(side) == 0)
		side = vec3_cross(light->axis1, toward);
	side = vec3_normalize(side);
	Vec3 up = vec3_cross(toward, side);
	return (AreaFrame){vec3_scale(side, vec3_length(light->axis1)),
			   vec3_scale(up, vec3_length(light->axis2))};
}

static double centred(double index, int size)
{
	return size > 1 ? index / (size - 1) - 0.5 : 0;
}

Vec3 area_point(const Light *light, const AreaFrame *frame, double column, double row)
{
	double u = centred(column, light->size1), v = centred(row, light->size2);
	if (light->circular) {
		/* Squares around the centre become circles of their inner radius. */
		double length = hypot(u, v),
		       scale = length > 0 ? fmax(fabs(u), fabs(v)) / length : 0;
		u *= scale;
		v *= scale;
	}
	return vec3_add(light->position,
			vec3_add(vec3_scale(frame->axis1, u), vec3_scale(frame->axis2, v)));
}
