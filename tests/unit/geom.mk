# Unit tests of src/geom: one program a module.
check_PROGRAMS += tests/unit/test_polynomial
tests_unit_test_polynomial_SOURCES = tests/unit/test_polynomial.c tests/unit/check.h
tests_unit_test_polynomial_LDADD = libgeom.a libbase.a
