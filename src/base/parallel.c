#include "base/parallel.h"

#include <omp.h>

void parallel_set_threads(int threads)
{
	omp_set_num_threads(threads > 0 ? threads : omp_get_num_procs());
}

int parallel_threads(void)
{
	return omp_get_max_threads();
}

void parallel_for(long count, long chunk, ParallelBody *body, void *data)
{
	if (parallel_threads() == 1 || count <= chunk) {
		for (long i = 0; i < count; i++)
			body(data, i, 0);
		return;
	}
#pragma omp parallel for schedule(dynamic, chunk)
	for (long i = 0; i < count; i++)
		body(data, i, omp_get_thread_num());
}
