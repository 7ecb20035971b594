#include "parser/link.h"

#include <stdlib.h>

/* A directive that waits for its #end, and the last branch seen. */
typedef struct Open {
	uint32_t opener, branch;
} Open;

typedef struct Linker {
	Token *tokens;
	Open *open;
	int depth, capacity;
} Linker;

static void push(Linker *linker, uint32_t index)
{
	if (linker->depth == linker->capacity) {
		linker->capacity = linker->capacity ? 2 * linker->capacity : 64;
		linker->open = memory_resize(linker->open, (size_t)linker->capacity * sizeof(Open));
	}
	linker->open[linker->depth++] = (Open){index, index};
}

static void add_branch(Linker *linker, uint32_t index)
{
	if (linker->depth == 0)
		return;
	Open *open = &linker->open[linker->depth - 1];
	linker->tokens[open->branch].link.next = index;
	linker->tokens[index].in_switch = linker->tokens[open->opener].code == W_switch;
	open->branch = index;
}

static void close(Linker *linker, uint32_t index)
{
	if (linker->depth == 0)
		return;
	Open open = linker->open[--linker->depth];
	Token *tokens = linker->tokens;
	tokens[open.branch].link.next = index;
	for (uint32_t i = open.opener; i != index; i = tokens[i].link.next)
		tokens[i].link.end = index;
	tokens[index].link = (Link){open.opener, index};
}

static void tie_break(Linker *linker, uint32_t index)
{
	for (int i = linker->depth - 1; i >= 0; i--) {
		Word word = (Word)linker->tokens[linker->open[i].opener].code;
		if (word == W_switch || word == W_while || word == W_for || word == W_macro) {
			linker->tokens[index].link.next = linker->open[i].opener;
			return;
		}
	}
}

static void link_directive(Linker *linker, uint32_t index)
{
	switch ((Word)linker->tokens[index].code) {
	case W_if:
	case W_ifdef:
	case W_ifndef:
	case W_while:
	case W_for:
	case W_switch:
	case W_macro:
		push(linker, index);
		break;
	case W_elseif: case W_else: case W_case: case W_range:
		add_branch(linker, index);
		break;
	case W_end:
		close(linker, index);
		break;
	case W_break:
		tie_break(linker, index);
		break;
	default:
		break;
	}
}

void link_directives(TokenFile *file)
{
	Linker linker = {.tokens = file->tokens};
	for (uint32_t i = 0; i < file->count; i++)
		if (file->tokens[i].kind == TOKEN_DIRECTIVE)
			link_directive(&linker, i);
	free(linker.open);
}
