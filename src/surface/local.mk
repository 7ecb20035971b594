noinst_LIBRARIES += libsurface.a
libsurface_a_SOURCES = 
