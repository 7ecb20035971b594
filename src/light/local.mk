noinst_LIBRARIES += liblight.a
liblight_a_SOURCES = 
