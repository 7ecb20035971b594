/* The few macros that unit tests need: count failures, go on, end with status 1 if there were any.
 */
#ifndef TESTS_UNIT_CHECK_H
#define TESTS_UNIT_CHECK_H

#include <math.h>
#include <stdio.h>
#include <string.h>

static int check_failures;

#define CHECK(condition) \
	do { \
		if (!(condition)) { \
			check_failures++; \
			printf("%s:%d: failed: %s\n", __FILE__, __LINE__, #condition); \
		} \
	} while (0)

/* |value - expected| <= tolerance */
#define CHECK_NEAR(value, expected, tolerance)                                                     \
	do {                                                                                       \
		double check_v = (value), check_e = (expected);                                    \
		if (!(fabs(check_v - check_e) <= (tolerance))) {                                   \
			check_failures++;                                                          \
			printf("%s:%d: failed: %s is %.9g, expected %.9g\n", __FILE__, __LINE__,   \
			       #value, check_v, check_e);                                          \
		}                                                                                  \
	} while (0)

#define CHECK_STRING(value, expected)                                                              \
	do {                                                                                       \
		const char *check_s = (value);                                                     \
		if (strcmp(check_s, (expected)) != 0) {                                            \
			check_failures++;                                                          \
			printf("%s:%d: failed: %s is \"%s\"\n", __FILE__, __LINE__, #value,        \
			       check_s);                                                           \
		}                                                                                  \
	} while (0)

#define CHECK_RESULT() (check_failures ? 1 : 0)

#endif
