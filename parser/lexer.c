/*
 * From raw tokens to the grammar's: names become words or values here, in the moment they are read.
 */
#include <string.h>

#include "lang/function.h"
#include "parser/grammar.h"
#include "parser/state.h"

static int word_token(Reader *reader, Word word, Semantic *value)
{
	value->word = word;
	switch (word) {
	case W_texture: return TEXTURE;
	case W_array: return ARRAY;
	case W_xyz: return XYZ;
	case W_function: return function_header(reader);
	case W_internal: return reader->function_depth > 0 ? INTERNAL : WORD;
	default: return WORD;
	}
}

/* defined(NAME) needs a name that may stand for nothing. */
static int defined_token(Reader *reader, Semantic *value)
{
	Location where = source_here(reader);
	value->value = value_float(0);
	if (!source_take_sign(reader, '(', "'defined'"))
		return VALUE;
	Name *name = source_take_name(reader, "an identifier");
	if (name) {
		const Value *found = identifier_resolve(reader, name, where, false);
		value->value = value_float(found && found->kind != VALUE_NONE);
	}
	source_take_sign(reader, ')', "the identifier");
	return VALUE;
}

/* No parenthesis follows. */
static bool stands_alone(Reader *reader)
{
	const Token *next = source_peek(reader, 0);
	return !next || next->kind != TOKEN_SIGN || next->code != '(';
}

static int call_token(Reader *reader, Word word, Semantic *value, Location where)
{
	value->word = word;
	if (stands_alone(reader)) /* julia_fractal's sqr, exp... */
		return WORD;
	switch (word) {
	case W_defined: return defined_token(reader, value);
	case W_trace: return TRACE;
	case W_sum: case W_prod: return function_sum(reader, word, value, where);
	default: return CALL;
	}
}

/* `filter` and `transmit` are colour parts behind a colour and an item's words elsewhere
 * (image_map), `alpha` is what filter once was called; `srgb` alone is a word after gamma. */
static int color_token(Reader *reader, Word word, Semantic *value, Location where)
{
	const Frame *frame = reader->frame;
	bool after_gamma = frame->last_word == W_gamma || frame->last_word == W_assumed_gamma;
	value->word = word;
	switch (word) {
	case W_alpha:
		diag_warning(reader->context.diag, where, "'alpha' is now called 'filter'");
		value->word = W_filter;
		/* fallthrough */
	case W_filter: case W_transmit:
		return !frame->color ? WORD : frame->complete ? PART : FIRST_PART;
	case W_red: case W_green: case W_blue:
		return frame->color && frame->complete ? PART : FIRST_PART;
	case W_srgb:
		return after_gamma ? WORD : COLOR;
	default:
		return COLOR;
	}
}

static int reserved_token(Reader *reader, Word word, Semantic *value, Location where)
{
	switch (word_class(word)) {
	case WORD_PLAIN: case WORD_EXTENSION:
		return word_token(reader, word, value);
	case WORD_FUNCTION:
		return call_token(reader, word, value, where);
	case WORD_CONSTANT:
		value->value = expression_constant(&reader->context, word, where);
		return VALUE;
	case WORD_COLOR:
		return color_token(reader, word, value, where);
	case WORD_DIRECTIVE:
		break;
	}
	return INVALID;
}

/* A value that lets the grammar go on after a reported mistake. */
static int poison(Reader *reader, Semantic *value)
{
	reader->poisoned = true;
	if (reader->frame)
		reader->frame->failed = true;
	value->value = value_float(0);
	return VALUE;
}

void lexer_skip_group(Reader *reader, int open, int close)
{
	if (source_accept_sign(reader, open))
		lexer_skip_rest(reader, open, close);
}

void lexer_skip_rest(Reader *reader, int open, int close)
{
	const Token *token;
	int depth = 1;
	while (depth > 0 && (token = source_peek(reader, 0))) {
		int code = token->kind == TOKEN_SIGN ? token->code : 0;
		depth += (code == open) - (code == close);
		source_top(reader)->position++;
	}
}

