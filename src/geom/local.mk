noinst_LIBRARIES += libgeom.a
libgeom_a_SOURCES = 
libgeom_a_SOURCES += src/geom/polynomial.c src/geom/polynomial.h
libgeom_a_SOURCES += src/geom/mesh.c src/geom/mesh.h src/geom/mesh_tree.c src/geom/mesh_tree.h \
	src/geom/outline.c src/geom/outline.h src/geom/sweep.h src/geom/prism.c src/geom/prism.h src/geom/lathe.c \
	src/geom/sor.c src/geom/text.c src/geom/height_field.c src/geom/height_field.h src/geom/patch.c src/geom/patch.h
libgeom_a_CPPFLAGS = $(AM_CPPFLAGS) $(FREETYPE_CFLAGS)
