#!/bin/sh
# Scenes of our own, each of many words that POV-Ray's samples hardly use: every one must look as
# POV-Ray renders it, nearer than samples do.
command -v python3 >/dev/null || exit 77
scenes=$SOURCES/tests/povray/features
wanted=$(ls "$scenes"/*.pov | wc -l)
exec python3 "$SOURCES/tests/povray/samples.py" --cognac "$COGNAC" --compare "$COMPARE" \
	--cache povray-cache --examples "$scenes" --match 0.998 --expect "$wanted"
