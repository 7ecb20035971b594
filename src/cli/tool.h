/* What the small programs beside cognac share: options read with getopt, --help, --version, and a
 * sink for messages around what they do. */
#ifndef CLI_TOOL_H
#define CLI_TOOL_H

#include <getopt.h>
#include <stdbool.h>

#include "base/diag.h"

typedef struct Tool {
	const char *name, *usage;
	const char *letters;          /* as getopt_long wants them */
	const struct option *options; /* values above 0; ends with TOOL_OPTIONS */
	int least, most;              /* operands */
	/* Takes one option into the task. NULL, or for a bad value of a long option what it wants
	 * instead: "a number above 0". */
	const char *(*take)(void *task, int option, const char *value);
	/* Does the work; false when it failed, reported. */
	bool (*run)(void *task, char **operands, int count, Diag *diag);
} Tool;

enum { TOOL_HELP = -2, TOOL_VERSION = -3 };
/* The last rows of every tool's options. */
#define TOOL_OPTIONS \
	{"help", no_argument, NULL, TOOL_HELP}, {"version", no_argument, NULL, TOOL_VERSION}, \
	{NULL, 0, NULL, 0}

/* The whole program; returns its exit status. */
int tool_main(const Tool *tool, void *task, int argc, char **argv);

#endif
