# Unit tests of lang: one program a module.
check_PROGRAMS += tests/unit/test_cursor
tests_unit_test_cursor_SOURCES = tests/unit/test_cursor.c tests/unit/check.h
tests_unit_test_cursor_LDADD = liblang.a libsurface.a libbase.a
check_PROGRAMS += tests/unit/test_build_camera
tests_unit_test_build_camera_SOURCES = tests/unit/test_build_camera.c tests/unit/check.h
tests_unit_test_build_camera_LDADD = liblang.a libscene.a libimage.a liblight.a libsurface.a libgeom.a libbase.a $(EMBREE_LIBS) $(OPENEXR_LIBS) $(PNG_LIBS) $(JPEG_LIBS) $(TIFF_LIBS) $(GIF_LIBS) $(FREETYPE_LIBS)
check_PROGRAMS += tests/unit/test_expression
tests_unit_test_expression_SOURCES = tests/unit/test_expression.c tests/unit/check.h
tests_unit_test_expression_LDADD = liblang.a libscene.a libimage.a liblight.a libsurface.a libgeom.a libbase.a $(EMBREE_LIBS) $(OPENEXR_LIBS) $(PNG_LIBS) $(JPEG_LIBS) $(TIFF_LIBS) $(GIF_LIBS) $(FREETYPE_LIBS)
