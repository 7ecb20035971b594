/*
 * Directives: conditions and loops are jumps within a source's tokens (link.h); the others are in
 * files of their own.
 */
#include <math.h>
#include <string.h>

#include "lang/build.h"
#include "parser/grammar.h"
#include "parser/state.h"

static const double NEWEST_VERSION = 3.7, NEWEST_EXTENSION = 1;

static void report_unpaired(Reader *reader, const char *name, const char *partner, Location where)
{
	diag_error(reader->context.diag, where, "#%s without %s", name, partner);
}

/* ( NAME ): whether it is declared. */
static bool read_defined(Reader *reader, const char *directive)
{
	if (!source_take_sign(reader, '(', directive))
		return false;
	Location where = source_here(reader);
	Name *name = source_take_name(reader, "an identifier");
	if (!name)
		return false;
	const Value *value = identifier_resolve(reader, name, where, false);
	source_take_sign(reader, ')', "the identifier");
	bool redefined_word = name->word != W_NONE && word_class(name->word) == WORD_CONSTANT;
	return (value && value->kind != VALUE_NONE) || redefined_word;
}

static bool read_test(Reader *reader, Word word, bool *good)
{
	bool result = false;
	if (word == W_ifdef)
		return read_defined(reader, "#ifdef");
	if (word == W_ifndef)
		return !read_defined(reader, "#ifndef");
	*good = frame_condition(reader, &result);
	return result;
}

/* From #if on: stays in the branch whose test holds, or goes behind #end. */
static void run_if(Reader *reader, const Token *token, Location where)
{
	const Token *tokens = source_top(reader)->file->tokens;
	bool good = true;
	if (token->link.end == LINK_NONE) {
		report_unpaired(reader, word_text((Word)token->code), "#end", where);
		reader->stopped = true;
		return;
	}
	while (!read_test(reader, (Word)token->code, &good)) {
		uint32_t next = good ? token->link.next : token->link.end;
		token = &tokens[next];
		source_jump(reader, next + 1);
		if (token->code != W_elseif)
			return;
	}
}

static void run_while(Reader *reader, const Token *token, Location where)
{
	bool holds;
	if (token->link.end == LINK_NONE) {
		report_unpaired(reader, "while", "#end", where);
		reader->stopped = true;
	} else if (!frame_condition(reader, &holds) || !holds) {
		source_jump(reader, token->link.end + 1);
	}
}

static bool loop_is_over(const Loop *loop, double value)
{
	/* As many steps as one counts by hand, whatever 0.1 * 10 is. */
	double slack = 1e-9 * fabs(loop->step);
	return loop->step > 0 ? value > loop->end + slack : value < loop->end - slack;
}

static void push_loop(Reader *reader, Loop loop)
{
	if (reader->loop_count == reader->loop_capacity) {
		reader->loop_capacity = reader->loop_capacity ? 2 * reader->loop_capacity : 16;
		reader->loops = memory_resize(reader->loops,
					      (size_t)reader->loop_capacity * sizeof(Loop));
	}
	reader->loops[reader->loop_count++] = loop;
}

/* ( NAME, from, to [, step] ) into the loop; false after a report. */
static bool read_loop(Reader *reader, Loop *loop, double *from)
{
	Frame frame;
	if (!source_take_sign(reader, '(', "#for") ||
	    !(loop->name = source_take_name(reader, "a variable's name")) ||
	    !source_take_sign(reader, ',', "the variable"))
		return false;
	Location where = source_here(reader);
	if (!frame_arguments(reader, &frame))
		return false;
	const Value *values = reader->values + frame.run.start;
	reader->value_count = frame.run.start;
	bool numeric = true;
	for (int i = 0; i < frame.run.count; i++)
		numeric = numeric && value_is_numeric(values[i]);
	if (frame.run.count < 2 || frame.run.count > 3 || !numeric) {
		diag_error(reader->context.diag, where,
			   "#for takes a variable, a first and a last value and a step");
		return false;
	}
	*from = value_to_float(values[0]);
	loop->end = value_to_float(values[1]);
	loop->step = frame.run.count > 2 ? value_to_float(values[2]) : 1;
	if (loop->step == 0)
		diag_error(reader->context.diag, where, "the step of #for is zero");
	return loop->step != 0;
}

