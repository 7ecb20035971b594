# Unit tests of lang: one program a module.
check_PROGRAMS += tests/unit/test_cursor
tests_unit_test_cursor_SOURCES = tests/unit/test_cursor.c tests/unit/check.h
tests_unit_test_cursor_LDADD = liblang.a libsurface.a libbase.a
