noinst_LIBRARIES += librender.a
librender_a_SOURCES = src/render/antialias.c src/render/antialias.h src/render/atmosphere.c src/render/atmosphere.h \
	src/render/caustics.c src/render/caustics.h src/render/passes.c src/render/passes.h src/render/reduction.c \
	src/render/reduction.h src/render/reduction_apa.c \
	src/render/film.c src/render/film.h src/render/lighting.c src/render/lighting.h \
	src/render/render.c src/render/render.h src/render/sample.c src/render/sample.h \
	src/render/shadow.c src/render/trace.c src/render/tracer.h
