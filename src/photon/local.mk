noinst_LIBRARIES += libphoton.a
libphoton_a_SOURCES = src/photon/photon.c src/photon/photon.h \
	src/photon/group.c src/photon/group.h src/photon/hue.c src/photon/hue.h \
	src/photon/map.c src/photon/map.h \
	src/photon/ply.c src/photon/aim.c src/photon/aim.h src/photon/autostop.c src/photon/autostop.h \
	src/photon/path.c src/photon/path.h src/photon/room.c src/photon/room.h \
	src/photon/trace.c src/photon/trace.h src/photon/tree.c src/photon/tree.h \
	src/photon/tree_build.c src/photon/tree_build.h src/photon/tree_avx2.c src/photon/tree_plain.c \
	src/photon/eight_plain.h src/photon/eight_avx2.h src/photon/tree_query.h src/photon/tree_order.c src/photon/tree_order.h \
	src/photon/tree_cut.h src/photon/tree_cut_avx2.c src/photon/tree_cut_plain.c src/photon/relax.h \
	src/photon/relax.c src/photon/relax_set.c src/photon/relax_set.h \
	src/photon/relax_forest.c src/photon/relax_forest.h src/photon/features.c src/photon/features.h \
	src/photon/relax_gradient.c src/photon/relax_gradient.h \
	src/photon/relax_scene.c src/photon/relax_slices.c src/photon/relax_slices.h
