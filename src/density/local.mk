noinst_LIBRARIES += libdensity.a
libdensity_a_SOURCES = src/density/estimator.h
