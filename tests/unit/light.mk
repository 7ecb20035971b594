# Unit tests of src/light: one program a module.
check_PROGRAMS += tests/unit/test_light
tests_unit_test_light_SOURCES = tests/unit/test_light.c tests/unit/check.h
tests_unit_test_light_LDADD = liblight.a libbase.a
