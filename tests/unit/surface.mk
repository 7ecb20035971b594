# Unit tests of src/surface: one program a module.
check_PROGRAMS += tests/unit/test_bsdf
tests_unit_test_bsdf_SOURCES = tests/unit/test_bsdf.c tests/unit/check.h
tests_unit_test_bsdf_LDADD = libsurface.a libbase.a
