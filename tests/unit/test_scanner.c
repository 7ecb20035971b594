/* From bytes to tokens: numbers, strings, comments, and what ties directives together. */
#include <stdlib.h>

#include "check.h"
#include "parser/grammar.h"
#include "parser/link.h"
#include "parser/number.h"
#include "parser/string_literal.h"
#include "parser/token.h"

typedef struct Scan {
	Arena *arena;
	SymbolTable *symbols;
	Diag *diag;
	TokenFile file;
	char *text;
} Scan;

static void scan(Scan *out, const char *text)
{
	*out = (Scan){.arena = arena_create(), .diag = diag_create(NULL)};
	out->symbols = symbols_create(out->arena);
	out->text = memory_alloc(strlen(text) + 2);
	memcpy(out->text, text, strlen(text) + 1);
	out->text[strlen(text) + 1] = 0;
	out->file = (TokenFile){.path = "test", .text = out->text, .length = strlen(text)};
	scanner_scan(&out->file, out->symbols, out->arena, out->diag, NULL);
	link_directives(&out->file);
}

static void drop(Scan *scan)
{
	free(scan->file.tokens);
	free(scan->text);
	symbols_destroy(scan->symbols);
	diag_destroy(scan->diag);
	arena_destroy(scan->arena);
}

static void test_numbers(void)
{
	static const char *const texts[] = {"0",
					    "1",
					    "12.5",
					    ".25",
					    "3.",
					    "1e3",
					    "1.5e-7",
					    "0.1",
					    "123456789012345678901",
					    "0.000000000000000000000000001",
					    "3.14159265358979323846",
					    "9007199254740993"};
	for (size_t i = 0; i < sizeof texts / sizeof *texts; i++)
		CHECK(number_parse(texts[i], strlen(texts[i])) == strtod(texts[i], NULL));
	CHECK(number_parse("12<", 2) == 12);
}

static void test_strings(void)
{
	Arena *arena = arena_create();
	long unknown;
	CHECK_STRING(string_literal_parse(arena, "a\\\"b\\\\", 6, &unknown), "a\"b\\");
	CHECK_STRING(string_literal_parse(arena, "\\u00e9\\n", 8, &unknown), "\xc3\xa9\n");
	CHECK_STRING(string_literal_parse(arena, "caf\xe9", 4, &unknown), "caf\xc3\xa9");
	CHECK_STRING(string_literal_parse(arena, "\xe2\x82\xac", 3, &unknown), "\xe2\x82\xac");
	CHECK(unknown == -1);
	CHECK_STRING(string_literal_parse(arena, "c:\\data", 7, &unknown), "c:\\data");
	CHECK(unknown == 2);
	arena_destroy(arena);
}

static void test_tokens(void)
{
	Scan s;
	scan(&s, "sphere{<-1,.5>}// c\r\n/* a /* b */ c */ x!=y # declare Q \"s\"\x1a junk");
	static const int kinds[] = {TOKEN_NAME,      TOKEN_SIGN, TOKEN_SIGN,   TOKEN_SIGN,
				    TOKEN_NUMBER,    TOKEN_SIGN, TOKEN_NUMBER, TOKEN_SIGN,
				    TOKEN_SIGN,      TOKEN_NAME, TOKEN_SIGN,   TOKEN_NAME,
				    TOKEN_DIRECTIVE, TOKEN_NAME, TOKEN_STRING};
	CHECK(s.file.count == sizeof kinds / sizeof *kinds);
	for (size_t i = 0; i < sizeof kinds / sizeof *kinds && i < s.file.count; i++)
		CHECK(s.file.tokens[i].kind == kinds[i]);
	CHECK(s.file.tokens[0].name->word == W_sphere);
	CHECK(s.file.tokens[6].number == 0.5 && s.file.tokens[6].offset == 11);
	CHECK(s.file.tokens[10].code == NOT_EQUAL);
	CHECK(s.file.tokens[12].code == W_declare);
	CHECK(s.file.tokens[9].name->word == W_x);
	drop(&s);
}

static void test_bad_tokens(void)
{
	Scan s;
	scan(&s, "@ \"open");
	CHECK(s.file.count == 2 && s.file.tokens[0].kind == TOKEN_BAD_CHARACTER &&
	      s.file.tokens[1].kind == TOKEN_OPEN_STRING);
	drop(&s);
	scan(&s, "1 /* open");
	CHECK(s.file.count == 2 && s.file.tokens[1].kind == TOKEN_OPEN_COMMENT &&
	      s.file.tokens[1].offset == 2);
	drop(&s);
	CHECK(sizeof(Token) == 16);
}

static void test_links(void)
{
	Scan s;
	/*       0   1   2       3     4     5      6    7    8 */
	scan(&s, "#if A #elseif #else #while #break #end #end #end #if");
	const Token *t = s.file.tokens;
	CHECK(s.file.count == 10);
	CHECK(t[0].link.next == 2 && t[0].link.end == 7);
	CHECK(t[2].link.next == 3 && t[2].link.end == 7);
	CHECK(t[3].link.next == 7 && !t[3].in_switch);
	CHECK(t[5].link.next == 4);
	CHECK(t[6].link.next == 4 && t[7].link.next == 0);
	CHECK(t[8].link.next == LINK_NONE);
	CHECK(t[9].link.end == LINK_NONE);
	drop(&s);
}

static void test_symbols(void)
{
	Arena *arena = arena_create();
	SymbolTable *table = symbols_create(arena);
	Name *a = symbols_intern(table, "a", 1);
	CHECK(a == symbols_intern(table, "ab", 1) && symbols_find(table, "a", 1) == NULL);
	symbols_declare(table, a, value_float(1), false);
	symbols_push(table);
	symbols_declare(table, a, value_float(2), false);
	CHECK(a->symbol->value.number == 2 && a->symbol->depth == 0);
	symbols_declare(table, a, value_float(3), true);
	CHECK(a->symbol->value.number == 3 && a->symbol->depth == 1);
	Value caller = value_float(7);
	symbols_push(table);
	symbols_refer(table, a, &caller);
	symbols_declare(table, a, value_float(8), false);
	CHECK(caller.number == 8);
	symbols_pop(table);
	CHECK(symbols_remove(table, a) && a->symbol->value.number == 2);
	symbols_pop(table);
	CHECK(symbols_depth(table) == 0 && symbols_remove(table, a) && !symbols_remove(table, a));
	for (int i = 0; i < 20000; i++) {
		char text[16];
		int length = snprintf(text, sizeof text, "n%d", i);
		symbols_declare(table, symbols_intern(table, text, (size_t)length), value_float(i),
				false);
	}
	CHECK(symbols_find(table, "n19999", 6)->value.number == 19999);
	symbols_destroy(table);
	arena_destroy(arena);
}

int main(void)
{
	test_numbers();
	test_strings();
	test_tokens();
	test_bad_tokens();
	test_links();
	test_symbols();
	return CHECK_RESULT();
}
