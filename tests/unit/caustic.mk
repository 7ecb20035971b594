# Caustics against closed forms.
check_PROGRAMS += tests/unit/test_caustic_mirror tests/unit/test_caustic_glass tests/unit/test_caustic_energy \
	tests/unit/test_caustic_aim
CAUSTIC_ROOMS = libparser.a liblang.a libphoton.a libscene.a liblight.a libsurface.a libgeom.a libimage.a libbase.a
tests_unit_test_caustic_mirror_SOURCES = tests/unit/test_caustic_mirror.c tests/unit/caustic_check.h tests/unit/check.h
tests_unit_test_caustic_mirror_LDADD = $(CAUSTIC_ROOMS) $(COGNAC_LIBS)
tests_unit_test_caustic_glass_SOURCES = tests/unit/test_caustic_glass.c tests/unit/caustic_check.h tests/unit/check.h
tests_unit_test_caustic_glass_LDADD = $(CAUSTIC_ROOMS) $(COGNAC_LIBS)
tests_unit_test_caustic_energy_SOURCES = tests/unit/test_caustic_energy.c tests/unit/caustic_check.h tests/unit/check.h
tests_unit_test_caustic_energy_LDADD = $(CAUSTIC_ROOMS) $(COGNAC_LIBS)
tests_unit_test_caustic_aim_SOURCES = tests/unit/test_caustic_aim.c tests/unit/caustic_check.h tests/unit/check.h
tests_unit_test_caustic_aim_LDADD = $(CAUSTIC_ROOMS) $(COGNAC_LIBS)
