noinst_LIBRARIES += liblang.a
liblang_a_SOURCES =
liblang_a_SOURCES += lang/cursor.c lang/cursor.h lang/node.h lang/context.h lang/build.h
liblang_a_SOURCES += lang/build_texture.h lang/build_transform.c lang/build_transform.h lang/build_media.h
liblang_a_SOURCES += lang/value.c lang/value.h lang/expression.c lang/expression.h lang/expression_tree.h
liblang_a_SOURCES += lang/builtin.c lang/builtin.h lang/builtin_float.c lang/builtin_vector.c lang/builtin_string.c \
	lang/builtin_scene.c lang/string.h lang/array.c lang/array.h lang/spline.c lang/spline.h lang/files.c lang/files.h
liblang_a_SOURCES += lang/build_texture.c lang/build_pigment.c lang/build_pigment_default.h lang/build_pigment_default.c \
	lang/build_normal.c lang/build_finish.c lang/build_interior.c \
	lang/build_map.h lang/build_map.c lang/build_pattern.h lang/build_pattern.c lang/build_pattern_modifier.c \
	lang/build_warp.c lang/build_image.h lang/build_image.c
