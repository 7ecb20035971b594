noinst_LIBRARIES += liblang.a
liblang_a_SOURCES =
liblang_a_SOURCES += lang/cursor.c lang/cursor.h lang/node.h lang/context.h lang/build.h
liblang_a_SOURCES += lang/value.c lang/value.h lang/expression.c lang/expression.h lang/expression_tree.h
liblang_a_SOURCES += lang/builtin.c lang/builtin.h lang/builtin_float.c lang/builtin_vector.c lang/builtin_string.c \
	lang/builtin_scene.c lang/string.h lang/array.c lang/array.h lang/spline.c lang/spline.h lang/files.c lang/files.h
liblang_a_SOURCES += lang/build_texture.c lang/build_pigment.c lang/build_pigment_default.h lang/build_pigment_default.c \
	lang/build_normal.c lang/build_finish.c lang/build_interior.c \
	lang/build_map.h lang/build_map.c lang/build_pattern.h lang/build_pattern.c lang/build_pattern_modifier.c \
	lang/build_warp.c lang/build_image.h lang/build_image.c lang/build_image_function.c
liblang_a_SOURCES += lang/build.c lang/build_atmosphere.c lang/build_atmosphere.h lang/build_camera.c lang/build_camera.h \
	lang/build_light.c lang/build_media.c lang/build_media.h lang/build_object.c lang/build_object.h \
	lang/build_object_csg.c lang/build_object_curve.c lang/build_object_field.c lang/build_object_height_field.c \
	lang/build_object_mesh.c lang/build_object_modifier.c lang/build_object_poly.c lang/build_object_solid.c \
	lang/build_photons.c lang/build_photons.h lang/build_settings.c lang/build_settings.h lang/build_texture.h \
	lang/build_transform.c lang/build_transform.h
liblang_a_SOURCES += lang/symbol.c lang/symbol.h lang/word.c lang/word.h lang/words.def lang/node.c lang/node_print.h
liblang_a_SOURCES += lang/function.c lang/function.h lang/function_compile.c lang/function_compile.h
