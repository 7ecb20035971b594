# Scenes of caustics. `make scenes` renders them into pictures/ of the build directory; `make pictures/ring.png` one of them,
# SCENES_FLAGS='+W640 +H480 Declare=Photon_Count=1000000' better.
SCENES = cognac crab dragon egg halogen pool pool_night prism ring rings wine
SCENES_FLAGS = +W320 +H240
EXTRA_DIST += $(SCENES:%=scenes/%.pov) scenes/cognac.png scenes/dragon.py
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

# What pictures are measured against: many progressive passes, as two halves that differ in the seed; their difference is the
# error bar. A run that was stopped goes on. Passes, photons and radius stand in the EXR's header.
REFERENCES_PASSES = 200
REFERENCES_FLAGS = +W320 +H240
REFERENCE = ./cognac +Lpictures $(REFERENCES_FLAGS) --passes $(REFERENCES_PASSES) +C +FE $< +O$@
references: $(SCENES:%=references/%-1.exr) $(SCENES:%=references/%-2.exr)
.PHONY: references

references/%-1.exr: $(srcdir)/scenes/%.pov
	@$(MKDIR_P) references
	$(REFERENCE) --seed 1
references/%-2.exr: $(srcdir)/scenes/%.pov
	@$(MKDIR_P) references
	$(REFERENCE) --seed 2
references/dragon-1.exr references/dragon-2.exr: pictures/dragon.inc
