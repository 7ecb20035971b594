# The programs.
COGNAC_ROOMS = libparser.a liblang.a librender.a libdensity.a libphoton.a libscene.a liblight.a libsurface.a libgeom.a
COGNAC_LIBS = $(EMBREE_LIBS) $(FREETYPE_LIBS) $(IMAGE_LIBS)
bin_PROGRAMS += cognac cognac-compare cognac-layer cognac-merge
noinst_LIBRARIES += libcli.a
libcli_a_SOURCES = src/cli/animation.c src/cli/animation.h src/cli/frame.c src/cli/frame.h src/cli/ini.c \
	src/cli/interrupt.c src/cli/interrupt.h src/cli/library.c src/cli/library.h src/cli/options.c \
	src/cli/options.h src/cli/output.c src/cli/output.h src/cli/progress.c src/cli/progress.h src/cli/run.c \
	src/cli/run.h src/cli/shell.c src/cli/shell.h src/cli/statistics.c src/cli/statistics.h src/cli/status.h \
	src/cli/switches.c src/cli/words.c
cognac_SOURCES = src/cli/main.c
cognac_LDADD = libcli.a $(COGNAC_ROOMS) libimage.a libbase.a $(COGNAC_LIBS)
cognac_compare_SOURCES = src/cli/compare.c src/cli/tool.c src/cli/tool.h
cognac_compare_LDADD = libimage.a libbase.a $(IMAGE_LIBS)
cognac_layer_SOURCES = src/cli/layer.c src/cli/tool.c src/cli/tool.h
cognac_layer_LDADD = libimage.a libbase.a $(IMAGE_LIBS)
cognac_merge_SOURCES = src/cli/merge.c src/cli/tool.c src/cli/tool.h
cognac_merge_LDADD = libimage.a libbase.a $(IMAGE_LIBS)
