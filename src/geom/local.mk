noinst_LIBRARIES += libgeom.a
libgeom_a_SOURCES = 
