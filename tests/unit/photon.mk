# Unit tests of src/photon: one program a module.
check_PROGRAMS += tests/unit/test_photon
tests_unit_test_photon_SOURCES = tests/unit/test_photon.c tests/unit/check.h
tests_unit_test_photon_LDADD = libphoton.a libbase.a
check_PROGRAMS += tests/unit/test_relax
tests_unit_test_relax_SOURCES = tests/unit/test_relax.c tests/unit/check.h
tests_unit_test_relax_LDADD = libphoton.a libscene.a libbase.a
check_PROGRAMS += tests/unit/test_relax_forest
tests_unit_test_relax_forest_SOURCES = tests/unit/test_relax_forest.c tests/unit/check.h
tests_unit_test_relax_forest_LDADD = libphoton.a libscene.a libbase.a
check_PROGRAMS += tests/unit/test_relax_gradient
tests_unit_test_relax_gradient_SOURCES = tests/unit/test_relax_gradient.c tests/unit/check.h
tests_unit_test_relax_gradient_LDADD = libphoton.a libscene.a libbase.a
check_PROGRAMS += tests/unit/test_tree
tests_unit_test_tree_SOURCES = tests/unit/test_tree.c tests/unit/check.h
tests_unit_test_tree_LDADD = libphoton.a libbase.a
