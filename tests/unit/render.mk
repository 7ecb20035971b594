# Unit tests of src/render: one program a module.
check_PROGRAMS += tests/unit/test_film
tests_unit_test_film_SOURCES = tests/unit/test_film.c tests/unit/check.h
tests_unit_test_film_LDADD = librender.a libbase.a
check_PROGRAMS += tests/unit/test_render
tests_unit_test_render_SOURCES = tests/unit/test_render.c tests/unit/scene_check.h tests/unit/check.h
tests_unit_test_render_LDADD = librender.a libdensity.a libphoton.a libscene.a liblight.a libsurface.a libgeom.a libimage.a libbase.a \
	$(EMBREE_LIBS) $(IMAGE_LIBS) $(FREETYPE_LIBS)
