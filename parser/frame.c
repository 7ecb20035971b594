/* Calls of the grammar from directives and from the reader, and what happens after a syntax error.
 */
#include <string.h>

#include "lang/function.h"
#include "parser/grammar.h"
#include "parser/state.h"

static void begin(Reader *reader, int start, FrameEnd ends, Frame *frame)
{
	*frame = (Frame){
		.start = start,
		.ends = ends,
		.source_depth = reader->source_count,
		.value_count = reader->value_count,
		.function_depth = reader->function_depth,
		.brace_count = reader->brace_count,
		.outer = reader->frame,
	};
	reader->frame = frame;
	reader->frame_depth++;
}

/* After a failure: leaves what was entered on the way. */
static void unwind(Reader *reader, const Frame *frame)
{
	while (reader->source_count > frame->source_depth && reader->source_count > 1)
		source_pop(reader);
	while (reader->function_depth > frame->function_depth)
		tree_function(reader, NULL, source_here(reader));
	reader->value_count = frame->value_count;
	reader->has_ahead = false;
}

bool frame_parse(Reader *reader, int start, FrameEnd ends, Frame *frame)
{
	if (reader->frame_depth >= FRAME_DEPTH_LIMIT) {
		diag_error(reader->context.diag, source_here(reader),
			   "directives are nested more than %d deep: endless recursion?",
			   (int)FRAME_DEPTH_LIMIT);
		reader->stopped = true;
		*frame = (Frame){.failed = true};
		return false;
	}
	begin(reader, start, ends, frame);
	bool parsed = reader_yyparse(reader) == 0;
	if (!parsed) {
		frame->failed = true;
		unwind(reader, frame);
	}
	reader->brace_count = frame->brace_count;
	reader->frame = frame->outer;
	reader->frame_depth--;
	return parsed && !frame->failed;
}

bool frame_string(Reader *reader, const char **out)
{
	Frame frame;
	Location where = source_here(reader);
	*out = "";
	if (!frame_parse(reader, S_STRING, FRAME_ENDS_AT_DIRECTIVE, &frame))
		return false;
	if (frame.value.kind != VALUE_STRING) {
		diag_error(reader->context.diag, where, "expected a string, found %s",
			   value_describe(frame.value));
		return false;
	}
	*out = frame.value.string;
	return true;
}

bool frame_arguments(Reader *reader, Frame *frame)
{
	return frame_parse(reader, S_ARGUMENTS, FRAME_RUNS_ON, frame);
}

bool frame_condition(Reader *reader, bool *out)
{
	Frame frame;
	Location where = source_here(reader);
	*out = false;
	if (!frame_parse(reader, S_CONDITION, FRAME_RUNS_ON, &frame))
		return false;
	if (!value_is_numeric(frame.value)) {
		diag_error(reader->context.diag, where, "expected a condition, found %s",
			   value_describe(frame.value));
		return false;
	}
	*out = value_to_float(frame.value) != 0;
	return true;
}

/* The text of the token at a place: a name, a number or a sign. */
static const char *token_text(Reader *reader, Location where)
{
	static const char letters[] =
		"abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ_0123456789";
	for (const TokenFile *file = reader->files; file; file = file->next) {
		if (file->source != where.source || where.offset >= file->length)
			continue;
		const char *text = file->text + where.offset;
		size_t length = strspn(text, letters);
		return arena_strndup(reader->context.items, text, length ? length : 1);
	}
	return NULL;
}

static void report_end(Reader *reader, Location where)
{
	const Token *next = source_peek(reader, 0);
	Diag *diag = reader->context.diag;
	if (reader->brace_count > reader->frame->brace_count)
		diag_error(diag, reader->braces[reader->brace_count - 1],
			   "the block that begins here is never closed");
	else if (next && next->kind == TOKEN_DIRECTIVE)
		diag_error(diag, where, "unexpected directive");
	else
		diag_error(diag, where, "unexpected end of the text");
}

static void report_token(Reader *reader, Location where, const char *expected, const char *or_else)
{
	Diag *diag = reader->context.diag;
	bool is_string = reader->last_kind == VALUE &&
			 reader->last_value.value.kind == VALUE_STRING;
	const char *text = is_string ? NULL : token_text(reader, where);
	const char *found = text ? arena_printf(reader->context.items, "'%s'", text) : "a string";
	if (expected && or_else)
		diag_error(diag, where, "expected %s or %s, found %s", expected, or_else, found);
	else if (expected)
		diag_error(diag, where, "expected %s, found %s", expected, found);
	else
		diag_error(diag, where, "unexpected %s", found);
}

void frame_syntax_error(Reader *reader, Location where, const char *expected, const char *or_else)
{
	Frame *frame = reader->frame;
	bool silent = reader->poisoned || reader->stopped;
	frame->failed = true;
	frame->recovering = reader->last_kind != '}' && frame->depth > 0;
	frame->skip_depth = reader->last_kind == '{';
	if (silent)
		return;
	if (reader->last_kind == READER_YYEOF)
		report_end(reader, where);
	else
		report_token(reader, where, expected, or_else);
}
