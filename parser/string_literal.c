#include "parser/string_literal.h"

#include <stdlib.h>
#include <string.h>

/* Appends the code point in UTF-8; returns the place behind it. */
static char *put_utf8(char *out, unsigned code)
{
	if (code < 0x80) {
		*out++ = (char)code;
	} else if (code < 0x800) {
		*out++ = (char)(0xc0 | code >> 6);
		*out++ = (char)(0x80 | (code & 0x3f));
	} else {
		*out++ = (char)(0xe0 | code >> 12);
		*out++ = (char)(0x80 | (code >> 6 & 0x3f));
		*out++ = (char)(0x80 | (code & 0x3f));
	}
	return out;
}

/* Bytes of the well-formed UTF-8 sequence at text, 0 when there is none. */
static size_t utf8_length(const unsigned char *text, size_t left)
{
	size_t length = text[0] < 0x80                      ? 1
			: text[0] >= 0xc2 && text[0] < 0xe0 ? 2
			: text[0] >= 0xe0 && text[0] < 0xf0 ? 3
			: text[0] >= 0xf0 && text[0] < 0xf5 ? 4
							    : 0;
	if (length > left)
		return 0;
	for (size_t i = 1; i < length; i++)
		if ((text[i] & 0xc0) != 0x80)
			return 0;
	return length;
}

/* The code point of a one-letter escape, or -1. */
static int simple_escape(char letter)
{
	static const char letters[] = "abfnrtv0\\\"'", meanings[] = "\a\b\f\n\r\t\v\0\\\"'";
	const char *at = letter ? strchr(letters, letter) : NULL;
	return at ? meanings[at - letters] : -1;
}

/* \uXXXX after the u; -1 when four hexadecimal digits do not follow. */
static long unicode_escape(const char *text, size_t left)
{
	char digits[5] = {0}, *end;
	if (left < 4)
		return -1;
	memcpy(digits, text, 4);
	long code = strtol(digits, &end, 16);
	return end == digits + 4 ? code : -1;
}

const char *string_literal_parse(Arena *arena, const char *text, size_t length, long *unknown)
{
	/* A byte of Latin-1 becomes two. */
	char *start = arena_alloc(arena, 2 * length + 1), *out = start;
	*unknown = -1;
	for (size_t i = 0; i < length;) {
		size_t valid = utf8_length((const unsigned char *)text + i, length - i);
		if (text[i] != '\\' || i + 1 == length) {
			if (valid)
				out = (char *)memcpy(out, text + i, valid) + valid;
			else
				out = put_utf8(out, (unsigned char)text[i]);
			i += valid ? valid : 1;
			continue;
		}
		int code = simple_escape(text[i + 1]);
		long wide = text[i + 1] == 'u' ? unicode_escape(text + i + 2, length - i - 2) : -1;
		if (code >= 0 || wide >= 0) {
			out = put_utf8(out, (unsigned)(code >= 0 ? code : wide));
			i += code >= 0 ? 2 : 6;
		} else {
			*unknown = *unknown < 0 ? (long)i : *unknown;
			*out++ = text[i++];
		}
	}
	*out = 0;
	return start;
}
