noinst_LIBRARIES += libgeom.a
libgeom_a_SOURCES = 
libgeom_a_SOURCES += src/geom/mesh.c src/geom/mesh.h src/geom/mesh_tree.c src/geom/mesh_tree.h \
	src/geom/outline.c src/geom/outline.h src/geom/sweep.h src/geom/prism.c src/geom/prism.h src/geom/lathe.c \
	src/geom/lathe_spans.c src/geom/lathe_spans.h src/geom/sor.c src/geom/text.c src/geom/height_field.c src/geom/height_field.h src/geom/patch.c src/geom/patch.h
libgeom_a_CPPFLAGS = $(AM_CPPFLAGS) $(FREETYPE_CFLAGS)
libgeom_a_SOURCES += src/geom/polynomial.c src/geom/polynomial.h src/geom/secant.h
libgeom_a_SOURCES += src/geom/shape.c src/geom/shape.h src/geom/hit_list.c src/geom/ray_box.h
libgeom_a_SOURCES += src/geom/box_tree.c src/geom/box_tree.h src/geom/csg.c src/geom/csg.h
libgeom_a_SOURCES += src/geom/sphere.c src/geom/sphere.h src/geom/box.c src/geom/box.h src/geom/plane.c src/geom/plane.h src/geom/plain.h
libgeom_a_SOURCES += src/geom/cone.c src/geom/cone.h src/geom/disc.c src/geom/disc.h src/geom/torus.c src/geom/torus.h
libgeom_a_SOURCES += src/geom/poly.c src/geom/poly.h src/geom/superellipsoid.c src/geom/superellipsoid.h
libgeom_a_SOURCES += src/geom/blob.c src/geom/blob.h src/geom/container.c src/geom/container.h
libgeom_a_SOURCES += src/geom/isosurface.c src/geom/isosurface.h
libgeom_a_SOURCES += src/geom/sphere_sweep.c src/geom/sphere_sweep.h src/geom/ovus.c src/geom/ovus.h
libgeom_a_SOURCES += src/geom/julia_fractal.c src/geom/julia_fractal.h src/geom/parametric.c src/geom/parametric.h
