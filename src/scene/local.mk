noinst_LIBRARIES += libscene.a
libscene_a_SOURCES = 
libscene_a_SOURCES += src/scene/flatten.c src/scene/flatten.h src/scene/object.c src/scene/object.h \
	src/scene/photon_settings.c src/scene/photon_settings.h src/scene/scene.c src/scene/scene.h
libscene_a_SOURCES += src/scene/accel.c src/scene/accel.h src/scene/camera.c src/scene/camera.h \
	src/scene/inside.c src/scene/inside.h src/scene/mesh_camera.c src/scene/mesh_camera.h \
	src/scene/shade.c src/scene/shade.h src/scene/visit.c src/scene/visit.h
