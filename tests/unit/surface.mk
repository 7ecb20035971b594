# Unit tests of src/surface: one program a module.
check_PROGRAMS += tests/unit/test_bsdf
tests_unit_test_bsdf_SOURCES = tests/unit/test_bsdf.c tests/unit/check.h
tests_unit_test_bsdf_LDADD = libsurface.a libbase.a
check_PROGRAMS += tests/unit/test_texture
tests_unit_test_texture_SOURCES = tests/unit/test_texture.c tests/unit/check.h
tests_unit_test_texture_LDADD = libsurface.a libbase.a
check_PROGRAMS += tests/unit/test_normal
tests_unit_test_normal_SOURCES = tests/unit/test_normal.c tests/unit/check.h
tests_unit_test_normal_LDADD = libsurface.a libbase.a
check_PROGRAMS += tests/unit/test_function tests/unit/test_function_internal
tests_unit_test_function_SOURCES = tests/unit/test_function.c tests/unit/check.h
tests_unit_test_function_LDADD = libsurface.a libbase.a
tests_unit_test_function_internal_SOURCES = tests/unit/test_function_internal.c tests/unit/check.h
tests_unit_test_function_internal_LDADD = libsurface.a libbase.a
check_PROGRAMS += tests/unit/test_pattern
tests_unit_test_pattern_SOURCES = tests/unit/test_pattern.c tests/unit/pattern_data.h tests/unit/check.h
tests_unit_test_pattern_LDADD = libsurface.a libbase.a
