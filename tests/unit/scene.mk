# Unit tests of src/scene: one program a module.
check_PROGRAMS += tests/unit/test_accel
tests_unit_test_accel_SOURCES = tests/unit/test_accel.c tests/unit/check.h
tests_unit_test_accel_LDADD = libscene.a libgeom.a libbase.a $(EMBREE_LIBS)
check_PROGRAMS += tests/unit/test_camera
tests_unit_test_camera_SOURCES = tests/unit/test_camera.c tests/unit/check.h
tests_unit_test_camera_LDADD = libscene.a libsurface.a libgeom.a libimage.a libbase.a $(IMAGE_LIBS) $(FREETYPE_LIBS)
check_PROGRAMS += tests/unit/test_flatten
tests_unit_test_flatten_SOURCES = tests/unit/test_flatten.c tests/unit/check.h
tests_unit_test_flatten_LDADD = libscene.a liblight.a libsurface.a libgeom.a libbase.a
check_PROGRAMS += tests/unit/test_mesh_camera
tests_unit_test_mesh_camera_SOURCES = tests/unit/test_mesh_camera.c tests/unit/check.h
tests_unit_test_mesh_camera_LDADD = libscene.a libsurface.a libgeom.a libbase.a $(EMBREE_LIBS)
