# Unit tests of src/geom: one program a module.
check_PROGRAMS += tests/unit/test_polynomial
tests_unit_test_polynomial_SOURCES = tests/unit/test_polynomial.c tests/unit/check.h
tests_unit_test_polynomial_LDADD = libgeom.a libbase.a
check_PROGRAMS += tests/unit/test_shapes
tests_unit_test_shapes_SOURCES = tests/unit/test_shapes.c tests/unit/shape_check.h tests/unit/check.h
tests_unit_test_shapes_LDADD = libgeom.a libbase.a
check_PROGRAMS += tests/unit/test_csg
tests_unit_test_csg_SOURCES = tests/unit/test_csg.c tests/unit/shape_check.h tests/unit/check.h
tests_unit_test_csg_LDADD = libgeom.a libbase.a
check_PROGRAMS += tests/unit/test_sweep
tests_unit_test_sweep_SOURCES = tests/unit/test_sweep.c tests/unit/shape_check.h tests/unit/check.h
tests_unit_test_sweep_LDADD = libgeom.a libbase.a $(FREETYPE_LIBS)
check_PROGRAMS += tests/unit/test_implicit
tests_unit_test_implicit_SOURCES = tests/unit/test_implicit.c tests/unit/shape_check.h tests/unit/check.h
tests_unit_test_implicit_LDADD = libgeom.a libbase.a
