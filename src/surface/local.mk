noinst_LIBRARIES += libsurface.a
libsurface_a_SOURCES = 
libsurface_a_SOURCES += src/surface/texture.h src/surface/texture.c src/surface/pigment.c src/surface/normal.c src/surface/finish.c \
	src/surface/interior.c src/surface/blend.h src/surface/blend.c
