/*
 * Identifiers and their values: one global scope and a stack of local ones (a macro call, an
 * included file). Every spelling is interned once as a Name, which knows its reserved word and its
 * innermost symbol, so that a look-up from a scanned token hashes nothing. Names and symbols live
 * in the arena given.
 *
 * As in POV-Ray, `#declare` gives a new value to the innermost symbol of that name wherever it
 * stands and makes a global one when there is none; `#local` does so in the innermost scope only.
 */
#ifndef LANG_SYMBOL_H
#define LANG_SYMBOL_H

#include "base/arena.h"
#include "base/diag.h"
#include "lang/value.h"
#include "lang/word.h"

typedef struct SymbolTable SymbolTable;
typedef struct Symbol Symbol;

typedef struct Name {
	const char *text;
	unsigned length;
	Word word;       /* W_NONE for a spelling that is not reserved */
	Symbol *symbol;  /* the innermost one; NULL when nothing has that name */
	unsigned hash;
	struct Name *next_in_bucket;
} Name;

struct Symbol {
	Name *name;
	Value value;
	Value *reference; /* of a macro's parameter: the caller's variable or array element; or NULL
			   */
	Location declared;
	bool deprecated;     /* `#declare deprecated`: every use warns, with message */
	bool poisoned;       /* its declaration had a reported mistake: uses are silent */
	bool warned;         /* `deprecated once`: the warning was given */
	bool once;
	const char *message; /* or NULL */
	int depth;           /* of its scope */
	Symbol *outer;       /* what it hides */
	Symbol *next;        /* in its scope */
};

SymbolTable *symbols_create(Arena *arena);
void symbols_destroy(SymbolTable *table); /* NULL is allowed */
void symbols_push(SymbolTable *table);
void symbols_pop(SymbolTable *table);     /* never the global scope */
int symbols_depth(const SymbolTable *table); /* 0: only the global scope */

Name *symbols_intern(SymbolTable *table, const char *text, size_t length);
/* NULL when nothing has that name. */
Symbol *symbols_find(SymbolTable *table, const char *name, size_t length);
/* Gives the name a value, over an older one as said above; through a reference to what it stands
 * for. */
Symbol *symbols_declare(SymbolTable *table, Name *name, Value value, bool local);
/* Makes a symbol of the innermost scope that stands for *reference. */
Symbol *symbols_refer(SymbolTable *table, Name *name, Value *reference);
/* Removes the innermost symbol; false when there is none. */
bool symbols_remove(SymbolTable *table, Name *name);

static inline Value *symbol_value(Symbol *symbol)
{
	return symbol->reference ? symbol->reference : &symbol->value;
}

#endif
