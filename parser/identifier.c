/* Identifiers with values: their token for the grammar, elements of arrays. */
#include <string.h>

#include "lang/array.h"
#include "lang/word.h"
#include "parser/grammar.h"
#include "parser/state.h"

/* What the most subscripts of an array of arrays come to. */
enum { SUBSCRIPT_LIMIT = 8 };

static bool next_is(Reader *reader, int sign)
{
	const Token *next = source_peek(reader, 0);
	return next && next->kind == TOKEN_SIGN && next->code == sign;
}

int identifier_token(Reader *reader, Value value, Semantic *out)
{
	out->value = value;
	switch (value.kind) {
	case VALUE_FLOAT:
	case VALUE_VECTOR:
	case VALUE_COLOR:
	case VALUE_STRING:
	case VALUE_EXPRESSION:
		return VALUE;
	case VALUE_FUNCTION: case VALUE_VECTOR_FUNCTION: case VALUE_SPLINE:
		return next_is(reader, '(') ? CALLABLE : ITEM;
	default:
		return ITEM;
	}
}

int identifier_subscripts(Reader *reader, double subscripts[8])
{
	int count = 0;
	while (source_accept_sign(reader, '[')) {
		Frame frame;
		Location where = source_here(reader);
		if (!frame_parse(reader, S_SUBSCRIPT, FRAME_RUNS_ON, &frame))
			return -1;
		if (!value_is_numeric(frame.value) || count == SUBSCRIPT_LIMIT) {
			diag_error(reader->context.diag, where,
				   count == SUBSCRIPT_LIMIT ? "too many subscripts"
							    : "a subscript must be a float");
			return -1;
		}
		subscripts[count++] = value_to_float(frame.value);
	}
	return count;
}

void identifier_undeclared(Reader *reader, const Name *name, Location where)
{
	Diag *diag = reader->context.diag;
	bool cognac = reader->context.cognac;
	Word word = word_find(name->text, strlen(name->text)), guess;
	if (word != W_NONE && word_class(word) == WORD_EXTENSION && !cognac)
		diag_error(diag, where,
			   "'%s' is not declared; it is a word of the extension, which '#version "
			   "unofficial cognac 1.0;' turns on",
			   name->text);
	else if ((guess = word_guess(name->text, cognac)) != W_NONE)
		diag_error(diag, where, "'%s' is not declared; is '%s' meant?", name->text,
			   word_text(guess));
	else
		diag_error(diag, where, "'%s' is not declared", name->text);
}

Value *identifier_resolve(Reader *reader, Name *name, Location where, bool report)
{
	double subscripts[SUBSCRIPT_LIMIT];
	Symbol *symbol = name->symbol;
	Value *value = symbol ? symbol_value(symbol) : NULL;
	if (!value) {
		if (report)
			identifier_undeclared(reader, name, where);
		lexer_skip_group(reader, '[', ']');
		return NULL;
	}
	if (value->kind != VALUE_ARRAY || !next_is(reader, '['))
		return value;
	Array *array = value->array;
	int count = identifier_subscripts(reader, subscripts);
	return count < 0 ? NULL : array_element(&reader->context, array, subscripts, count, where);
}
