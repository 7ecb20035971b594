#include "parser/state.h"

Source *source_top(Reader *reader)
{
	return &reader->sources[reader->source_count - 1];
}

bool source_push(Reader *reader, Source source, Location at)
{
	if (reader->source_count >= SOURCE_DEPTH_LIMIT) {
		diag_error(reader->context.diag, at,
			   "macros and includes are nested more than %d deep: endless recursion?",
			   (int)SOURCE_DEPTH_LIMIT);
		reader->stopped = true;
		return false;
	}
	if (reader->source_count == reader->source_capacity) {
		reader->source_capacity = reader->source_capacity ? 2 * reader->source_capacity
								  : 32;
		reader->sources = memory_resize(reader->sources,
						(size_t)reader->source_capacity * sizeof(Source));
	}
	/* The main file's locals are the global scope's neighbours: every source but the first has
	 * a scope. */
	if (reader->source_count > 0)
		symbols_push(reader->symbols);
	reader->sources[reader->source_count++] = source;
	return true;
}

void source_pop(Reader *reader)
{
	reader->source_count--;
	if (reader->source_count > 0)
		symbols_pop(reader->symbols);
	while (reader->loop_count > 0 &&
	       reader->loops[reader->loop_count - 1].source_depth > reader->source_count)
		reader->loop_count--;
}

void source_jump(Reader *reader, uint32_t index)
{
	Source *source = source_top(reader);
	source->position = index > source->end ? source->end : index;
}

const Expansion *source_expansion(Reader *reader, Location at, const char *name)
{
	size_t slot = (at.offset * 31u + at.source + ((size_t)at.via >> 4)) % 256;
	const Expansion *known = reader->expansions[slot];
	if (known && known->name == name && known->at.offset == at.offset &&
	    known->at.source == at.source && known->at.via == at.via)
		return known;
	Expansion *expansion = ARENA_NEW(reader->context.builder->arena, Expansion);
	*expansion = (Expansion){.at = at, .name = name};
	reader->expansions[slot] = expansion;
	return expansion;
}

Location source_where(const Source *source, const Token *token)
{
	return (Location){source->file->source, token->offset, source->via};
}

Location source_here(Reader *reader)
{
	const Source *source = source_top(reader);
	if (source->position < source->file->count)
		return source_where(source, &source->file->tokens[source->position]);
	return (Location){source->file->source, (uint32_t)source->file->length, source->via};
}

const Token *source_peek(Reader *reader, uint32_t distance)
{
	const Source *source = source_top(reader);
	return distance < source->end - source->position
		       ? &source->file->tokens[source->position + distance]
		       : NULL;
}

bool source_accept_sign(Reader *reader, int sign)
{
	const Token *token = source_peek(reader, 0);
	if (!token || token->kind != TOKEN_SIGN || token->code != sign)
		return false;
	source_top(reader)->position++;
	return true;
}

bool source_take_sign(Reader *reader, int sign, const char *after)
{
	if (source_accept_sign(reader, sign))
		return true;
	diag_error(reader->context.diag, source_here(reader), "expected '%c' after %s", sign,
		   after);
	return false;
}

Name *source_take_name(Reader *reader, const char *what)
{
	const Token *token = source_peek(reader, 0);
	if (token && token->kind == TOKEN_NAME) {
		source_top(reader)->position++;
		return token->name;
	}
	diag_error(reader->context.diag, source_here(reader), "expected %s", what);
	return NULL;
}
