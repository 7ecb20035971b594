# The programs.
bin_PROGRAMS += cognac-compare
cognac_compare_SOURCES = src/cli/compare.c
cognac_compare_LDADD = libimage.a libbase.a $(IMAGE_LIBS)
