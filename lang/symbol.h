/*
 * Identifiers and their values: one global scope and a stack of local ones (a macro call, an included file). Looking up goes
 * from the innermost scope outward.
 */
#ifndef LANG_SYMBOL_H
#define LANG_SYMBOL_H

#include "base/arena.h"
#include "base/diag.h"
#include "lang/value.h"

typedef struct SymbolTable SymbolTable;

typedef struct Symbol {
	const char *name;
	Value value;
	struct Symbol *reference; /* a macro's parameter that stands for the caller's variable; or NULL */
	Location declared;
	bool deprecated;          /* `#declare deprecated`: warns once, with message */
	const char *message;
} Symbol;

SymbolTable *symbols_create(Arena *arena);
void symbols_push(SymbolTable *table);
void symbols_pop(SymbolTable *table);
int symbols_depth(const SymbolTable *table);

/* NULL when nothing has that name. References are followed. */
Symbol *symbols_find(SymbolTable *table, const char *name, size_t length);
/* Declares in the innermost (local) or the global scope, over an older value of the same scope. */
Symbol *symbols_declare(SymbolTable *table, const char *name, size_t length, Value value, bool local);
/* Removes the innermost one; false when there is none. */
bool symbols_remove(SymbolTable *table, const char *name, size_t length);

#endif
