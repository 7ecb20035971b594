#!/bin/sh
# Photon maps as others read them: by a reader that goes by the file's header, and by plyfile and
# trimesh where they are. Maps before and after relaxation; what is read back is not relaxed again.
. "$SOURCES/tests/cli/common.sh"

{
	echo '#version unofficial cognac 1.0;'
	sed 's/count 4000/& relaxation { constrained } #ifdef (Off) relaxation off #end/
		/^#version/d' caustic.pov
} >relaxed.pov

# check STATS MAP...: with every reader that is there.
check()
{
	for reader in header plyfile trimesh; do
		for python in python3 /usr/bin/python3; do
			[ "$reader" = header ] || "$python" -c "import $reader" 2>/dev/null ||
				continue
			"$python" "$SOURCES/tests/cli/read_ply.py" "$reader" "$@" >told 2>&1 ||
				fail "$reader: $(cat told)"
			break
		done
	done
}

status 0 caustic.pov --photons map.ply --stats stats.json +Oplain.png
check stats.json map.ply
grep -q -a relaxed map.ply && fail "photons that stayed are called relaxed"

status 0 relaxed.pov --photons relaxed.ply --photons-landed landed.ply --stats relaxed.json \
	+Orelaxed.png
check relaxed.json landed.ply relaxed.ply
same map.ply landed.ply "before relaxation"
grep -q -a '^comment relaxed$' relaxed.ply ||
	fail "the file does not say that its photons were moved"

# A map from a file is relaxed unless it has been.
status 0 relaxed.pov --load-photons landed.ply --photons again.ply +Oagain.png
same relaxed.ply again.ply "a map relaxed later"
same relaxed.png again.png
status 0 relaxed.pov --load-photons relaxed.ply --stats loaded.json +Oloaded.png
same relaxed.png loaded.png
grep -q '"relaxation"' loaded.json && fail "relaxed twice"
status 1 relaxed.pov --load-photons relaxed.ply --photons-landed never.ply +Onever.png
[ ! -e never.ply ] && [ ! -e never.png ] || fail "moved photons are called landed ones"
# Relaxation that is turned off again.
status 0 relaxed.pov --load-photons landed.ply --photons off.ply -F Declare=Off=1
same landed.ply off.ply "relaxation off"
for word in features ' iterations of ' 'photon tree'; do
	"$COGNAC" relaxed.pov +W8 +H6 -F 2>&1 | grep -q "$word" || fail "no $word in the statistics"
done
finish
