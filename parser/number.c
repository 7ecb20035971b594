#include "parser/number.h"

#include <stdbool.h>
#include <stdint.h>
#include <stdlib.h>

enum {
	EXACT_DIGITS = 15, /* a 15-digit integer is a double exactly, */
	EXACT_POWER = 22,  /* and so is 10^22: one rounding in all (Clinger 1990) */
};

static const double powers[EXACT_POWER + 1] = {
	1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8,  1e9,  1e10, 1e11,
	1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22,
};

double number_parse(const char *text, size_t length)
{
	uint64_t digits = 0;
	int count = 0, decimals = 0;
	bool point = false;
	for (size_t i = 0; i < length; i++) {
		if (text[i] == '.') {
			point = true;
		} else if (text[i] >= '0' && text[i] <= '9' && count <= EXACT_DIGITS) {
			digits = digits * 10 + (uint64_t)(text[i] - '0');
			count += digits > 0;
			decimals += point;
		} else {
			return strtod(text, NULL);
		}
	}
	if (count > EXACT_DIGITS || decimals > EXACT_POWER)
		return strtod(text, NULL);
	return (double)digits / powers[decimals];
}
