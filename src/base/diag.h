/*
 * Diagnostics: every message of the program goes through one sink. A scene error names file, line
 * and column, shows the line with a caret, and the chain of macros and includes that led there:
 *
 *     scene.pov:12:9: error: expected a vector, found a string
 *        12 | sphere { "no", 1 }
 *           |          ^
 *     in macro 'Ball', called at scene.pov:40:1
 *     included from main.pov:3:1
 *
 * Three roads: a mistake in a scene goes to diag_error with its location, and the parse goes on; a
 * failure of the world (file, library) goes to diag_fail and a returned status; a programmer's
 * mistake is an assertion. The sink is safe to call from several threads.
 */
#ifndef BASE_DIAG_H
#define BASE_DIAG_H

#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

typedef struct Diag Diag;

/* How a token came to be read: by a macro call or an include, at a place, which itself was reached
 * by another. */
typedef struct Expansion Expansion;

/* A place in a scene text. source 0 means no place (command line, file system). */
typedef struct Location {
	uint32_t source;      /* from diag_add_source */
	uint32_t offset;      /* byte in that source */
	const Expansion *via; /* NULL at the top of the main file */
} Location;

struct Expansion {
	Location at;
	const char *name; /* macro's name, or NULL for an include */
};

/* Line and column count from 1; columns count bytes. */
typedef struct Position {
	const char *file;
	int line, column;
} Position;

Diag *
diag_create(FILE *out); /* messages go to out (stderr); NULL keeps them silent, still counted */
void diag_destroy(Diag *diag);
/* Registers a text that locations can point into; name and text must outlive the sink. Returns its
 * number (from 1). */
uint32_t diag_add_source(Diag *diag, const char *name, const char *text, size_t length);
Position diag_position(const Diag *diag, Location at);

void diag_error(Diag *diag, Location at, const char *format, ...)
	__attribute__((format(printf, 3, 4)));
/* The same warning at the same place, as in a loop, is printed once. */
void diag_warning(Diag *diag, Location at, const char *format, ...)
	__attribute__((format(printf, 3, 4)));
/* A scene's own words (#debug, #warning text), printed as they are. */
void diag_text(Diag *diag, const char *text);
/* A failure of the world; counts as an error. */
void diag_fail(Diag *diag, const char *format, ...) __attribute__((format(printf, 2, 3)));
/* Information for the user, not counted; silent after diag_set_quiet. */
void diag_note(Diag *diag, const char *format, ...) __attribute__((format(printf, 2, 3)));
void diag_set_quiet(Diag *diag, bool quiet);    /* no notes and no scene text */
void diag_set_warnings(Diag *diag, bool shown); /* +WL0 turns them off */

int diag_errors(const Diag *diag);
/* True once so many errors were reported that going on helps nobody (20). */
bool diag_is_full(const Diag *diag);

#endif
