include tests/unit/geom.mk
include tests/unit/surface.mk
include tests/unit/light.mk
include tests/unit/scene.mk
include tests/unit/image.mk
include tests/unit/render.mk
include tests/unit/base.mk
include tests/unit/lang.mk
include tests/unit/parser.mk
include tests/unit/cli.mk
include tests/unit/photon.mk
include tests/unit/density.mk
include tests/unit/caustic.mk
# Tests that are scripts. They find the programs and the sources in their environment.
TEST_EXTENSIONS = .sh
SH_LOG_COMPILER = $(SHELL)
AM_TESTS_ENVIRONMENT = COGNAC='$(abs_builddir)/cognac'; COMPARE='$(abs_builddir)/cognac-compare'; \
	LAYER='$(abs_builddir)/cognac-layer'; MERGE='$(abs_builddir)/cognac-merge'; SOURCES='$(abs_srcdir)'; \
	export COGNAC COMPARE LAYER MERGE SOURCES;
check_SCRIPTS += tests/layering.sh
EXTRA_DIST += tests/layering.sh

# The command line and the manual pages.
CLI_TESTS = tests/cli/animation.sh tests/cli/dispersion.sh tests/cli/estimators.sh tests/cli/figures.sh tests/cli/ini.sh \
	tests/cli/interrupt.sh tests/cli/layer.sh tests/cli/limits.sh tests/cli/make.sh tests/cli/merge.sh \
	tests/cli/output.sh tests/cli/photon_scale.sh tests/cli/photon_words.sh tests/cli/photons.sh \
	tests/cli/progressive.sh tests/cli/references.sh tests/cli/room.sh tests/cli/ply.sh \
	tests/cli/scenes.sh tests/cli/words.sh tests/man.sh
check_SCRIPTS += $(CLI_TESTS)
EXTRA_DIST += $(CLI_TESTS) tests/cli/common.sh tests/cli/read_ply.py

# POV-Ray's samples: a few of them in `make check`, all of them in `make check-povray`.
check_SCRIPTS += tests/povray/subset.sh tests/povray/features.sh
EXTRA_DIST += tests/povray/samples.py tests/povray/subset.sh tests/povray/subset.txt \
	tests/povray/features.sh tests/povray/features
SAMPLES_FLAGS =
check-povray: cognac$(EXEEXT) cognac-compare$(EXEEXT)
	python3 $(srcdir)/tests/povray/samples.py --cognac ./cognac --compare ./cognac-compare $(SAMPLES_FLAGS)
.PHONY: check-povray

# How the figures of the pattern tests were measured.
EXTRA_DIST += tests/measure_noise.py tests/measure_patterns.sh

# Golden tests of error messages.
check_SCRIPTS += tests/errors.sh
EXTRA_DIST += tests/errors.sh tests/errors

# How fast text is read, against POV-Ray.
EXTRA_DIST += tests/bench/language.sh
bench-language: cognac$(EXEEXT)
	COGNAC=./cognac bash $(srcdir)/tests/bench/language.sh
.PHONY: bench-language

include tests/bench/relaxation.mk

# How fast photons are traced, sorted into the search tree and found again, against others.
EXTRA_DIST += tests/bench/photons.sh tests/bench/photon_stage.py tests/bench/photon_tree.cc \
	tests/bench/photon_rays.c
tests/bench/photon-rays: tests/bench/photon_rays.c $(COGNAC_ROOMS) libimage.a libbase.a
	$(MKDIR_P) tests/bench
	$(COMPILE) -o $@ $(srcdir)/tests/bench/photon_rays.c -Wl,--wrap=accel_nearest $(COGNAC_ROOMS) libimage.a \
		libbase.a $(COGNAC_LIBS) $(AM_LDFLAGS) $(LIBS)
CLEANFILES += tests/bench/photon-rays
bench-photons: cognac$(EXEEXT) tests/bench/photon-rays libphoton.a libbase.a
	COGNAC=./cognac SOURCES=$(srcdir) bash $(srcdir)/tests/bench/photons.sh
.PHONY: bench-photons

clean-local:
	-rm -rf povray-cache

# Caustics beside POV-Ray's: `make check-brightness` (minutes; needs povray and povray-examples).
EXTRA_DIST += tests/photon-brightness.py tests/photons
check-brightness: cognac$(EXEEXT)
	python3 $(srcdir)/tests/photon-brightness.py --cognac $(abs_builddir)/cognac$(EXEEXT)
.PHONY: check-brightness

# Reference pictures of the scenes' caustics, seen close, for hours: `make references`, stop it and
# call it again at will, with REFERENCES_FLAGS='--photons 30e6 prism' for fewer photons or some of
# the scenes. And how far the estimators are from them: `make bench-caustics`, with
# CAUSTICS_FLAGS='--scene prism --counts 60k --sheet' and more that --help tells. Needs numpy.
WITH_NUMPY = /usr/bin/python3
CAUSTICS_FILES = references.py caustics.py caustic_edges.py caustic_scenes.py caustic_sheet.py exr.py
EXTRA_DIST += $(CAUSTICS_FILES:%=tests/bench/%)
CAUSTICS_WORDS = --cognac ./cognac --compare ./cognac-compare --scenes $(srcdir)/scenes \
	--library pictures
references: cognac$(EXEEXT) cognac-compare$(EXEEXT) pictures/dragon.inc
	$(WITH_NUMPY) $(srcdir)/tests/bench/references.py $(CAUSTICS_WORDS) \
		--folder references $(REFERENCES_FLAGS)
bench-caustics: cognac$(EXEEXT) cognac-compare$(EXEEXT) pictures/dragon.inc
	$(WITH_NUMPY) $(srcdir)/tests/bench/caustics.py $(CAUSTICS_WORDS) \
		--references references $(CAUSTICS_FLAGS)
.PHONY: references bench-caustics

# Footprints beside k nearest photons, on a map from emitter to floor that is known.
EXTRA_PROGRAMS += tests/bench/footprint_trial
tests_bench_footprint_trial_SOURCES = tests/bench/footprint_trial.c tests/bench/known_map.h
tests_bench_footprint_trial_LDADD = libdensity.a libphoton.a libscene.a libsurface.a libbase.a
bench-footprint: tests/bench/footprint_trial$(EXEEXT)
	OMP_NUM_THREADS=1 tests/bench/footprint_trial 15000 60000
.PHONY: bench-footprint

# Ways to look footprints up: our tree, Embree's point queries, splatting.
EXTRA_PROGRAMS += tests/bench/footprint_lookup
tests_bench_footprint_lookup_SOURCES = tests/bench/footprint_lookup.c tests/bench/known_map.h \
	tests/bench/wave.h
tests_bench_footprint_lookup_LDADD = libdensity.a libphoton.a libscene.a libsurface.a libbase.a $(EMBREE_LIBS)
bench-footprint-lookup: tests/bench/footprint_lookup$(EXEEXT)
	OMP_NUM_THREADS=1 tests/bench/footprint_lookup
.PHONY: bench-footprint-lookup
