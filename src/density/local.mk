noinst_LIBRARIES += libdensity.a
libdensity_a_SOURCES = src/density/estimator.h src/density/estimator.c src/density/method.h \
	src/density/kernel.h src/density/kernel.c src/density/gather.h src/density/gather.c \
	src/density/nearest.c src/density/expand.c src/density/diffusion.c src/density/footprint.c \
	src/density/footprint_border.h src/density/footprint_border.c \
	src/density/footprint_kernel.h src/density/footprint_kernel.c \
	src/density/footprint_shape.h src/density/footprint_shape.c src/density/footprint_hue.h src/density/footprint_hue.c src/density/footprint_fit.h src/density/footprint_fit.c src/density/footprint_tree.h src/density/footprint_tree.c
