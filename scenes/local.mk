# Scenes of caustics. `make scenes` renders them into pictures/ of the build directory; `make pictures/ring.png` one of them,
# SCENES_FLAGS='+W640 +H480 Declare=Photon_Count=1000000' better.
SCENES = cognac cognac_sheets crab dragon egg halogen pool pool_night prism ring rings wine
SCENES_FLAGS = +W320 +H240
EXTRA_DIST += $(SCENES:%=scenes/%.pov) scenes/cognac.png scenes/dragon.py scenes/relaxation.png
CLEANFILES += pictures/*.png pictures/dragon.inc

scenes: $(SCENES:%=pictures/%.png)
.PHONY: scenes

pictures/%.png: $(srcdir)/scenes/%.pov cognac$(EXEEXT)
	@$(MKDIR_P) pictures
	./cognac +Lpictures $(SCENES_FLAGS) $< +O$@

pictures/dragon.png: pictures/dragon.inc
pictures/dragon.inc: $(srcdir)/scenes/dragon.py
	@$(MKDIR_P) pictures
	python3 $< >$@.new && mv $@.new $@

# Figures 1, 6, 8 and 9 of Spencer and Jones (2013) with scenes of ours, into figures/ of the build
# directory, at a quarter of the counts: about ten minutes of two processors. A run that was stopped
# goes on. `make figures-relaxation FIGURES_SHARE=1` for the counts of the paper, which takes an hour
# and more, 0.05 for a quick look; FIGURES="6 8" for some; figure 0 is scenes/relaxation.png.
FIGURES = 0 1 6 8 9
FIGURES_SHARE = 0.25
EXTRA_DIST += scenes/figures
figures-relaxation: cognac$(EXEEXT) cognac-layer$(EXEEXT)
	COGNAC='$(abs_builddir)/cognac' LAYER='$(abs_builddir)/cognac-layer' SOURCES='$(srcdir)' \
		sh $(srcdir)/scenes/figures/figures.sh figures $(FIGURES_SHARE) $(FIGURES)
.PHONY: figures-relaxation