static void run_for(Reader *reader, const Token *token, Location where)
{
	double from;
	Loop loop = {.source_depth = reader->source_count};
	loop.opener = source_top(reader)->position - 1;
	if (token->link.end == LINK_NONE) {
		report_unpaired(reader, "for", "#end", where);
		reader->stopped = true;
	} else if (!read_loop(reader, &loop, &from)) {
		source_jump(reader, token->link.end + 1);
	} else {
		symbols_declare(reader->symbols, loop.name, value_float(from), true)
			->declared = where;
		loop.body = source_top(reader)->position;
		if (loop_is_over(&loop, from))
			source_jump(reader, token->link.end + 1);
		else
			push_loop(reader, loop);
	}
}

/* At #end of a #for: the variable may have been changed in the body, and counts on from there. */
static void repeat_for(Reader *reader, uint32_t opener, Location where)
{
	Loop *loop = reader->loop_count ? &reader->loops[reader->loop_count - 1] : NULL;
	if (!loop || loop->opener != opener)
		return;
	Value *value = loop->name->symbol ? symbol_value(loop->name->symbol) : NULL;
	if (!value || value->kind != VALUE_FLOAT) {
		diag_error(reader->context.diag, where,
			   "the variable '%s' of #for is no float any more", loop->name->text);
		reader->loop_count--;
		return;
	}
	value->number += loop->step;
	if (reader_has_failed(reader) || loop_is_over(loop, value->number))
		reader->loop_count--;
	else
		source_jump(reader, loop->body);
}

/* A loop whose body has a mistake may never end; nothing is rendered, so it goes round no more. */
static void run_end(Reader *reader, const Token *token, Location where)
{
	uint32_t opener = token->link.next;
	if (opener == LINK_NONE) {
		diag_error(reader->context.diag, where,
			   "#end without #if, #while, #for, #switch or #macro");
		return;
	}
	Word word = (Word)source_top(reader)->file->tokens[opener].code;
	if (word == W_while && !reader_has_failed(reader))
		source_jump(reader, opener);
	else if (word == W_for)
		repeat_for(reader, opener, where);
}

/* #else or #elseif behind a branch that was taken. */
static void run_else(Reader *reader, const Token *token, Location where)
{
	if (token->link.end == LINK_NONE)
		report_unpaired(reader, word_text((Word)token->code), "#if", where);
	else if (!token->in_switch)
		source_jump(reader, token->link.end + 1);
}

static void run_break(Reader *reader, const Token *token, Location where)
{
	uint32_t opener = token->link.next;
	if (opener == LINK_NONE) {
		report_unpaired(reader, "break", "#switch, #while, #for or #macro around it",
				where);
		return;
	}
	const Token *left = &source_top(reader)->file->tokens[opener];
	if (left->code == W_for && reader->loop_count > 0 &&
	    reader->loops[reader->loop_count - 1].opener == opener)
		reader->loop_count--;
	if (left->code == W_macro)
		source_jump(reader, LINK_NONE);
	else
		source_jump(reader, left->link.end + 1);
}

/* #case or #range: the arguments and whether value is among them. */
static bool case_holds(Reader *reader, Word word, double value, bool *good)
{
	Frame frame;
	Location where = source_here(reader);
	*good = source_take_sign(reader, '(', word == W_case ? "#case" : "#range") &&
		frame_arguments(reader, &frame);
	if (!*good)
		return false;
	const Value *values = reader->values + frame.run.start;
	reader->value_count = frame.run.start;
	int expected = word == W_case ? 1 : 2;
	*good = frame.run.count == expected && value_is_numeric(values[0]) &&
		value_is_numeric(values[expected - 1]);
	if (!*good) {
		diag_error(reader->context.diag, where,
			   word == W_case ? "#case takes a float" : "#range takes two floats");
		return false;
	}
	double low = value_to_float(values[0]), high = value_to_float(values[expected - 1]);
	return word == W_case ? fabs(value - low) < 1e-10 : value >= low && value <= high;
}

/* To the first #case or #range that holds, or #else, or behind #end. */
static void choose_case(Reader *reader, const Token *token, double value)
{
	const Token *tokens = source_top(reader)->file->tokens;
	uint32_t end = token->link.end;
	bool good = true;
	for (uint32_t next = token->link.next; good; next = tokens[next].link.next) {
		source_jump(reader, next + 1);
		if (next == end || tokens[next].code == W_else ||
		    case_holds(reader, (Word)tokens[next].code, value, &good))
			return;
	}
	source_jump(reader, end + 1);
}

