/*
 * A bump allocator: many allocations, one release. Memory comes zeroed and aligned for any type.
 * Running out of memory ends the program with a message and status 1, so callers never check. Not
 * shared between threads.
 */
#ifndef BASE_ARENA_H
#define BASE_ARENA_H

#include <stddef.h>

typedef struct Arena Arena;

/* A place to return to with arena_rewind; valid for the arena it came from. */
typedef struct ArenaMark {
	void *block;
	size_t used;
} ArenaMark;

Arena *arena_create(void);
void arena_destroy(Arena *arena);          /* NULL is allowed */
void *arena_alloc(Arena *arena, size_t size);
void *arena_copy(Arena *arena, const void *data, size_t size);
char *arena_strdup(Arena *arena, const char *text);
char *arena_strndup(Arena *arena, const char *text, size_t length);
char *arena_printf(Arena *arena, const char *format, ...) __attribute__((format(printf, 2, 3)));
ArenaMark arena_mark(const Arena *arena);
void arena_rewind(Arena *arena, ArenaMark mark); /* everything allocated since the mark is gone */
size_t arena_bytes(const Arena *arena);          /* bytes held from the system */

/* One zeroed object, or an array of them, of a type. */
#define ARENA_NEW(arena, type) ((type *)arena_alloc((arena), sizeof(type)))
#define ARENA_ARRAY(arena, type, count)                                                            \
	((type *)arena_alloc((arena), sizeof(type) * (size_t)(count)))

/* malloc and friends that end the program when memory runs out. */
void *memory_alloc(size_t size);
void *memory_resize(void *old, size_t size);
/* For large arrays: aligned to a cache line, in large pages where the system has them. */
void *memory_alloc_wide(size_t size);
/* Bytes that the program can have at most: the machine's memory, or the limit set on the process
 * (ulimit -v). */
double memory_most(void);

#endif
