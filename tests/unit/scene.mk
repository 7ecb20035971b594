# Unit tests of src/scene: one program a module.
check_PROGRAMS += tests/unit/test_accel
tests_unit_test_accel_SOURCES = tests/unit/test_accel.c tests/unit/check.h
tests_unit_test_accel_LDADD = libscene.a libgeom.a libbase.a $(EMBREE_LIBS)
