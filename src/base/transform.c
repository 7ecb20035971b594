#include "base/transform.h"

#include <string.h>

static const double degree = 0.017453292519943295769; /* pi / 180 */

Transform transform_identity(void)
{
	return (Transform){{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}},
			   {{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}};
}

Transform transform_translate(Vec3 by)
{
	return (Transform){{{1, 0, 0, by.x}, {0, 1, 0, by.y}, {0, 0, 1, by.z}},
	                   {{1, 0, 0, -by.x}, {0, 1, 0, -by.y}, {0, 0, 1, -by.z}}};
}

Transform transform_scale(Vec3 by)
{
	double x = by.x != 0 ? by.x : 1, y = by.y != 0 ? by.y : 1, z = by.z != 0 ? by.z : 1;
	return (Transform){{{x, 0, 0, 0}, {0, y, 0, 0}, {0, 0, z, 0}},
	                   {{1 / x, 0, 0, 0}, {0, 1 / y, 0, 0}, {0, 0, 1 / z, 0}}};
}

/* The inverse of a rotation is its transpose. */
static Transform from_rotation(const double r[3][3])
{
	Transform t = transform_identity();
	for (int i = 0; i < 3; i++) {
		for (int j = 0; j < 3; j++) {
			t.m[i][j] = r[i][j];
			t.inv[i][j] = r[j][i];
		}
	}
	return t;
}

Transform transform_rotate_axis(Vec3 axis, double degrees)
{
	Vec3 a = vec3_normalize(axis);
	double c = cos(degrees * degree), s = sin(degrees * degree), k = 1 - c;
	double r[3][3] = {{k * a.x * a.x + c, k * a.x * a.y - s * a.z, k * a.x * a.z + s * a.y},
	                  {k * a.x * a.y + s * a.z, k * a.y * a.y + c, k * a.y * a.z - s * a.x},
	                  {k * a.x * a.z - s * a.y, k * a.y * a.z + s * a.x, k * a.z * a.z + c}};
	return from_rotation(r);
}

Transform transform_rotate(Vec3 degrees)
{
	Transform x = transform_rotate_axis(vec3(1, 0, 0), degrees.x);
	Transform y = transform_rotate_axis(vec3(0, 1, 0), degrees.y);
	Transform z = transform_rotate_axis(vec3(0, 0, 1), degrees.z);
	Transform xy = transform_compose(&x, &y);
	return transform_compose(&xy, &z);
}

/* c = b a as matrices: a first. */
static void multiply(const double b[3][4], const double a[3][4], double c[3][4])
{
	for (int i = 0; i < 3; i++) {
		for (int j = 0; j < 4; j++)
			c[i][j] = b[i][0] * a[0][j] + b[i][1] * a[1][j] + b[i][2] * a[2][j];
		c[i][3] += b[i][3];
	}
}

Transform transform_compose(const Transform *a, const Transform *b)
{
	Transform t;
	multiply(b->m, a->m, t.m);
	multiply(a->inv, b->inv, t.inv);
	return t;
}

Transform transform_inverse(const Transform *t)
{
	Transform r;
	memcpy(r.m, t->inv, sizeof r.m);
	memcpy(r.inv, t->m, sizeof r.inv);
	return r;
}

bool transform_matrix(const double rows[12], Transform *out)
{
	Vec3 x = vec3(rows[0], rows[1], rows[2]), y = vec3(rows[3], rows[4], rows[5]);
	Vec3 z = vec3(rows[6], rows[7], rows[8]), o = vec3(rows[9], rows[10], rows[11]);
	double determinant = vec3_dot(x, vec3_cross(y, z));
	*out = transform_identity();
	if (!(fabs(determinant) > 0) || !isfinite(1 / determinant))
		return false;
	/* The rows of the inverse of a matrix with columns x, y, z are the scaled cross products
	 * (Cramer). */
	Vec3 i = vec3_scale(vec3_cross(y, z), 1 / determinant);
	Vec3 j = vec3_scale(vec3_cross(z, x), 1 / determinant);
	Vec3 k = vec3_scale(vec3_cross(x, y), 1 / determinant);
	*out = (Transform){{{x.x, y.x, z.x, o.x}, {x.y, y.y, z.y, o.y}, {x.z, y.z, z.z, o.z}},
	                   {{i.x, i.y, i.z, -vec3_dot(i, o)},
	                    {j.x, j.y, j.z, -vec3_dot(j, o)},
	                    {k.x, k.y, k.z, -vec3_dot(k, o)}}};
	return true;
}

bool transform_is_identity(const Transform *t)
{
	Transform identity = transform_identity();
	return memcmp(t->m, identity.m, sizeof identity.m) == 0;
}

bool transform_is_similarity(const Transform *t, double *scale)
{
	Vec3 column[3];
	for (int j = 0; j < 3; j++)
		column[j] = vec3(t->m[0][j], t->m[1][j], t->m[2][j]);
	double s2 = vec3_length2(column[0]), tolerance = 1e-12 * s2;
	for (int j = 0; j < 3; j++) {
		if (fabs(vec3_length2(column[j]) - s2) > tolerance ||
		    fabs(vec3_dot(column[j], column[(j + 1) % 3])) > tolerance)
			return false;
	}
	*scale = sqrt(s2);
	return true;
}

/* Each face of the box goes to where it is largest or smallest; 0 times infinity counts as 0. */
static double product(double factor, double side)
{
	return factor == 0 ? 0 : factor * side;
}

bool transform_is_upright(const Transform *t)
{
	for (int i = 0; i < 3; i++)
		for (int j = 0; j < 3; j++)
			if (i == j ? !(t->m[i][j] > 0) : t->m[i][j] != 0)
				return false;
	return true;
}

Box3 transform_box(const Transform *t, Box3 box)
{
	if (box3_is_empty(box))
		return box;
	double lo[3], hi[3];
	for (int i = 0; i < 3; i++) {
		lo[i] = hi[i] = t->m[i][3];
		for (int j = 0; j < 3; j++) {
			double a = product(t->m[i][j], vec3_axis(box.lo, j)),
			       b = product(t->m[i][j], vec3_axis(box.hi, j));
			lo[i] += fmin(a, b);
			hi[i] += fmax(a, b);
		}
	}
	return (Box3){{lo[0], lo[1], lo[2]}, {hi[0], hi[1], hi[2]}};
}
