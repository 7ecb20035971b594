/* A whole run: one picture, or every frame of an animation, with the shell commands around them. */
#ifndef CLI_RUN_H
#define CLI_RUN_H

#include "cli/options.h"
#include "cli/status.h"

/* switches: the command line as one text. All trouble is reported to diag. */
Status run_scene(const Options *options, const char *switches, Diag *diag);

#endif
