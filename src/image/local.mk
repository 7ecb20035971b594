noinst_LIBRARIES += libimage.a
libimage_a_SOURCES = src/image/bmp.c src/image/bytes.c src/image/bytes.h src/image/compare.c src/image/compare.h \
	src/image/decode.h src/image/encode.h src/image/exr.c src/image/exr.h \
	src/image/gif.c src/image/hdr.c src/image/image.c src/image/image.h src/image/jpeg.c src/image/layer.c \
	src/image/layer.h src/image/png.c src/image/pnm.c src/image/quantize.c src/image/read.c src/image/read.h src/image/tga.c src/image/tiff.c src/image/write.c src/image/write.h
libimage_a_CFLAGS = $(AM_CFLAGS) $(OPENEXR_CFLAGS) $(PNG_CFLAGS) $(JPEG_CFLAGS) $(TIFF_CFLAGS)
