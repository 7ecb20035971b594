#include "cli/tool.h"

#include <stdio.h>
#include <stdlib.h>

#include "config.h"

typedef enum Reading { READ_WELL, READ_WRONG, READ_ENOUGH } Reading;

static Reading take_option(const Tool *tool, void *task, int option, const char *name)
{
	const char *wanted = NULL;
	switch (option) {
	case '?': return READ_WRONG; /* getopt_long has told */
	case TOOL_HELP: fputs(tool->usage, stdout); return READ_ENOUGH;
	case TOOL_VERSION: printf("%s %s\n", tool->name, PACKAGE_VERSION); return READ_ENOUGH;
	default: wanted = tool->take(task, option, optarg);
	}
	if (wanted)
		fprintf(stderr, "%s: --%s wants %s, not %s\n", tool->name, name, wanted, optarg);
	return wanted ? READ_WRONG : READ_WELL;
}

static Reading read_options(const Tool *tool, void *task, int argc, char **argv)
{
	int option, row = 0;
	Reading reading = READ_WELL;
	while (reading == READ_WELL &&
	       (option = getopt_long(argc, argv, tool->letters, tool->options, &row)) != -1)
		reading = take_option(tool, task, option, tool->options[row].name);
	int operands = argc - optind;
	if (reading != READ_WELL || (operands >= tool->least && operands <= tool->most))
		return reading;
	fputs(tool->usage, stderr);
	return READ_WRONG;
}

int tool_main(const Tool *tool, void *task, int argc, char **argv)
{
	Reading reading = read_options(tool, task, argc, argv);
	if (reading != READ_WELL)
		return reading == READ_ENOUGH ? EXIT_SUCCESS : EXIT_FAILURE;
	Diag *diag = diag_create(stderr);
	bool good = tool->run(task, argv + optind, argc - optind, diag);
	diag_destroy(diag);
	return good ? EXIT_SUCCESS : EXIT_FAILURE;
}
