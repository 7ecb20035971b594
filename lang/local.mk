noinst_LIBRARIES += liblang.a
liblang_a_SOURCES =
liblang_a_SOURCES += lang/cursor.c lang/cursor.h lang/node.h lang/context.h lang/build.h
liblang_a_SOURCES += lang/build_texture.h lang/build_transform.c lang/build_transform.h lang/build_media.h
