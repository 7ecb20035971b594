/* String literals: escapes resolved, everything in UTF-8. */
#ifndef PARSER_STRING_LITERAL_H
#define PARSER_STRING_LITERAL_H

#include "base/arena.h"

/* text is what stands between the quotes. Bytes that are not UTF-8 are taken as Latin-1, as old
 * scenes have them. An escape that POV-Ray does not know is kept as it stands; *unknown then gets
 * its offset, else -1. The result is in the arena. */
const char *string_literal_parse(Arena *arena, const char *text, size_t length, long *unknown);

#endif
