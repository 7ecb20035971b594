/* Strings of the scene language: UTF-8, positions and lengths count characters. */
#ifndef LANG_STRING_H
#define LANG_STRING_H

#include "base/arena.h"

/* As str(x, width, precision) writes it: a negative width pads with zeros, a negative precision
 * means 6 digits. */
const char *string_format_float(Arena *arena, double x, double width, double precision);
int string_length(const char *text);
/* The code point that text starts with; 0 for the empty text. A byte that starts nothing valid
 * stands for itself. */
int string_decode(const char *text);
/* Writes the code point's UTF-8 bytes and a NUL; returns their number without it. */
int string_encode(int code, char out[5]);

#endif
