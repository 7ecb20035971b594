/*
 * Affine transformations with their inverse. A point p is a column: p' = m p. POV-Ray's space is
 * left-handed; rotations turn about x, then y, then z, in degrees, clockwise when looking along the
 * axis' positive direction towards the origin is counted as POV-Ray counts it.
 */
#ifndef BASE_TRANSFORM_H
#define BASE_TRANSFORM_H

#include "base/vec.h"

typedef struct Transform {
	double m[3][4];   /* rows; the fourth column is the translation */
	double inv[3][4]; /* the inverse of m */
} Transform;

Transform transform_identity(void);
Transform transform_translate(Vec3 by);
/* A factor of 0 is taken as 1, as POV-Ray does (it warns; so should the caller). */
Transform transform_scale(Vec3 by);
Transform transform_rotate(Vec3 degrees);
Transform transform_rotate_axis(Vec3 axis, double degrees);
/* POV-Ray's matrix <m00,m01,m02, m10,... m30,m31,m32>: rows are the images of x, y, z and the
 * origin. Returns false, and the identity, when it cannot be inverted. */
bool transform_matrix(const double rows[12], Transform *out);
/* First a, then b. */
Transform transform_compose(const Transform *a, const Transform *b);
Transform transform_inverse(const Transform *t);
bool transform_is_identity(const Transform *t);
/* True when lengths change by one common factor (rotation, translation, uniform scale); *scale gets
 * the factor. */
bool transform_is_similarity(const Transform *t, double *scale);
/* True when only lengths along the axes and the place change: no turning, no mirroring. */
bool transform_is_upright(const Transform *t);
/* The box of the transformed box; an infinite box stays infinite. */
Box3 transform_box(const Transform *t, Box3 box);

static inline Vec3 transform_apply_point(const double m[3][4], Vec3 p)
{
	return (Vec3){m[0][0] * p.x + m[0][1] * p.y + m[0][2] * p.z + m[0][3],
	              m[1][0] * p.x + m[1][1] * p.y + m[1][2] * p.z + m[1][3],
	              m[2][0] * p.x + m[2][1] * p.y + m[2][2] * p.z + m[2][3]};
}
static inline Vec3 transform_apply_vector(const double m[3][4], Vec3 d)
{
	return (Vec3){m[0][0] * d.x + m[0][1] * d.y + m[0][2] * d.z,
		      m[1][0] * d.x + m[1][1] * d.y + m[1][2] * d.z,
		      m[2][0] * d.x + m[2][1] * d.y + m[2][2] * d.z};
}
static inline Vec3 transform_apply_transposed(const double m[3][4], Vec3 n)
{
	return (Vec3){m[0][0] * n.x + m[1][0] * n.y + m[2][0] * n.z,
		      m[0][1] * n.x + m[1][1] * n.y + m[2][1] * n.z,
		      m[0][2] * n.x + m[1][2] * n.y + m[2][2] * n.z};
}

/* Object to world, and back. Normals come out unnormalised. */
static inline Vec3 transform_point(const Transform *t, Vec3 p)
{
	return transform_apply_point(t->m, p);
}
static inline Vec3 transform_vector(const Transform *t, Vec3 d)
{
	return transform_apply_vector(t->m, d);
}
static inline Vec3 transform_normal(const Transform *t, Vec3 n)
{
	return transform_apply_transposed(t->inv, n);
}
static inline Vec3 transform_point_inverse(const Transform *t, Vec3 p)
{
	return transform_apply_point(t->inv, p);
}
static inline Vec3 transform_vector_inverse(const Transform *t, Vec3 d)
{
	return transform_apply_vector(t->inv, d);
}
static inline Vec3 transform_normal_inverse(const Transform *t, Vec3 n)
{
	return transform_apply_transposed(t->m, n);
}

#endif
