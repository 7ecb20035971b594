#!/bin/sh
# A few of POV-Ray's samples, small and quick: every one that subset.txt names must match POV-Ray's
# picture.
command -v python3 >/dev/null || exit 77
list=$SOURCES/tests/povray/subset.txt
wanted=$(grep -vc '^ *\(#\|$\)' "$list")
exec python3 "$SOURCES/tests/povray/samples.py" --cognac "$COGNAC" --compare "$COMPARE" \
	--cache povray-cache --list "$list" --expect "$wanted"
