noinst_LIBRARIES += libimage.a
libimage_a_SOURCES = src/image/compare.h src/image/exr.h src/image/file.h src/image/image.h src/image/write.h
libimage_a_CFLAGS = $(AM_CFLAGS) $(OPENEXR_CFLAGS) $(PNG_CFLAGS) $(JPEG_CFLAGS) $(TIFF_CFLAGS)
