# Unit tests of src/base: one program a module, or one for the small ones together.
check_PROGRAMS += tests/unit/test_base
tests_unit_test_base_SOURCES = tests/unit/test_base.c tests/unit/check.h
tests_unit_test_base_LDADD = libbase.a
