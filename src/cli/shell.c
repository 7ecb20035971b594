#include "cli/shell.h"

#include <ctype.h>
#include <stdlib.h>
#include <string.h>

static const char *substitute(const Options *options, char letter, const ShellFrame *frame)
{
	switch (letter) {
	case 'o': return frame->output;
	case 's': return frame->scene;
	case 'n': return arena_printf(options->arena, "%d", frame->frame);
	case 'k': return arena_printf(options->arena, "%g", frame->clock);
	case 'h': return arena_printf(options->arena, "%d", options->height);
	case 'w': return arena_printf(options->arena, "%d", options->width);
	case '%': return "%";
	default: return arena_printf(options->arena, "%%%c", letter);
	}
}

const char *shell_expand(const Options *options, const char *command, const ShellFrame *frame)
{
	const char *result = "";
	while (*command) {
		size_t plain = strcspn(command, "%");
		const char *value = command[plain] && command[plain + 1]
					    ? substitute(options, command[plain + 1], frame)
					    : "";
		result = arena_printf(options->arena, "%s%.*s%s", result, (int)plain, command,
				      value);
		command += plain;
		command += command[0] ? command[1] ? 2 : 1 : 0;
	}
	return result;
}

/* A letter says what to do about a command that failed; with - or ! before it, about one that did
 * not. */
static ShellAction action_for(const char *wanted, int status)
{
	static const struct { char letter; ShellAction action;
	} actions[] = {
		{'S', SHELL_SKIP},      {'A', SHELL_SKIP_ALL}, {'Q', SHELL_QUIT},
		{'U', SHELL_USER_STOP}, {'F', SHELL_FAIL},
	};
	if (!wanted)
		return SHELL_GO_ON;
	bool inverted = *wanted == '-' || *wanted == '!';
	if (inverted ? status != 0 : status == 0)
		return SHELL_GO_ON;
	for (size_t i = 0; i < sizeof actions / sizeof *actions; i++)
		if (toupper((unsigned char)wanted[inverted]) == actions[i].letter)
			return actions[i].action;
	return SHELL_GO_ON;
}

ShellAction shell_run(const Options *options, ShellMoment moment, const ShellFrame *frame,
		      Diag *diag)
{
	const char *command = options->shell_command[moment];
	if (!command)
		return SHELL_GO_ON;
	if (!options->allow_shell) {
		diag_note(diag, "shell commands are off (--allow-shell turns them on): %s",
			  command);
		return SHELL_GO_ON;
	}
	return action_for(options->shell_return[moment],
			  system(shell_expand(options, command, frame)));
}