static void run_switch(Reader *reader, const Token *token, Location where)
{
	Frame frame;
	if (token->link.end == LINK_NONE) {
		report_unpaired(reader, "switch", "#end", where);
		reader->stopped = true;
		return;
	}
	bool good = frame_parse(reader, S_CONDITION, FRAME_RUNS_ON, &frame);
	if (good && value_is_numeric(frame.value)) {
		choose_case(reader, token, value_to_float(frame.value));
		return;
	}
	if (good)
		diag_error(reader->context.diag, where, "#switch takes a float");
	source_jump(reader, token->link.end + 1);
}

static void run_default(Reader *reader)
{
	Frame frame;
	if (frame_parse(reader, S_NODES, FRAME_RUNS_ON, &frame))
		build_defaults(&reader->context, frame.nodes);
}

/* unofficial NAME version; ours turns the extension on. */
static void run_unofficial(Reader *reader, Location where)
{
	const Token *name = source_peek(reader, 0);
	if (!name || name->kind != TOKEN_NAME || strcmp(name->name->text, "cognac") != 0) {
		diag_error(reader->context.diag, where,
			   "this scene is written for another unofficial version of POV-Ray");
		reader->stopped = true;
		return;
	}
	source_top(reader)->position++;
	reader->context.cognac = true;
	reader->context.builder->settings.cognac = true;
}

static void set_version(Reader *reader, double version, Location where)
{
	if (version > NEWEST_VERSION)
		diag_warning(reader->context.diag, where,
			     "version %g of the language is newer than %g, the newest known here",
			     version, NEWEST_VERSION);
	reader->context.version = reader->context.builder->settings.version = version;
}

static void run_version(Reader *reader)
{
	Frame frame;
	const Token *first = source_peek(reader, 0);
	Location where = source_here(reader);
	bool unofficial = first && first->kind == TOKEN_NAME &&
			  strcmp(first->name->text, "unofficial") == 0;
	if (unofficial) {
		source_top(reader)->position++;
		run_unofficial(reader, where);
		where = source_here(reader);
	}
	if (!frame_parse(reader, S_EXPRESSION, FRAME_ENDS_AT_DIRECTIVE, &frame))
		return;
	if (!value_is_numeric(frame.value))
		diag_error(reader->context.diag, where, "#version takes a number");
	else if (!unofficial)
		set_version(reader, value_to_float(frame.value), where);
	else if (value_to_float(frame.value) > NEWEST_EXTENSION)
		diag_warning(reader->context.diag, where,
			     "version %g of the extension is newer than %g, the newest known here",
			     value_to_float(frame.value), NEWEST_EXTENSION);
	reader->version_given = true;
	declare_end(reader, &frame);
}

static void run_unknown(Reader *reader, const Token *token, Location where)
{
	const char *text = source_top(reader)->file->text + token->offset + 1;
	static const char letters[] =
		"abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ_0123456789";
	text += strspn(text, " \t\r\n");
	diag_error(reader->context.diag, where, "unknown directive '#%.*s'",
		   (int)strspn(text, letters), text);
	declare_skip(reader);
}

void directive_run(Reader *reader, const Token *token, Location where)
{
	switch ((Word)token->code) {
	case W_declare: declare_directive(reader, false, where); break;
	case W_local: declare_directive(reader, true, where); break;
	case W_undef: declare_undef(reader); break;
	case W_if: case W_ifdef: case W_ifndef: run_if(reader, token, where); break;
	case W_elseif: case W_else: run_else(reader, token, where); break;
	case W_while: run_while(reader, token, where); break;
	case W_for: run_for(reader, token, where); break;
	case W_switch: run_switch(reader, token, where); break;
	case W_case: case W_range:
		if (token->link.end == LINK_NONE)
			report_unpaired(reader, word_text((Word)token->code), "#switch", where);
		else
			lexer_skip_group(reader, '(', ')'); /* falls through from the case before */
		break;
	case W_break: run_break(reader, token, where); break;
	case W_end: run_end(reader, token, where); break;
	case W_macro: macro_define(reader, token, where); break;
	case W_include: include_directive(reader, where); break;
	case W_default: run_default(reader); break;
	case W_version: run_version(reader); break;
	case W_debug: case W_warning: case W_error: case W_render: case W_statistics:
		stream_directive(reader, (Word)token->code, where); break;
	case W_fopen: case W_fclose: case W_read: case W_write:
		file_directive(reader, (Word)token->code, where); break;
	default: run_unknown(reader, token, where); break;
	}
}
