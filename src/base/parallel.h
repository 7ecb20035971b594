/*
 * Parallel loops over independent items (OpenMP inside). The body gets the item and the number of
 * the thread that runs it, 0 .. parallel_threads() - 1, for scratch memory; results must depend on
 * the item alone.
 */
#ifndef BASE_PARALLEL_H
#define BASE_PARALLEL_H

typedef void ParallelBody(void *data, long item, int thread);

void parallel_set_threads(int threads); /* 0: as many as the machine has */
int parallel_threads(void);
/* Items are handed out in increasing order, chunk at a time. */
void parallel_for(long count, long chunk, ParallelBody *body, void *data);

#endif
