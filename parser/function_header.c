/* `function (a, b) {`: what stands before the body decides how the body is read. */
#include "lang/function.h"
#include "parser/grammar.h"
#include "parser/state.h"

/* What POV-Ray allows. */
enum { PARAMETER_LIMIT = 56 };

static bool is_sign(const Token *token, int sign)
{
	return token && token->kind == TOKEN_SIGN && token->code == sign;
}

/* ( name, name ... ): their number, 0 after a report. */
static int read_parameters(Reader *reader, const char **parameters)
{
	int count = 0;
	if (!source_accept_sign(reader, '('))
		return 0;
	while (!source_accept_sign(reader, ')')) {
		Location where = source_here(reader);
		Name *name = source_take_name(reader, "a parameter's name");
		if (!name)
			return 0;
		if (count == PARAMETER_LIMIT) {
			diag_error(reader->context.diag, where,
				   "a function has at most %d parameters", (int)PARAMETER_LIMIT);
			return 0;
		}
		parameters[count++] = name->text;
		source_accept_sign(reader, ',');
	}
	return count;
}

static bool body_is_item(Reader *reader)
{
	const Token *first = source_peek(reader, 1);
	if (!first || first->kind != TOKEN_NAME || first->name->symbol)
		return false;
	Word word = first->name->word;
	return word == W_pigment || word == W_pattern || word == W_transform || word == W_spline;
}

int function_body_begin(Reader *reader, const char **parameters, int count)
{
	if (is_sign(source_peek(reader, 0), '{') && body_is_item(reader))
		return FUNCTION_ITEM;
	const char **kept = arena_copy(reader->context.parse, parameters,
				       (size_t)count * sizeof *parameters);
	function_open(&reader->context, kept, count);
	reader->function_depth++;
	return FUNCTION;
}

int function_header(Reader *reader)
{
	const char *parameters[PARAMETER_LIMIT];
	if (!is_sign(source_peek(reader, 0), '(') && !is_sign(source_peek(reader, 0), '{')) {
		reader->frame->sized_function = true;
		return FUNCTION_SIZED;
	}
	int count = read_parameters(reader, parameters);
	return function_body_begin(reader, parameters, count);
}

int function_sum(Reader *reader, Word word, Semantic *value, Location where)
{
	value->word = word;
	source_take_sign(reader, '(', word_text(word));
	Name *name = source_take_name(reader, "the name that counts");
	source_take_sign(reader, ',', "the name that counts");
	function_loop_open(&reader->context, name ? name->text : "", where);
	return SUM;
}
