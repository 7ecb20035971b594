/*
 * Macros: a body is a range of a file's tokens, read again at each call in a scope of its own. A
 * lone identifier or array element as argument stands for the caller's variable; anything else is a
 * value.
 */
#include <string.h>

#include "lang/function.h"
#include "parser/grammar.h"
#include "parser/state.h"

typedef struct Argument {
	Value value;
	Value *reference;
} Argument;

enum { PARAMETER_LIMIT = 256 };

static bool ends_argument(const Token *token)
{
	return token && token->kind == TOKEN_SIGN && (token->code == ',' || token->code == ')');
}

/* ( name, name ... ); -1 after a report. */
static int read_parameters(Reader *reader, Name **parameters)
{
	int count = 0;
	if (!source_take_sign(reader, '(', "the macro's name"))
		return -1;
	while (!source_accept_sign(reader, ')')) {
		Location where = source_here(reader);
		Name *name = source_take_name(reader, "a parameter's name");
		if (!name)
			return -1;
		if (count == PARAMETER_LIMIT ||
		    (name->word && word_class(name->word) != WORD_EXTENSION)) {
			diag_error(reader->context.diag, where,
				   count == PARAMETER_LIMIT
					   ? "too many parameters"
					   : "'%s' is a reserved word and cannot name a parameter",
				   name->text);
			return -1;
		}
		parameters[count++] = name;
		source_accept_sign(reader, ',');
	}
	return count;
}

void macro_define(Reader *reader, const Token *directive, Location where)
{
	Name *parameters[PARAMETER_LIMIT];
	if (directive->link.end == LINK_NONE)
		diag_error(reader->context.diag, where, "#macro without #end");
	Name *name = source_take_name(reader, "the macro's name");
	int count = name ? read_parameters(reader, parameters) : -1;
	Source *source = source_top(reader);
	if (count >= 0 && directive->link.end != LINK_NONE) {
		Macro *macro = ARENA_NEW(reader->context.parse, Macro);
		size_t size = (size_t)count * sizeof *parameters;
		*macro = (Macro){name, source->file, source->position, directive->link.end,
		                 arena_copy(reader->context.parse, parameters, size), count};
		symbols_declare(reader->symbols, name, (Value){.kind = VALUE_MACRO, .macro = macro},
				false);
	}
	source_jump(reader, directive->link.end == LINK_NONE ? LINK_NONE : directive->link.end + 1);
}

/* A variable alone, or an element of an array. When more than that follows, its token is given back
 * to the grammar. */
static bool read_reference(Reader *reader, Argument *argument)
{
	const Token *token = source_peek(reader, 0);
	if (!token || token->kind != TOKEN_NAME || !token->name->symbol)
		return false;
	Name *name = token->name;
	if (reader->function_depth > 0 &&
	    function_argument(&reader->context, name->text, name->length) >= 0)
		return false;
	const Value *held = symbol_value(name->symbol);
	if (held->kind == VALUE_MACRO ||
	    (held->kind != VALUE_ARRAY && !ends_argument(source_peek(reader, 1))))
		return false;
	Location where = source_here(reader);
	source_top(reader)->position++;
	Value *value = identifier_resolve(reader, name, where, true);
	bool alone = ends_argument(source_peek(reader, 0));
	if (alone) {
		argument->reference = value;
		return true;
	}
	Semantic semantic = {.value = value_float(0)};
	int kind = value && value->kind != VALUE_NONE ? identifier_token(reader, *value, &semantic)
						      : VALUE;
	reader->ahead = (Ahead){kind, semantic, where, NULL};
	reader->has_ahead = true;
	return false;
}

/* What follows an argument: true for another one, with or without a comma as POV-Ray takes them. */
static bool goes_on(Reader *reader, bool *good)
{
	Semantic value;
	Location where;
	int kind = lexer_fetch(reader, &value, &where);
	if (kind == READER_YYEOF && !reader->stopped)
		diag_error(reader->context.diag, where,
			   "the arguments of the macro are never closed");
	if (kind == READER_YYEOF)
		*good = false;
	if (kind != ',' && kind != ')')
		lexer_give_back(reader, kind, &value, where);
	return kind != ')' && kind != READER_YYEOF;
}

/* True when another one follows. */
static bool read_argument(Reader *reader, Argument *argument, bool *good)
{
	Frame frame;
	*argument = (Argument){0};
	if (!reader->has_ahead && read_reference(reader, argument)) {
		*good = argument->reference != NULL;
		bool more = source_accept_sign(reader, ',');
		return more || !source_accept_sign(reader, ')');
	}
	*good = frame_parse(reader, S_ARGUMENT, FRAME_RUNS_ON, &frame);
	argument->value = frame.value;
	return (*good || frame.value.kind != VALUE_NONE) && goes_on(reader, good);
}

/* The number of arguments, at most limit of them kept; *good turns false after a report. */
static int read_arguments(Reader *reader, Argument *arguments, int limit, bool *good)
{
	int count = 0;
	bool more = true;
	source_accept_sign(reader, '(');
	if (source_accept_sign(reader, ')'))
		return 0;
	while (more && !reader->stopped) {
		Argument extra;
		bool fine;
		more = read_argument(reader, count < limit ? &arguments[count] : &extra, &fine);
		*good = *good && fine;
		count++;
	}
	return count;
}

static void bind(Reader *reader, const Macro *macro, const Argument *arguments)
{
	for (int i = 0; i < macro->parameter_count; i++) {
		if (arguments[i].reference)
			symbols_refer(reader->symbols, macro->parameters[i],
				      arguments[i].reference);
		else
			symbols_declare(reader->symbols, macro->parameters[i], arguments[i].value,
					true);
	}
}

bool macro_call(Reader *reader, const Macro *macro, Location where)
{
	Argument arguments[macro->parameter_count + 1];
	bool good = true;
	int count = read_arguments(reader, arguments, macro->parameter_count, &good);
	if (good && count != macro->parameter_count)
		diag_error(reader->context.diag, where, "macro '%s' takes %d arguments, not %d",
			   macro->name->text, macro->parameter_count, count);
	if (!good || count != macro->parameter_count)
		return false;
	const Expansion *via = source_expansion(reader, where, macro->name->text);
	Source body = {SOURCE_MACRO, macro->file, macro->begin, macro->end, via};
	if (!source_push(reader, body, where))
		return false;
	bind(reader, macro, arguments);
	return true;
}
