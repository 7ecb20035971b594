noinst_LIBRARIES += librender.a
librender_a_SOURCES = 
