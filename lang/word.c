#include "lang/word.h"

#include <string.h>

typedef struct WordRow {
	const char *text;
	WordClass class;
} WordRow;

/* Row n is word n; after the first sorted by text. */
static const WordRow words[W_COUNT] = {
	{"", WORD_PLAIN},
#define WORD(id, text, class) {text, class},
#include "lang/words.def"
#undef WORD
};

/* As strcmp, of a text that no NUL ends. */
static int compare(const char *text, size_t length, const char *word)
{
	int order = strncmp(text, word, length);
	return order ? order : word[length] ? -1 : 0;
}

Word word_find(const char *text, size_t length)
{
	int low = W_NONE + 1, high = W_COUNT - 1;
	while (low <= high) {
		int middle = (low + high) / 2;
		int order = compare(text, length, words[middle].text);
		if (order == 0)
			return (Word)middle;
		if (order < 0)
			high = middle - 1;
		else
			low = middle + 1;
	}
	return W_NONE;
}

const char *word_text(Word word)
{
	return words[word].text;
}

WordClass word_class(Word word)
{
	return words[word].class;
}
