/* The shell commands around scenes and frames (Pre_Scene_Command and its kin), off unless the user
 * allows them. */
#ifndef CLI_SHELL_H
#define CLI_SHELL_H

#include "cli/options.h"

/* What the command's return action asks for. */
typedef enum ShellAction {
	SHELL_GO_ON, SHELL_SKIP, SHELL_SKIP_ALL, SHELL_QUIT, SHELL_USER_STOP, SHELL_FAIL
} ShellAction;

typedef struct ShellFrame {
	const char *output, *scene; /* %o %s */
	int frame;                  /* %n */
	double clock;               /* %k */
} ShellFrame;

/* The command with its % replaced; in the options' arena. */
const char *shell_expand(const Options *options, const char *command, const ShellFrame *frame);

/* Runs the moment's command, if there is one and commands are allowed; reports a refused one. */
ShellAction shell_run(const Options *options, ShellMoment moment, const ShellFrame *frame,
		      Diag *diag);

#endif
