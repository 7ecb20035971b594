noinst_LIBRARIES += liblang.a
liblang_a_SOURCES =
liblang_a_SOURCES += lang/cursor.c lang/cursor.h lang/node.h lang/context.h lang/build.h
