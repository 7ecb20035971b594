# Relaxation: time beside FLANN (make bench-relaxation), and a trial of its quality in two dimensions (make trial-relaxation).
# Not in `make all`: the first needs a C++ compiler and FLANN.
EXTRA_DIST += tests/bench/relaxation.cc tests/bench/relaxation_trial.c tests/bench/wave.h
RELAX_LIBS = libphoton.a libscene.a libsurface.a libbase.a

tests/bench/relaxation-trial: tests/bench/relaxation_trial.c tests/bench/wave.h $(RELAX_LIBS)
	$(MKDIR_P) tests/bench
	$(COMPILE) -o $@ $(srcdir)/tests/bench/relaxation_trial.c $(RELAX_LIBS) $(AM_LDFLAGS) $(LIBS)
trial-relaxation: tests/bench/relaxation-trial
	tests/bench/relaxation-trial 60000
	tests/bench/relaxation-trial 600000
	tests/bench/relaxation-trial -r 600000
CLEANFILES += tests/bench/relaxation-trial
.PHONY: trial-relaxation

tests/bench/relaxation-times: tests/bench/relaxation.cc tests/bench/wave.h $(RELAX_LIBS)
	$(MKDIR_P) tests/bench
	$${CXX:-g++} -O2 $(DEFS) $(AM_CPPFLAGS) -fopenmp -o $@ $(srcdir)/tests/bench/relaxation.cc $(RELAX_LIBS) -llz4 -lm
bench-relaxation: tests/bench/relaxation-times
	tests/bench/relaxation-times $${RUNS:-5}
CLEANFILES += tests/bench/relaxation-times
.PHONY: bench-relaxation
