noinst_LIBRARIES += libgeom.a
libgeom_a_SOURCES = 
libgeom_a_SOURCES += src/geom/polynomial.c src/geom/polynomial.h
