/* What a render cost: summed over frames, printed as text and written as JSON. */
#ifndef CLI_STATISTICS_H
#define CLI_STATISTICS_H

#include <stdio.h>

#include "render/passes.h"

typedef struct FrameStatistics {
	int frames;
	double parse_seconds, build_seconds, trace_seconds, write_seconds, cpu_seconds;
	long shapes, lights;
	PassStatistics passes;
} FrameStatistics;

void statistics_add(FrameStatistics *sum, const FrameStatistics *frame);
void statistics_print(FILE *out, const FrameStatistics *statistics);
/* scene: its file; status: how it ended. Written beside and renamed; false on failure, reported. */
bool statistics_write_json(const FrameStatistics *statistics, const char *scene, const char *status,
                           const char *path, Diag *diag);

#endif
