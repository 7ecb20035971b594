noinst_LIBRARIES += libparser.a
libparser_a_SOURCES = parser/reader.c parser/reader.h parser/state.h parser/grammar.y parser/scanner.l \
	parser/token.h parser/number.c parser/number.h parser/string_literal.c parser/string_literal.h \
	parser/link.c parser/link.h parser/source.c parser/lexer.c parser/identifier.c parser/frame.c \
	parser/function_header.c parser/macro.c parser/include.c parser/directive.c parser/declare.c \
	parser/stream.c parser/tree.c

# Made by bison first: the scanner and others include it.
BUILT_SOURCES += parser/grammar.h
$(libparser_a_OBJECTS) tests/unit/test_scanner.$(OBJEXT): parser/grammar.h
