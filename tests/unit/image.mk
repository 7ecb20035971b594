# Unit tests of src/image: one program a module.
IMAGE_LIBS = $(OPENEXR_LIBS) $(PNG_LIBS) $(JPEG_LIBS) $(TIFF_LIBS) $(GIF_LIBS)
check_PROGRAMS += tests/unit/test_image
tests_unit_test_image_SOURCES = tests/unit/test_image.c tests/unit/check.h
tests_unit_test_image_LDADD = libimage.a libbase.a $(IMAGE_LIBS)
