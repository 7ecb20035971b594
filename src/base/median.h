/*
 * The value in the middle of a few.
 */
#ifndef BASE_MEDIAN_H
#define BASE_MEDIAN_H

enum { MEDIAN_MOST = 1024 };

/* Of 1 to MEDIAN_MOST values, which stay in their order; the upper one of an even number's two.
 * INFINITY where the one in the middle is not finite. */
double median(const double *values, int count);

#endif
