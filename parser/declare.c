/* #declare, #local, #undef. */
#include <string.h>

#include "lang/array.h"
#include "parser/grammar.h"
#include "parser/state.h"

/* What is to be declared: a name, or an element of the array it names. */
typedef struct Target {
	Name *name;
	Array *array;
	Value *element;
	Location where;
	bool local;
} Target;

/* `deprecated [once] ["message"]` before the name. */
typedef struct Deprecation {
	bool deprecated, once;
	const char *message;
} Deprecation;

/* Words that POV-Ray lets a scene declare anew. */
static bool can_declare(const Reader *reader, const Name *name)
{
	switch (name->word) {
	case W_NONE:
	case W_image_width:
	case W_image_height:
	case W_frame_number:
	case W_clock_delta:
	case W_initial_clock:
	case W_final_clock: case W_initial_frame: case W_final_frame:
		return true;
	default:
		return word_class(name->word) == WORD_EXTENSION && !reader->context.cognac;
	}
}

static bool next_is(Reader *reader, int sign)
{
	const Token *next = source_peek(reader, 0);
	return next && next->kind == TOKEN_SIGN && next->code == sign;
}

static bool read_element(Reader *reader, Target *target)
{
	double subscripts[8];
	Value *held = target->name->symbol ? symbol_value(target->name->symbol) : NULL;
	if (!held || held->kind != VALUE_ARRAY) {
		diag_error(reader->context.diag, target->where, "'%s' is no array",
			   target->name->text);
		return false;
	}
	target->array = held->array;
	int count = identifier_subscripts(reader, subscripts);
	if (count > 0)
		target->element = array_element(&reader->context, target->array, subscripts, count,
						target->where);
	return target->element != NULL;
}

/* False after a report; the name is NULL when there is none. */
static bool read_target(Reader *reader, Target *target)
{
	target->where = source_here(reader);
	target->name = source_take_name(reader, "an identifier");
	if (!target->name)
		return false;
	if (!can_declare(reader, target->name)) {
		diag_error(reader->context.diag, target->where,
			   "'%s' is a reserved word and cannot be declared", target->name->text);
		return false;
	}
	return !next_is(reader, '[') || read_element(reader, target);
}

static Symbol *assign(Reader *reader, const Target *target, Value value)
{
	if (value.kind == VALUE_ARRAY)
		value.array = array_copy(reader->context.parse, value.array);
	if (target->element) {
		array_set(&reader->context, target->array, target->element, value, target->where);
		return NULL;
	}
	Symbol *symbol = symbols_declare(reader->symbols, target->name, value, target->local);
	symbol->declared = target->where;
	symbol->poisoned = value.kind == VALUE_NONE;
	return symbol;
}

bool declare_assign(Reader *reader, Value value)
{
	Target target = {0};
	if (!read_target(reader, &target))
		return false;
	assign(reader, &target, value);
	return true;
}

static bool accept_word(Reader *reader, Word word)
{
	const Token *next = source_peek(reader, 0);
	if (!next || next->kind != TOKEN_NAME || next->name->word != word)
		return false;
	source_top(reader)->position++;
	return true;
}

static Deprecation read_deprecation(Reader *reader)
{
	Deprecation result = {0};
	if (!accept_word(reader, W_deprecated))
		return result;
	result.deprecated = true;
	result.once = accept_word(reader, W_once);
	const Token *next = source_peek(reader, 0);
	if (next && next->kind == TOKEN_STRING)
		frame_string(reader, &result.message);
	return result;
}

static bool accept_semicolon(Reader *reader)
{
	if (!reader->has_ahead)
		return source_accept_sign(reader, ';');
	if (reader->ahead.kind != ';')
		return false;
	reader->has_ahead = false;
	return true;
}

/* Runs what is left of the macros that gave the frame's value. */
static void drain_macros(Reader *reader, const Frame *frame)
{
	while (!reader->has_ahead && reader->source_count > frame->source_depth &&
	       !reader->stopped) {
		Source *source = source_top(reader);
		const Token *next = source_peek(reader, 0);
		if (!next) {
			source_pop(reader);
		} else if (next->kind == TOKEN_DIRECTIVE) {
			Location where = source_where(source, next);
			source->position++;
			directive_run(reader, next, where);
		} else {
			break;
		}
	}
}

bool declare_end(Reader *reader, const Frame *frame)
{
	/* A macro's body may end with `value;` although its call does as well. */
	bool ended = accept_semicolon(reader);
	if (ended && reader->source_count <= frame->source_depth)
		return true;
	drain_macros(reader, frame);
	return accept_semicolon(reader) || ended;
}

void declare_skip(Reader *reader)
{
	const Token *token;
	int depth = 0;
	reader->has_ahead = false;
	while ((token = source_peek(reader, 0)) && token->kind != TOKEN_DIRECTIVE) {
		int code = token->kind == TOKEN_SIGN ? token->code : 0;
		depth += (code == '{') - (code == '}');
		if (depth < 0)
			return;
		source_top(reader)->position++;
		if (code == ';' && depth == 0)
			return;
	}
}

static void declare(Reader *reader, const Target *target, Deprecation deprecation)
{
	Frame frame;
	Location where = source_here(reader);
	bool good = frame_parse(reader, S_VALUE, FRAME_ENDS_AT_DECLARE, &frame) &&
		    frame.value.kind != VALUE_NONE;
	if (!good && frame.value.kind == VALUE_NONE)
		declare_skip(reader);
	else if (!declare_end(reader, &frame) && value_is_numeric(frame.value) &&
		 reader->context.version >= 3.5 && !reader->stopped)
		diag_warning(reader->context.diag, where, "no ';' after the value of '%s'",
			     target->name->text);
	Symbol *symbol = assign(reader, target, good ? frame.value : value_none());
	if (symbol) {
		symbol->deprecated = deprecation.deprecated;
		symbol->once = deprecation.once;
		symbol->message = deprecation.message;
	}
}

void declare_directive(Reader *reader, bool local, Location where)
{
	Target target = {.local = local};
	Deprecation deprecation = read_deprecation(reader);
	ArenaMark mark = arena_mark(reader->context.items);
	(void)where;
	if (read_target(reader, &target) && source_take_sign(reader, '=', target.name->text))
		declare(reader, &target, deprecation);
	else
		declare_skip(reader);
	/* A function's body that is open holds trees in this arena. */
	if (reader->function_depth == 0)
		arena_rewind(reader->context.items, mark);
}

void declare_undef(Reader *reader)
{
	Location where = source_here(reader);
	Target target = {.where = where};
	target.name = source_take_name(reader, "an identifier");
	if (target.name && next_is(reader, '[')) {
		if (!read_element(reader, &target)) {
			declare_skip(reader);
			return;
		}
		*target.element = value_none();
	} else if (target.name && !symbols_remove(reader->symbols, target.name)) {
		diag_warning(reader->context.diag, where, "'%s' is not declared",
			     target.name->text);
	}
	source_accept_sign(reader, ';');
}
