/*
 * Tokens: what the scanner makes of a file, once. Directives replay ranges of the array (a branch,
 * a loop's body, a macro) by moving an index. Everything that can be decided from the text alone
 * is: numbers are numbers, names are interned, strings have their escapes resolved, and each
 * directive knows where its next branch and its #end are (parser/link.h).
 */
#ifndef PARSER_TOKEN_H
#define PARSER_TOKEN_H

#include <stdint.h>

#include "base/arena.h"
#include "base/diag.h"
#include "lang/symbol.h"

typedef enum TokenKind {
	TOKEN_NUMBER,
	TOKEN_STRING,
	TOKEN_NAME,
	TOKEN_SIGN, /* punctuation: code is the grammar's token */
	TOKEN_DIRECTIVE, /* code is its Word, W_NONE for an unknown one */
	/* What cannot stand in a scene; an error only where it is read, as skipped branches may
	   hold anything. */
	TOKEN_BAD_CHARACTER,
	TOKEN_OPEN_STRING,
	TOKEN_OPEN_COMMENT,
} TokenKind;

enum { LINK_NONE = 0xffffffffu };

/* Of a directive: indices into the file's tokens, LINK_NONE where there is no such token. */
typedef struct Link {
	uint32_t next; /* #if, #elseif, #case...: the next branch or #end; #else, #end, #break: the
			  directive it belongs to */
	uint32_t end;  /* the matching #end */
} Link;

typedef struct Token {
	uint8_t kind;
	bool in_switch;  /* of #else: it belongs to a #switch */
	uint16_t code;   /* SIGN, DIRECTIVE, BAD_CHARACTER */
	uint32_t offset; /* byte in the file's text */
	union {
		double number;
		const char *string;
		Name *name;
		Link link;
	};
} Token;

typedef struct TokenFile {
	const char *path;
	char *text;
	size_t length;
	uint32_t source; /* in the diagnostics */
	Token *tokens;
	uint32_t count;
	struct TokenFile *next;
} TokenFile;

/* Fills in file->tokens from file->text, which two NUL bytes end. Strings go to the arena. Reports
 * escapes it does not know, via the expansion that reads the file. */
void scanner_scan(TokenFile *file, SymbolTable *symbols, Arena *arena, Diag *diag,
		  const Expansion *via);

#endif
