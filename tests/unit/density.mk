# Unit tests of src/density: one program a module.
check_PROGRAMS += tests/unit/test_kernel
tests_unit_test_kernel_SOURCES = tests/unit/test_kernel.c tests/unit/check.h
tests_unit_test_kernel_LDADD = libdensity.a libbase.a
check_PROGRAMS += tests/unit/test_density
tests_unit_test_density_SOURCES = tests/unit/test_density.c tests/unit/check.h
tests_unit_test_density_LDADD = libdensity.a libphoton.a libscene.a libsurface.a libbase.a
check_PROGRAMS += tests/unit/test_footprint
tests_unit_test_footprint_SOURCES = tests/unit/test_footprint.c tests/unit/check.h tests/bench/known_map.h
tests_unit_test_footprint_LDADD = libdensity.a libphoton.a libscene.a libsurface.a libbase.a
check_PROGRAMS += tests/unit/test_footprint_tree
tests_unit_test_footprint_tree_SOURCES = tests/unit/test_footprint_tree.c tests/unit/check.h
tests_unit_test_footprint_tree_LDADD = libphoton.a libbase.a
check_PROGRAMS += tests/unit/test_footprint_patch
tests_unit_test_footprint_patch_SOURCES = tests/unit/test_footprint_patch.c tests/unit/check.h
tests_unit_test_footprint_patch_LDADD = libdensity.a libphoton.a libbase.a