static int undeclared(Reader *reader, const Name *name, Semantic *value, Location where)
{
	if (!reader->frame || !reader->frame->recovering)
		identifier_undeclared(reader, name, where);
	lexer_skip_group(reader, '[', ']');
	lexer_skip_group(reader, '(', ')');
	lexer_skip_group(reader, '{', '}');
	return poison(reader, value);
}

static void warn_deprecated(Reader *reader, Symbol *symbol, Location where)
{
	if (symbol->once && symbol->warned)
		return;
	symbol->warned = true;
	if (symbol->message)
		diag_warning(reader->context.diag, where, "%s", symbol->message);
	else
		diag_warning(reader->context.diag, where, "'%s' is deprecated", symbol->name->text);
}

/* The token of an identifier; 0 when it was a macro, which is now being read. */
static int symbol_token(Reader *reader, Name *name, Semantic *value, Location where)
{
	Symbol *symbol = name->symbol;
	Value *found = symbol_value(symbol);
	if (symbol->deprecated)
		warn_deprecated(reader, symbol, where);
	if (found->kind == VALUE_FLOAT) {
		reader->target = found;
		value->value = *found;
		return VALUE;
	}
	if (found->kind == VALUE_MACRO) {
		if (stands_alone(reader)) {
			diag_error(reader->context.diag, where,
				   "macro '%s' is called without parentheses", name->text);
			return poison(reader, value);
		}
		return macro_call(reader, found->macro, where) ? 0 : poison(reader, value);
	}
	if (found->kind == VALUE_ARRAY)
		found = identifier_resolve(reader, name, where, true);
	reader->target = found;
	if (!found || found->kind == VALUE_NONE) {
		if (found && !symbol->poisoned)
			diag_error(reader->context.diag, where, "'%s' has no value", name->text);
		return poison(reader, value);
	}
	return identifier_token(reader, *found, value);
}

/* 0 for a macro call. */
static int name_token(Reader *reader, Name *name, Semantic *value, Location where)
{
	if (reader->function_depth > 0) {
		int argument = function_argument(&reader->context, name->text, name->length);
		if (argument >= 0) {
			value->value = function_argument_value(&reader->context, argument);
			return VALUE;
		}
	}
	if (name->symbol) {
		reader->last_name = name;
		return symbol_token(reader, name, value, where);
	}
	if (name->word != W_NONE &&
	    (word_class(name->word) != WORD_EXTENSION || reader->context.cognac))
		return reserved_token(reader, name->word, value, where);
	return undeclared(reader, name, value, where);
}

/* `< 1, -2, 3 >` of numbers alone, after the `<`: most of a mesh. The tokens it takes, 0 when it is
 * something else. */
static uint32_t literal_vector(const Token *token, const Token *end, Value *out)
{
	const Token *at = token;
	out->kind = VALUE_VECTOR;
	for (out->size = 0; out->size < 5;) {
		double sign = 1;
		if (at < end && at->kind == TOKEN_SIGN && at->code == '-') {
			sign = -1;
			at++;
		}
		if (end - at < 2 || at[0].kind != TOKEN_NUMBER || at[1].kind != TOKEN_SIGN)
			return 0;
		out->v[out->size++] = sign * at[0].number;
		at += 2;
		if (at[-1].code == '>')
			return out->size >= 2 ? (uint32_t)(at - token) : 0;
		if (at[-1].code != ',')
			return 0;
	}
	return 0;
}

static int sign_token(Reader *reader, const Token *token, Semantic *value)
{
	Source *source = source_top(reader);
	const Token *next = token + 1, *end = source->file->tokens + source->end;
	if (token->code == '<' && !(reader->frame->complete && reader->frame->parentheses > 0)) {
		uint32_t taken = literal_vector(next, end, &value->value);
		source->position += taken;
		return taken ? VALUE : '<';
	}
	if (token->code == '{' && reader->frame->sized_function) {
		/* The grammar sees a function's header, then the brace again. */
		reader->frame->sized_function = false;
		source->position--;
		return function_body_begin(reader, NULL, 0);
	}
	if (token->code == '.' && next < end && next->kind == TOKEN_NAME) {
		source->position++;
		value->text = next->name->text;
		return MEMBER;
	}
	return token->code == '&' && reader->function_depth > 0 ? TIGHT_AND : token->code;
}

