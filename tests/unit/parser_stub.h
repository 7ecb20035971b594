/*
 * Stand-ins for lang's builders: an item is printed as a tree, a declared item becomes its word.
 * With them the parser's tests need no renderer.
 */
#ifndef TESTS_UNIT_PARSER_STUB_H
#define TESTS_UNIT_PARSER_STUB_H

/* The trees of all items of a scene, one a line, then the messages. Free it. */
char *parser_stub_read(const char *scene);

#endif
