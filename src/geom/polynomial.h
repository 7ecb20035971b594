/*
 * Real roots of polynomials on an interval. A polynomial of degree n is c[0] + c[1] t + ... + c[n]
 * t^n.
 *
 * On a bounded interval roots are isolated by Descartes' rule of signs for Bernstein coefficients
 * and a few halvings. Where that does not decide, and on unbounded intervals, by the critical
 * points, found by the same method from the derivative, down to a quadratic: each monotone piece
 * with a change of sign holds one root (the idea: Yuksel 2022, "High-Performance Polynomial Root
 * Finding for Graphics"). A Newton iteration kept inside its bracket finds the root to machine
 * precision.
 */
#ifndef GEOM_POLYNOMIAL_H
#define GEOM_POLYNOMIAL_H

enum { POLYNOMIAL_MAX_DEGREE = 35 };

double polynomial_eval(const double *c, int degree, double t);

/* The roots with lo < t < hi, rising; returns how many, at most degree. lo and hi may be
 * infinite. A root of even multiplicity, where the sign does not change, may come out as none or
 * as two close ones. */
int polynomial_roots(const double *c, int degree, double lo, double hi, double *roots);

/* Real roots of a t^2 + b t + c, rising, without cancellation; 0, 1 (a is 0) or 2. No roots of a
 * constant. */
int polynomial_quadratic(double a, double b, double c, double roots[2]);

#endif
