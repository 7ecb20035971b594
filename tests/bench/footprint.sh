#!/bin/sh
# The footprint estimator beside k nearest photons on the scenes: root mean square error of the
# caustic layer at 160x120, the same photons for all, about 60,000 of them, against a mean of
# progressive passes of k nearest, each with five times the photons. What is in the folder already
# is not made again, so it may be stopped and called again; delete the folder after changes of the
# renderer.
#
# usage: COGNAC=... COMPARE=... SOURCES=... TRIAL=... sh footprint.sh FOLDER [PASSES]
folder=$1
passes=${2:-50}
mkdir -p "$folder" || exit 1
"$TRIAL" 15000 60000
render()
{
	picture=$1
	shift
	test -f "$folder/$picture" && return
	"$COGNAC" +W160 +H120 +FE +A0.0 +AM1 +R2 -V "+L$SOURCES/scenes" "$@" "+O$folder/new.exr" &&
		mv "$folder/new.exr" "$folder/$picture"
}

# SCENE NAME ESTIMATOR
measure()
{
	{
		printf '#version unofficial cognac 1.0;\n#include "%s.pov"\n' "$1"
		printf 'global_settings { photons { estimator { %s } } }\n' "$3"
	} >"$folder/with-$1.pov"
	render "$1.$2.exr" --load-photons "$folder/$1.ply" "$folder/with-$1.pov" || exit
	"$COMPARE" --layer caustic "$folder/$1.$2.exr" "$folder/$1.reference.exr" |
		awk -v name="$1 $2" '$1 == "RMSE" { printf "%-24s %s\n", name, $2 }'
}

# Paths that leave about 60,000 photons.
for scene in prism:1500000 cognac:200000 halogen:115000 egg:300000 pool:80000; do
	paths=${scene#*:}
	scene=${scene%:*}
	source=$SOURCES/scenes/$scene.pov
	render "$scene.reference.exr" --estimator nearest --passes "$passes" --seed 77 \
		"Declare=Photon_Count=$((5 * paths))" "$source" || exit
	test -f "$folder/$scene.ply" ||
		"$COGNAC" +W8 +H6 -V -F --photons "$folder/$scene.ply" \
			"Declare=Photon_Count=$paths" "$source" || exit
	for count in 8 15 25 50 100 200; do
		measure "$scene" "nearest-$count" "nearest { count $count }"
	done
	measure "$scene" footprint footprint
done
