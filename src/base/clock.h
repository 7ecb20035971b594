/* Elapsed time, processor time and peak memory, for statistics. */
#ifndef BASE_CLOCK_H
#define BASE_CLOCK_H

#include <stddef.h>

double clock_wall(void);        /* seconds since some fixed moment, monotonic */
double clock_cpu(void);         /* processor seconds of the process, all threads */
size_t clock_peak_memory(void); /* bytes, the process' peak resident set */

#endif
