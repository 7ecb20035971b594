/* Where the points of an area light's grid lie, as seen from a lit point. Scene units, world space.
 */
#ifndef LIGHT_AREA_H
#define LIGHT_AREA_H

#include "light/light.h"

/* The light's edges turned towards p (`orient`), or as they are. */
typedef struct AreaFrame {
	Vec3 axis1, axis2;
} AreaFrame;

/* As p sees them. */
AreaFrame area_frame(const Light *light, Vec3 p);

/* The point at grid coordinates 0 <= column <= size1 - 1, 0 <= row <= size2 - 1; fractions come
 * from jitter. */
Vec3 area_point(const Light *light, const AreaFrame *frame, double column, double row);

#endif
