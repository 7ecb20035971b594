/* Floats from digits, faster than strtod and as exact: correctly rounded for every text. */
#ifndef PARSER_NUMBER_H
#define PARSER_NUMBER_H

#include <stddef.h>

/* text is digits with at most one point and an exponent, as the scanner matched them; a byte that
 * belongs to no number follows. */
double number_parse(const char *text, size_t length);

#endif
