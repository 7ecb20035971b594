#include "lang/builtin.h"

#include <ctype.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "lang/string.h"

/* Longest width or precision of a number: more is cut. */
enum { FORMAT_LIMIT = 300 };

static int limited(double x)
{
	return x < -FORMAT_LIMIT ? -FORMAT_LIMIT : x > FORMAT_LIMIT ? FORMAT_LIMIT : (int)x;
}

const char *string_format_float(Arena *arena, double x, double width, double precision)
{
	int w = limited(width), p = precision < 0 ? 6 : limited(precision);
	if (w < 0)
		return arena_printf(arena, "%0*.*f", -w, p, x);
	return arena_printf(arena, "%*.*f", w, p, x);
}

static bool is_continuation(char c)
{
	return ((unsigned char)c & 0xc0) == 0x80;
}

int string_length(const char *text)
{
	int length = 0;
	for (; *text; text++)
		length += !is_continuation(*text);
	return length;
}

/* The byte where character index (from 0) starts, or the end of the text. */
static const char *character_at(const char *text, int index)
{
	for (; *text; text++)
		if (!is_continuation(*text) && index-- == 0)
			return text;
	return text;
}

int string_encode(int code, char out[5])
{
	int n = 0;
	if (code < 0x80) {
		out[n++] = (char)code;
	} else if (code < 0x800) {
		out[n++] = (char)(0xc0 | code >> 6);
		out[n++] = (char)(0x80 | (code & 0x3f));
	} else if (code < 0x10000) {
		out[n++] = (char)(0xe0 | code >> 12);
		out[n++] = (char)(0x80 | (code >> 6 & 0x3f));
		out[n++] = (char)(0x80 | (code & 0x3f));
	} else {
		out[n++] = (char)(0xf0 | (code >> 18 & 7));
		out[n++] = (char)(0x80 | (code >> 12 & 0x3f));
		out[n++] = (char)(0x80 | (code >> 6 & 0x3f));
		out[n++] = (char)(0x80 | (code & 0x3f));
	}
	out[n] = '\0';
	return n;
}

int string_decode(const char *text)
{
	unsigned char first = (unsigned char)text[0];
	int more = first >= 0xf0 ? 3 : first >= 0xe0 ? 2 : first >= 0xc0 ? 1 : 0;
	int code = more == 3 ? first & 7 : more == 2 ? first & 15 : more == 1 ? first & 31 : first;
	for (int i = 1; i <= more && is_continuation(text[i]); i++)
		code = code << 6 | (text[i] & 0x3f);
	return code;
}

Value builtin_asc(const BuiltinCall *call)
{
	return value_float(string_decode(call->args[0].string));
}

Value builtin_chr(const BuiltinCall *call)
{
	double code = call->args[0].number;
	char text[5];
	if (!(code >= 0 && code < 0x110000)) {
		diag_error(call->context->diag, call->where, "'chr' of %g: no such character",
			   code);
		return value_string("");
	}
	string_encode((int)code, text);
	return value_string(arena_strdup(call->context->parse, text));
}

Value builtin_concat(const BuiltinCall *call)
{
	enum { LONGEST = 1 << 26 };
	size_t length = 1;
	for (int i = 0; i < call->count; i++)
		length += strlen(call->args[i].string);
	if (length > LONGEST) {
		diag_error(call->context->diag, call->where,
			   "a string of %zu bytes is too long: at most %d", length - 1,
			   LONGEST - 1);
		return value_string("");
	}
	char *text = arena_alloc(call->context->parse, length), *end = text;
	for (int i = 0; i < call->count; i++) {
		size_t part = strlen(call->args[i].string);
		memcpy(end, call->args[i].string, part);
		end += part;
	}
	return value_string(text);
}

/* datetime(days since 2000 [, strftime's format]), UTC. */
Value builtin_datetime(const BuiltinCall *call)
{
	const char *format = call->count > 1 ? call->args[1].string : "%Y-%m-%d %H:%M:%SZ";
	double seconds = floor(call->args[0].number * 86400 + 0.5) + 946684800.0;
	char text[256];
	struct tm parts;
	time_t moment = (time_t)seconds;
	if (!(fabs(seconds) < 1e15) || !gmtime_r(&moment, &parts)) {
		diag_error(call->context->diag, call->where, "'datetime' of %g is out of range",
			   call->args[0].number);
		return value_string("");
	}
	if (strftime(text, sizeof text, format, &parts) == 0 && *format) {
		diag_error(call->context->diag, call->where,
			   "'datetime' gives nothing, or too long a text");
		return value_string("");
	}
	return value_string(*format ? arena_strdup(call->context->parse, text) : "");
}

Value builtin_str(const BuiltinCall *call)
{
	const Value *a = call->args;
	return value_string(
		string_format_float(call->context->parse, a[0].number, a[1].number, a[2].number));
}

Value builtin_strcmp(const BuiltinCall *call)
{
	int order = strcmp(call->args[0].string, call->args[1].string);
	return value_float((order > 0) - (order < 0));
}

Value builtin_strlen(const BuiltinCall *call)
{
	return value_float(string_length(call->args[0].string));
}

Value builtin_case(const BuiltinCall *call)
{
	char *text = arena_strdup(call->context->parse, call->args[0].string);
	for (char *c = text; *c; c++)
		if (!(*c & 0x80))
			*c = (char)(call->word == W_strupr ? toupper(*c) : tolower(*c));
	return value_string(text);
}

/* substr(text, first character counting from 1, length) */
Value builtin_substr(const BuiltinCall *call)
{
	const char *text = call->args[0].string;
	double first = call->args[1].number, count = call->args[2].number;
	if (!(first >= 0 && count >= 0 && trunc(first) + trunc(count) - 1 <= string_length(text))) {
		diag_error(call->context->diag, call->where, "'substr' reaches outside the string");
		return value_string("");
	}
	if (first < 1)
		return value_string("");
	const char *start = character_at(text, (int)first - 1),
		   *end = character_at(start, (int)count);
	return value_string(arena_strndup(call->context->parse, start, (size_t)(end - start)));
}

Value builtin_val(const BuiltinCall *call)
{
	return value_float(strtod(call->args[0].string, NULL));
}

/* vstr(components, vector, separator, width, precision) */
Value builtin_vstr(const BuiltinCall *call)
{
	const Value *a = call->args, *v = &a[1];
	Arena *arena = call->context->parse;
	int count = limited(a[0].number);
	count = count < 2 ? 2 : count > 5 ? 5 : count;
	const char *text = "";
	for (int i = 0; i < count; i++) {
		double x = v->kind == VALUE_FLOAT ? v->number : v->v[i];
		const char *part = string_format_float(arena, x, a[3].number, a[4].number);
		text = i == 0 ? part : arena_printf(arena, "%s%s%s", text, a[2].string, part);
	}
	return value_string(text);
}
