/*
 * The accelerator: Embree behind a C face. Triangle meshes go in as triangles, every other shape as
 * a user geometry that intersects in double precision; unbounded shapes stand beside. The only file
 * of the project that includes Embree.
 */
#ifndef SCENE_ACCEL_H
#define SCENE_ACCEL_H

#include "geom/shape.h"

typedef struct Accel Accel;

/* Over finished shapes, which must outlive it. */
Accel *accel_create(const Shape *const *shapes, int count);
void accel_destroy(Accel *accel);

/* Decides whether a crossing counts; data is the caller's. NULL accepts everything. */
typedef bool AccelFilter(void *data, const Ray *ray, const Hit *hit);

/* The nearest accepted crossing. Thread-safe. */
bool accel_nearest(const Accel *accel, const Ray *ray, AccelFilter *accept, void *data, Hit *out);
/* Calls visit for crossings in no particular order until it returns true; true when it did: for
 * shadow rays. */
bool accel_any(const Accel *accel, const Ray *ray, AccelFilter *visit, void *data);
/* The bounded and unbounded shapes that contain p: up to max of their primitives, returns how many.
 */
int accel_containing(const Accel *accel, Vec3 p, const Shape **out, int max);

#endif
