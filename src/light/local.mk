noinst_LIBRARIES += liblight.a
liblight_a_SOURCES = src/light/area.c src/light/area.h src/light/emission.c src/light/emission.h \
	src/light/light.c src/light/light.h
