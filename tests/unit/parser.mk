# Unit tests of parser: one program a module.
check_PROGRAMS += tests/unit/test_reader
tests_unit_test_reader_SOURCES = tests/unit/test_reader.c tests/unit/parser_stub.c tests/unit/parser_stub.h
tests_unit_test_reader_LDADD = libparser.a liblang.a libscene.a liblight.a libsurface.a libgeom.a libbase.a
