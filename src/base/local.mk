noinst_LIBRARIES += libbase.a
libbase_a_SOURCES = src/base/arena.c src/base/arena.h src/base/cholesky.h src/base/clock.c src/base/clock.h src/base/color.h \
	src/base/diag.c src/base/diag.h src/base/output_file.c src/base/output_file.h src/base/pair.h src/base/path.h \
	src/base/median.c src/base/median.h \
	src/base/parallel.c src/base/parallel.h src/base/random.c src/base/random.h \
	src/base/transform.c src/base/transform.h src/base/vec.h
