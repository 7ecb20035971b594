# Unit tests of src/render: one program a module.
check_PROGRAMS += tests/unit/test_film
tests_unit_test_film_SOURCES = tests/unit/test_film.c tests/unit/check.h
tests_unit_test_film_LDADD = librender.a libbase.a