static int bad_token(Reader *reader, const Token *token, Semantic *value, Location where)
{
	Diag *diag = reader->context.diag;
	if (token->kind == TOKEN_OPEN_STRING)
		diag_error(diag, where, "the string that begins here has no end");
	else if (token->kind == TOKEN_OPEN_COMMENT)
		diag_error(diag, where, "the comment that begins here has no end");
	else if (token->code > 32 && token->code < 127)
		diag_error(diag, where, "the character '%c' has no meaning here", token->code);
	else
		diag_error(diag, where,
			   "a character of code %d has no meaning outside strings and comments",
			   token->code);
	poison(reader, value);
	return token->kind == TOKEN_BAD_CHARACTER ? 0 : READER_YYEOF;
}

/* Whether the first branch of #if, #while... begins with what can go on with a complete value: an
 * operator, or a texture's next layer. */
static bool branch_goes_on(Reader *reader)
{
	uint32_t at = 1;
	int depth = 0;
	const Token *token;
	do {
		if (!(token = source_peek(reader, at++)))
			return false;
		int code = token->kind == TOKEN_SIGN ? token->code : 0;
		depth += (code == '(') - (code == ')');
	} while (depth > 0);
	if (!(token = source_peek(reader, at)))
		return false;
	if (token->kind == TOKEN_NAME)
		return token->name->word == W_texture;
	return token->kind == TOKEN_SIGN && strchr("+-*/.", token->code);
}

/* Whether a complete value that the frame reads ends before this token, which would be read with
 * the value not yet given to its name. */
static bool frame_ends_before(Reader *reader, const Token *token)
{
	const Frame *frame = reader->frame;
	if (frame->ends == FRAME_RUNS_ON || !frame->complete || frame->depth > 0)
		return false;
	if (token->kind == TOKEN_NAME)
		return token->name->symbol &&
		       symbol_value(token->name->symbol)->kind == VALUE_MACRO;
	if (token->kind != TOKEN_DIRECTIVE)
		return false;
	switch ((Word)token->code) {
	case W_else: case W_elseif: case W_end: case W_break: case W_case: case W_range:
		return frame->ends == FRAME_ENDS_AT_DIRECTIVE;
	case W_if: case W_ifdef: case W_ifndef: case W_while: case W_for: case W_switch:
		return frame->ends == FRAME_ENDS_AT_DIRECTIVE || !branch_goes_on(reader);
	default:
		return true;
	}
}

/* At the end of a source: leaves it, unless a complete value ends with it or nothing is left. */
static bool leave_source(Reader *reader)
{
	const Frame *frame = reader->frame;
	if (reader->source_count == 1)
		return false;
	if (frame->ends != FRAME_RUNS_ON && frame->complete && frame->depth == 0 &&
	    reader->source_count == frame->source_depth)
		return false;
	source_pop(reader);
	return true;
}

/* One raw token; 0 when it was a directive or a macro call, or is to be left out. */
static int raw_token(Reader *reader, const Token *token, Semantic *value, Location where)
{
	switch ((TokenKind)token->kind) {
	case TOKEN_NUMBER:
		value->value = value_float(token->number);
		return VALUE;
	case TOKEN_STRING:
		value->value = value_string(token->string);
		return VALUE;
	case TOKEN_NAME:
		return name_token(reader, token->name, value, where);
	case TOKEN_SIGN:
		return sign_token(reader, token, value);
	case TOKEN_DIRECTIVE:
		directive_run(reader, token, where);
		return 0;
	default:
		break;
	}
	int kind = bad_token(reader, token, value, where);
	return kind == READER_YYEOF ? (reader->stopped = true, 0) : 0;
}

static bool interrupted(const Reader *reader)
{
	const volatile sig_atomic_t *flag = reader->options->interrupted;
	return flag && *flag;
}

static int take_ahead(Reader *reader, Semantic *value, Location *where)
{
	Ahead ahead = reader->ahead;
	reader->has_ahead = false;
	*where = ahead.where;
	*value = ahead.value;
	if (ahead.name && ahead.name->symbol &&
	    symbol_value(ahead.name->symbol)->kind == VALUE_FLOAT) {
		reader->last_name = ahead.name;
		reader->target = symbol_value(ahead.name->symbol);
		value->value = *reader->target;
		return VALUE;
	}
	return ahead.kind;
}

