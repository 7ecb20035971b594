/*
 * Algebraic surfaces: quadrics, and polynomials in x, y, z up to degree 35. Inside is where the
 * value is negative.
 */
#ifndef GEOM_POLY_H
#define GEOM_POLY_H

#include "base/arena.h"
#include "geom/shape.h"

/* A x^2 + B y^2 + C z^2 + D xy + E xz + F yz + G x + H y + I z + J: the ten numbers in the order
 * of the quadric statement. */
const void *quadric_create(Arena *arena, const double coefficients[10]);
extern const ShapeClass quadric_class;

enum { POLY_MIN_ORDER = 2, POLY_MAX_ORDER = 35 };

/* How many coefficients a polynomial of that order has. */
int poly_term_count(int order);
/* Where the coefficient of x^i y^j z^k stands in the order of the poly statement; -1 when i + j
 * + k exceeds the order. */
int poly_term_index(int order, int i, int j, int k);

/* Coefficients in the order of the poly, cubic and quartic statements; copied. NULL with *error
 * set for an order out of range. */
const void *poly_create(Arena *arena, int order, const double *coefficients, const char **error);
extern const ShapeClass poly_class;

#endif
