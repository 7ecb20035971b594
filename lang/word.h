/*
 * The reserved words of the scene language. lang/words.def has a row for each: its text and its
 * class for the scanner. A word is known to the scanner by its spelling, to the builders by its
 * number.
 */
#ifndef LANG_WORD_H
#define LANG_WORD_H

#include <stdbool.h>
#include <stddef.h>

/* What a word is to the grammar. */
typedef enum WordClass {
	WORD_PLAIN, /* an item's word: with or without braces: sphere, hollow, translate */
	WORD_FUNCTION, /* a built-in function of expressions: sin, vcross, concat, dimension_size */
	WORD_CONSTANT, /* stands for a value in expressions: x, pi, yes, clock, image_width */
	WORD_COLOR, /* part of a colour expression: rgb, rgbft, color, red, filter */
	WORD_DIRECTIVE, /* only after #: declare, macro, while... (those that are plain words as
			   well, default and range, are plain) */
	WORD_EXTENSION, /* a plain word after `#version unofficial cognac`, an ordinary identifier
			   without */
} WordClass;

typedef enum Word {
	W_NONE,
#define WORD(id, text, class) W_##id,
#include "lang/words.def"
#undef WORD
	W_COUNT
} Word;

/* W_NONE when text is not reserved. */
Word word_find(const char *text, size_t length);
/* The word that a misspelt text seems to mean: one slip away, or two in a long one (a character
 * too many, missing, another, or two exchanged). W_NONE when there is none. */
Word word_guess(const char *text, bool extension);
const char *word_text(Word word);
WordClass word_class(Word word);

#endif