int lexer_fetch(Reader *reader, Semantic *value, Location *where)
{
	reader->poisoned = false;
	reader->last_name = NULL;
	if (reader->has_ahead)
		return take_ahead(reader, value, where);
	while (!reader->stopped && !diag_is_full(reader->context.diag) && !interrupted(reader)) {
		Source *source = &reader->sources[reader->source_count - 1];
		if (source->position >= source->end) {
			*where = source_here(reader);
			if (!leave_source(reader))
				return READER_YYEOF;
			continue;
		}
		const Token *token = &source->file->tokens[source->position];
		*where = (Location){source->file->source, token->offset, source->via};
		if (frame_ends_before(reader, token))
			return READER_YYEOF;
		source->position++;
		int kind = raw_token(reader, token, value, *where);
		if (kind || reader->has_ahead)
			return kind ? kind : take_ahead(reader, value, where);
	}
	reader->stopped = true;
	return READER_YYEOF;
}

void lexer_give_back(Reader *reader, int kind, const Semantic *value, Location where)
{
	if (kind == READER_YYEMPTY || kind == READER_YYEOF)
		return;
	reader->ahead = (Ahead){kind, *value, where, reader->last_name};
	reader->has_ahead = true;
}

static void push_brace(Reader *reader, Location where)
{
	if (reader->brace_count == reader->brace_capacity) {
		reader->brace_capacity = reader->brace_capacity ? 2 * reader->brace_capacity : 32;
		reader->braces = memory_resize(reader->braces,
					       (size_t)reader->brace_capacity * sizeof(Location));
	}
	reader->braces[reader->brace_count++] = where;
}

/* Keeps the frame's account of nesting and of what the last token was. */
static void note_token(Reader *reader, Frame *frame, int kind, const Semantic *value,
		       Location where)
{
	frame->last_word = W_NONE;
	frame->complete = false;
	switch (kind) {
	case '{':
		push_brace(reader, where);
		frame->color = false;
		frame->depth++;
		break;
	case '[':
		frame->color = false;
		frame->depth++;
		break;
	case '(':
		frame->depth++;
		frame->parentheses++;
		break;
	case '}':
		reader->brace_count -= reader->brace_count > frame->brace_count;
		/* fall through */
	case ']':
		frame->color = false;
		frame->depth--;
		frame->complete = true;
		break;
	case ')':
		frame->depth--;
		frame->parentheses--;
		frame->complete = true;
		break;
	case VALUE:
		frame->color = value->value.kind == VALUE_COLOR ||
			       (frame->color && value->value.kind != VALUE_STRING);
		frame->complete = true;
		break;
	case '>': case ITEM: case CALLABLE: case MEMBER:
		frame->complete = true;
		break;
	case COLOR: case FIRST_PART:
		frame->color = true;
		break;
	case WORD: case TEXTURE:
		frame->last_word = value->word;
		frame->color = false;
		break;
	default:
		break;
	}
}

/* After a mistake: on to the brace that closes the block. */
static int skip_block(Reader *reader, Frame *frame, Semantic *value, Location *where)
{
	for (;;) {
		int kind = lexer_fetch(reader, value, where);
		if (kind == READER_YYEOF)
			return kind;
		if (kind == '}' && frame->skip_depth-- == 0) {
			frame->recovering = false;
			return kind;
		}
		frame->skip_depth += kind == '{';
	}
}

int reader_yylex(Semantic *value, Location *where, Reader *reader)
{
	Frame *frame = reader->frame;
	int kind;
	if (frame->start) {
		kind = frame->start;
		frame->start = 0;
		*where = source_here(reader);
		return kind;
	}
	if (frame->recovering)
		kind = skip_block(reader, frame, value, where);
	else
		kind = lexer_fetch(reader, value, where);
	note_token(reader, frame, kind, value, *where);
	reader->last_kind = kind;
	reader->last_value = *value;
	return kind;
}
