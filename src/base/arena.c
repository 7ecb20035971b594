#include "base/arena.h"

#include <stdarg.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <unistd.h>

enum { CACHE_LINE = 64, LARGE_PAGE = 1 << 21 };
enum { ALIGNMENT = 16, FIRST_BLOCK = 1 << 16, LARGEST_BLOCK = 1 << 24 };

typedef struct Block Block;
struct Block {
	Block *previous;
	size_t size, used; /* of data */
	_Alignas(ALIGNMENT) char data[];
};

struct Arena {
	Block *last;
	size_t bytes;
};

static void *or_die(void *memory)
{
	if (!memory) {
		fputs("cognac: out of memory\n", stderr);
		exit(1);
	}
	return memory;
}

void *memory_alloc(size_t size)
{
	return or_die(malloc(size ? size : 1));
}

void *memory_alloc_wide(size_t size)
{
	size_t unit = size < LARGE_PAGE ? CACHE_LINE : LARGE_PAGE;
	size = (size + unit - (size > 0)) / unit * unit;
	void *memory = or_die(aligned_alloc(unit, size));
#ifdef MADV_HUGEPAGE
	if (unit == LARGE_PAGE)
		madvise(memory, size, MADV_HUGEPAGE);
#endif
	return memory;
}

void *memory_resize(void *old, size_t size)
{
	return or_die(realloc(old, size ? size : 1));
}

double memory_most(void)
{
	double machine = (double)sysconf(_SC_PHYS_PAGES) * (double)sysconf(_SC_PAGESIZE);
	struct rlimit limit;
	bool limited = getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY;
	return limited && (double)limit.rlim_cur < machine ? (double)limit.rlim_cur : machine;
}

Arena *arena_create(void)
{
	return or_die(calloc(1, sizeof(Arena)));
}

static void release_until(Arena *arena, Block *keep)
{
	while (arena->last != keep) {
		Block *block = arena->last;
		arena->last = block->previous;
		arena->bytes -= sizeof(Block) + block->size;
		free(block);
	}
}

void arena_destroy(Arena *arena)
{
	if (!arena)
		return;
	release_until(arena, NULL);
	free(arena);
}

/* Blocks double up to a limit, so that small scenes stay small and large ones make few calls. */
static Block *add_block(Arena *arena, size_t need)
{
	size_t size = arena->last ? 2 * arena->last->size : FIRST_BLOCK;
	if (size > LARGEST_BLOCK)
		size = LARGEST_BLOCK;
	if (size < need)
		size = need;
	Block *block = memory_alloc(sizeof(Block) + size);
	block->previous = arena->last;
	block->size = size;
	block->used = 0;
	arena->last = block;
	arena->bytes += sizeof(Block) + size;
	return block;
}

void *arena_alloc(Arena *arena, size_t size)
{
	size_t rounded = (size + ALIGNMENT - 1) & ~(size_t)(ALIGNMENT - 1);
	if (rounded < size)
		or_die(NULL);
	Block *block = arena->last;
	if (!block || block->size - block->used < rounded)
		block = add_block(arena, rounded);
	void *memory = block->data + block->used;
	block->used += rounded;
	return memset(memory, 0, size);
}

void *arena_copy(Arena *arena, const void *data, size_t size)
{
	void *copy = arena_alloc(arena, size);
	return size ? memcpy(copy, data, size) : copy;
}

char *arena_strndup(Arena *arena, const char *text, size_t length)
{
	char *copy = arena_alloc(arena, length + 1);
	memcpy(copy, text, length);
	return copy;
}

char *arena_strdup(Arena *arena, const char *text)
{
	return arena_strndup(arena, text, strlen(text));
}

char *arena_printf(Arena *arena, const char *format, ...)
{
	va_list args, again;
	va_start(args, format);
	va_copy(again, args);
	int length = vsnprintf(NULL, 0, format, args);
	va_end(args);
	char *text = arena_alloc(arena, (size_t)(length > 0 ? length : 0) + 1);
	vsnprintf(text, (size_t)(length > 0 ? length : 0) + 1, format, again);
	va_end(again);
	return text;
}

ArenaMark arena_mark(const Arena *arena)
{
	return (ArenaMark){arena->last, arena->last ? arena->last->used : 0};
}

void arena_rewind(Arena *arena, ArenaMark mark)
{
	release_until(arena, mark.block);
	if (arena->last)
		arena->last->used = mark.used;
}

size_t arena_bytes(const Arena *arena)
{
	return arena->bytes;
}
