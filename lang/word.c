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

static int least(int a, int b)
{
	return a < b ? a : b;
}

enum { LONGEST_GUESS = 32 };

/* Slips between two texts of at most LONGEST_GUESS characters: the alignment distance of Damerau,
 * row by row over the characters of a. */
static int count_slips(const char *a, int a_length, const char *b, int b_length)
{
	int rows[3][LONGEST_GUESS + 1];
	for (int j = 0; j <= b_length; j++)
		rows[0][j] = j;
	for (int i = 1; i <= a_length; i++) {
		int *row = rows[i % 3], *above = rows[(i + 2) % 3], *second = rows[(i + 1) % 3];
		row[0] = i;
		for (int j = 1; j <= b_length; j++) {
			int same = above[j - 1] + (a[i - 1] != b[j - 1]);
			row[j] = least(same, 1 + least(above[j], row[j - 1]));
			if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
				row[j] = least(row[j], 1 + second[j - 2]);
		}
	}
	return rows[a_length % 3][b_length];
}

Word word_guess(const char *text, bool extension)
{
	enum { SHORTEST = 5, LONG = 7 };
	int length = (int)strnlen(text, LONGEST_GUESS + 1);
	int fewest = length >= LONG ? 3 : 2; /* so many are too many */
	Word best = W_NONE;
	for (int word = W_NONE + 1; word < W_COUNT; word++) {
		int other = (int)strlen(words[word].text);
		if (length < SHORTEST || length > LONGEST_GUESS || other > LONGEST_GUESS ||
		    words[word].class == WORD_DIRECTIVE ||
		    (words[word].class == WORD_EXTENSION && !extension))
			continue;
		int slips = count_slips(text, length, words[word].text, other);
		if (slips < fewest) {
			fewest = slips;
			best = (Word)word;
		}
	}
	return best;
}

const char *word_text(Word word)
{
	return words[word].text;
}

WordClass word_class(Word word)
{
	return words[word].class;
}
