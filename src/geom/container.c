#include "geom/container.h"

#include "geom/box.h"
#include "geom/sphere.h"

Container container_default(void)
{
	return (Container){.box = {{-1, -1, -1}, {1, 1, 1}}};
}

Box3 container_bounds(const Container *container)
{
	Vec3 half = vec3_all(fabs(container->radius));
	if (!container->sphere)
		return container->box;
	return (Box3){vec3_sub(container->center, half), vec3_add(container->center, half)};
}

bool container_cross(const Container *container, const Ray *ray, double t[2], int faces[2])
{
	faces[0] = faces[1] = 0;
	if (container->sphere)
		return sphere_cross(container->center, container->radius, ray, t);
	return box_cross(container->box, ray, t, faces);
}

bool container_inside(const Container *container, Vec3 p)
{
	if (!container->sphere)
		return box3_contains(container->box, p);
	return vec3_length2(vec3_sub(p, container->center)) < container->radius * container->radius;
}

Vec3 container_normal(const Container *container, int face, Vec3 p)
{
	if (container->sphere)
		return vec3_sub(p, container->center);
	double sign = face % 2 ? 1 : -1;
	return face < 2 ? vec3(sign, 0, 0) : face < 4 ? vec3(0, sign, 0) : vec3(0, 0, sign);
}
