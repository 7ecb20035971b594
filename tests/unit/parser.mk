# Unit tests of parser: one program a module.
check_PROGRAMS += tests/unit/test_reader tests/unit/test_scanner
tests_unit_test_reader_SOURCES = tests/unit/test_reader.c tests/unit/parser_stub.c tests/unit/parser_stub.h
tests_unit_test_reader_LDADD = $(COGNAC_ROOMS) libimage.a libbase.a $(COGNAC_LIBS)
tests_unit_test_scanner_SOURCES = tests/unit/test_scanner.c
tests_unit_test_scanner_LDADD = libparser.a liblang.a libbase.a
