noinst_LIBRARIES += libsurface.a
libsurface_a_SOURCES = src/surface/point.h src/surface/function.h src/surface/pattern.h \
	src/surface/noise.c src/surface/noise.h src/surface/warp.c src/surface/warp.h src/surface/image_map.c \
	src/surface/image_map.h src/surface/pattern.c src/surface/pattern_block.c src/surface/pattern_classes.h \
	src/surface/pattern_crackle.c src/surface/pattern_data.c src/surface/pattern_data.h src/surface/pattern_fractal.c \
	src/surface/pattern_noise.c src/surface/pattern_simple.c src/surface/pattern_tiling.c \
	src/surface/pattern_pavement.c src/surface/pavement_plan.c src/surface/pavement_plan.h \
	src/surface/pattern_wave.c
libsurface_a_SOURCES += src/surface/texture.h src/surface/texture.c src/surface/pigment.c src/surface/normal.c src/surface/finish.c \
	src/surface/interior.c src/surface/blend.h src/surface/blend.c src/surface/cubic.h

# The noise tables are computed at build time from the figures in the maker's source.
EXTRA_PROGRAMS = src/surface/noise_tables_make
src_surface_noise_tables_make_SOURCES = src/surface/noise_tables_make.c
src_surface_noise_tables_make_LDADD = -lm
src/surface/noise_tables.inc: src/surface/noise_tables_make$(EXEEXT)
	$(AM_V_GEN)./src/surface/noise_tables_make$(EXEEXT) > $@.tmp && mv $@.tmp $@
src/surface/noise.$(OBJEXT): src/surface/noise_tables.inc
CLEANFILES += src/surface/noise_tables.inc src/surface/noise_tables_make$(EXEEXT)
libsurface_a_SOURCES += src/surface/bsdf.c src/surface/bsdf.h src/surface/bsdf_layer.h \
	src/surface/refraction.h
libsurface_a_SOURCES += src/surface/function.c src/surface/function_code.h src/surface/function_program.c \
	src/surface/function_program.h src/surface/function_natives.c src/surface/function_natives.h \
	src/surface/function_internal.c src/surface/function_internal.h src/surface/function_internal_shapes.c \
	src/surface/function_internal_curves.c src/surface/function_internal_algebra.c \
	src/surface/function_internal_plane.c src/surface/function_internal_blobs.c src/surface/function_internal_noise.c
