#!/bin/sh
# A photon map as others read it: python3-plyfile or trimesh, whichever is there.
. "$SOURCES/tests/cli/common.sh"

python=
for candidate in python3 /usr/bin/python3; do
	for reader in plyfile trimesh; do
		[ -n "$python" ] || ! "$candidate" -c "import $reader" 2>/dev/null || python=$candidate
	done
done
if [ -z "$python" ]; then
	echo "$0: skipped: neither plyfile nor trimesh is there"
	exit 77
fi
status 0 caustic.pov --photons map.ply --stats stats.json +Opicture.png
"$python" "$SOURCES/tests/cli/read_ply.py" map.ply stats.json >out 2>&1 || fail "$(cat out)"
finish
