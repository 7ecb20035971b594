/*
 * Two numbers side by side, which the compiler keeps in one register where there are such: gcc's
 * vectors, with the operators of plain numbers.
 */
#ifndef BASE_PAIR_H
#define BASE_PAIR_H

#include <stdint.h>

typedef double Pair __attribute__((vector_size(16)));
typedef int64_t PairCount __attribute__((vector_size(16))); /* Pairs' comparisons: -1 or 0 each */

#endif
