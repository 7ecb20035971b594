#include "lang/symbol.h"

#include <assert.h>
#include <stdlib.h>
#include <string.h>

enum { BUCKETS_AT_FIRST = 4096 };

struct SymbolTable {
	Arena *arena;
	Name **buckets;
	unsigned bucket_count; /* a power of two */
	unsigned name_count;
	Symbol **scopes;       /* the first symbol of each scope; [0] is the global one */
	int depth, capacity;
	Symbol *unused;        /* symbols of popped scopes */
};

/* FNV-1a: spellings are short. */
static unsigned hash_text(const char *text, size_t length)
{
	unsigned hash = 2166136261u;
	for (size_t i = 0; i < length; i++)
		hash = (hash ^ (unsigned char)text[i]) * 16777619u;
	return hash;
}

static void intern_words(SymbolTable *table)
{
	for (int word = W_NONE + 1; word < W_COUNT; word++) {
		const char *text = word_text((Word)word);
		symbols_intern(table, text, strlen(text))->word = (Word)word;
	}
}

SymbolTable *symbols_create(Arena *arena)
{
	SymbolTable *table = ARENA_NEW(arena, SymbolTable);
	table->arena = arena;
	table->bucket_count = BUCKETS_AT_FIRST;
	table->buckets = memory_alloc(BUCKETS_AT_FIRST * sizeof(Name *));
	memset(table->buckets, 0, BUCKETS_AT_FIRST * sizeof(Name *));
	table->capacity = 64;
	table->scopes = memory_alloc(64 * sizeof(Symbol *));
	table->scopes[0] = NULL;
	intern_words(table);
	return table;
}

void symbols_destroy(SymbolTable *table)
{
	if (!table)
		return;
	free(table->buckets);
	free(table->scopes);
}

int symbols_depth(const SymbolTable *table)
{
	return table->depth;
}

void symbols_push(SymbolTable *table)
{
	if (++table->depth == table->capacity) {
		table->capacity *= 2;
		table->scopes = memory_resize(table->scopes,
					      (size_t)table->capacity * sizeof(Symbol *));
	}
	table->scopes[table->depth] = NULL;
}

void symbols_pop(SymbolTable *table)
{
	assert(table->depth > 0);
	Symbol *symbol = table->scopes[table->depth--];
	while (symbol) {
		Symbol *next = symbol->next;
		symbol->name->symbol = symbol->outer;
		symbol->next = table->unused;
		table->unused = symbol;
		symbol = next;
	}
}

static void rehash(SymbolTable *table)
{
	unsigned count = table->bucket_count * 2;
	Name **buckets = memory_alloc(count * sizeof(Name *));
	memset(buckets, 0, count * sizeof(Name *));
	for (unsigned i = 0; i < table->bucket_count; i++) {
		for (Name *name = table->buckets[i], *next; name; name = next) {
			Name **bucket = &buckets[name->hash & (count - 1)];
			next = name->next_in_bucket;
			name->next_in_bucket = *bucket;
			*bucket = name;
		}
	}
	free(table->buckets);
	table->buckets = buckets;
	table->bucket_count = count;
}

static Name *find_name(const SymbolTable *table, const char *text, size_t length, unsigned hash)
{
	Name *name = table->buckets[hash & (table->bucket_count - 1)];
	while (name && (name->hash != hash || name->length != length ||
			memcmp(name->text, text, length) != 0))
		name = name->next_in_bucket;
	return name;
}

Name *symbols_intern(SymbolTable *table, const char *text, size_t length)
{
	unsigned hash = hash_text(text, length);
	Name *name = find_name(table, text, length, hash);
	if (name)
		return name;
	if (table->name_count++ >= table->bucket_count)
		rehash(table);
	name = ARENA_NEW(table->arena, Name);
	name->text = arena_strndup(table->arena, text, length);
	name->length = (unsigned)length;
	name->hash = hash;
	Name **bucket = &table->buckets[hash & (table->bucket_count - 1)];
	name->next_in_bucket = *bucket;
	*bucket = name;
	return name;
}

Symbol *symbols_find(SymbolTable *table, const char *text, size_t length)
{
	Name *name = find_name(table, text, length, hash_text(text, length));
	return name ? name->symbol : NULL;
}

static Symbol *add_symbol(SymbolTable *table, Name *name, int depth)
{
	Symbol *symbol = table->unused;
	if (symbol)
		table->unused = symbol->next;
	else
		symbol = ARENA_NEW(table->arena, Symbol);
	*symbol = (Symbol){
		.name = name, .depth = depth, .outer = name->symbol, .next = table->scopes[depth]};
	table->scopes[depth] = symbol;
	name->symbol = symbol;
	return symbol;
}

Symbol *symbols_declare(SymbolTable *table, Name *name, Value value, bool local)
{
	Symbol *symbol = name->symbol;
	if (!symbol || (local && symbol->depth != table->depth))
		symbol = add_symbol(table, name, local ? table->depth : 0);
	*symbol_value(symbol) = value;
	return symbol;
}

Symbol *symbols_refer(SymbolTable *table, Name *name, Value *reference)
{
	Symbol *symbol = name->symbol;
	if (!symbol || symbol->depth != table->depth)
		symbol = add_symbol(table, name, table->depth);
	symbol->reference = reference;
	return symbol;
}

bool symbols_remove(SymbolTable *table, Name *name)
{
	Symbol *symbol = name->symbol;
	if (!symbol)
		return false;
	Symbol **link = &table->scopes[symbol->depth];
	while (*link != symbol)
		link = &(*link)->next;
	*link = symbol->next;
	name->symbol = symbol->outer;
	symbol->next = table->unused;
	table->unused = symbol;
	return true;
}
