noinst_LIBRARIES += libbase.a
libbase_a_SOURCES = src/base/vec.h src/base/color.h
