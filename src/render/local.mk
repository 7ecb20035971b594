noinst_LIBRARIES += librender.a
librender_a_SOURCES = src/render/film.h src/render/render.h
