noinst_LIBRARIES += libdensity.a
libdensity_a_SOURCES = src/density/estimator.h src/density/estimator.c src/density/method.h \
	src/density/kernel.h src/density/kernel.c src/density/gather.h src/density/gather.c \
	src/density/nearest.c src/density/expand.c src/density/diffusion.c src/density/footprint.c \
	src/density/footprint_border.c \
	src/density/footprint_delaunay.h src/density/footprint_delaunay.c \
	src/density/footprint_fit.h src/density/footprint_fit.c \
	src/density/footprint_mesh.h src/density/footprint_mesh.c \
	src/density/footprint_outline.h src/density/footprint_outline.c \
	src/density/footprint_parts.h src/density/footprint_parts.c \
	src/density/footprint_patch.h src/density/footprint_patch.c \
	src/density/footprint_sheet.h src/density/footprint_sheet.c \
	src/density/footprint_slopes.c src/density/footprint_spread.c \
	src/density/footprint_strangers.h src/density/footprint_strangers.c \
	src/density/footprint_tree.h src/density/footprint_tree.c \
	src/density/window.h src/density/window.c
