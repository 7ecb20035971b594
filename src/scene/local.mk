noinst_LIBRARIES += libscene.a
libscene_a_SOURCES = 
