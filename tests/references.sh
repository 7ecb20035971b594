#!/bin/sh
# Reference images of caustics: very many photons in progressive passes, two independent halves a scene, NAME.a.exr and
# NAME.b.exr. Their difference is the error bar: each half's root mean square error of the caustic is about their RMSE over
# the square root of two, which NAME.error tells. Interrupted, or called again, it goes on where it was.
#
# usage: COGNAC=... COMPARE=... sh references.sh FOLDER PASSES SCENE.pov...
folder=$1
passes=$2
shift 2
mkdir -p "$folder" || exit 1
half()
{
	"$COGNAC" "$1" +W320 +H240 +FE +C "+O$folder/$2.exr" --seed "$3" --passes "$passes" --update 60 -V
}
for scene in "$@"; do
	name=$(basename "$scene" .pov)
	half "$scene" "$name.a" 1 && half "$scene" "$name.b" 2 || exit
	"$COMPARE" --layer caustic "$folder/$name.a.exr" "$folder/$name.b.exr" |
		awk '$1 == "RMSE" { printf "caustic RMSE of a half %.6g\n", $2 / sqrt(2) }' >"$folder/$name.error"
	echo "$name: $(cat "$folder/$name.error")"
done
