#!/bin/sh
# Every scene of the gallery renders without a warning and stores photons.
. "$SOURCES/tests/cli/common.sh"

python3 "$SOURCES/scenes/dragon.py" >dragon.inc || fail "dragon.py"
for scene in "$SOURCES"/scenes/*.pov; do
	name=$(basename "$scene" .pov)
	"$COGNAC" "$scene" +L. +W32 +H24 -A Declare=Photon_Count=2000 +FE "+O$name.exr" \
		>out 2>err || fail "$name: $(cat err)"
	grep -qi warning err && fail "$name: $(cat err)"
	grep -q '^photons stored *[1-9]' err out || fail "$name stores no photons"
done
cmp -s cognac.exr cognac_sheets.exr && fail "the sheets of the cognac are not drawn"
finish
