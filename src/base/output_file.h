/*
 * Output files that are whole or not there: written under another name beside the target and
 * renamed when complete.
 * "-" is standard output, which gets everything at the end.
 */
#ifndef BASE_OUTPUT_FILE_H
#define BASE_OUTPUT_FILE_H

#include <stdio.h>

#include "base/diag.h"

typedef struct OutputFile {
	FILE *stream;      /* seekable; write here */
	char *path, *temporary;
} OutputFile;

bool output_file_open(OutputFile *file, const char *path, Diag *diag);
/* Closes and puts it in place. False when anything that was written did not get there, reported,
 * and nothing is left behind. */
bool output_file_commit(OutputFile *file, Diag *diag);
/* Closes and removes it. */
void output_file_abandon(OutputFile *file);

#endif
