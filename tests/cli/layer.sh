#!/bin/sh
# cognac-layer: names, colours against those of the picture itself, false colours of known values,
# and what it refuses.
. "$SOURCES/tests/cli/common.sh"

{
	echo '#version unofficial cognac 1.0;'
	sed 's/count 4000/& relaxation { constrained } estimator { nearest { count 2500 } }/
		/^#version/d' caustic.pov
} >relaxed.pov
status 0 relaxed.pov +W40 +H30 +FE +Op.exr
status 0 relaxed.pov +W40 +H30 +Op.png

"$LAYER" p.exr >names 2>err || fail "no names: $(cat err)"
for layer in RGBA N Z albedo caustic direct photons.constraint photons.count photons.edges \
	photons.parameter; do
	[ "$(grep -c "^$layer [-0-9.e]* [-0-9.e]*$" names)" = 1 ] ||
		fail "$layer is not named once: $(cat names)"
	"$LAYER" -o "l.$layer.png" p.exr "$layer" 2>err || fail "$layer: $(cat err)"
done
[ "$(wc -l <names)" = 10 ] || fail "other layers: $(cat names)"
"$LAYER" p.exr photons.edges && same p.photons.edges.png l.photons.edges.png "the file's own name"
grep -q '^photons.count 0 2500$' names ||
	fail "2500 photons are told as $(grep photons.count names)"
grep -q '^photons.edges 0 3$' names || fail "three edges are told as $(grep photons.edges names)"

# Half floats and PNG's rounding: two steps of 255 at most.
"$COMPARE" l.RGBA.png p.png | awk '$1 == "RMSE" { exit !($2 < 0.004) }' ||
	fail "RGBA is not the picture"

# pixel FILE X Y: its values from 0 to 255, of a PNG turned into PPM by cognac itself.
pixel()
{
	echo "#version 3.7; global_settings { assumed_gamma 1 }
		camera { orthographic location -z right 40*x up 30*y }
		plane { z, 0
		pigment { image_map { png \"$1\" } translate -0.5 scale <40, 30, 1> }
		finish { ambient 0 diffuse 0 emission 1 } }" >show.pov
	status 0 show.pov +W40 +H30 +FP +Oshow.ppm
	tail -c 3600 show.ppm |
		od -An -v -tu1 -w3 | sed -n "$(($3 * 40 + $2 + 1))p" | tr -s ' ' | sed 's/^ //'
}

# So many photons, more than any pixel here holds, and three edges are the largest values: red,
# darkened; what sees the sky is black.
"$LAYER" --unlit -o count.png p.exr photons.count
[ "$(pixel count.png 15 18)" = "242 64 38" ] ||
	fail "2500 of 2500 photons are $(pixel count.png 15 18)"
[ "$(pixel count.png 20 0)" = "0 0 0" ] || fail "no photons are $(pixel count.png 20 0)"
"$LAYER" --unlit --range=0,5000 -o half.png p.exr photons.count
[ "$(pixel half.png 15 18)" = "77 217 77" ] ||
	fail "2500 of 5000 photons are $(pixel half.png 15 18)"
"$LAYER" --exposure=0.000001 -o dark.png p.exr photons.count
[ "$(pixel dark.png 15 18)" = "0 0 0" ] ||
	fail "in the dark all photons are $(pixel dark.png 15 18)"

# refuse WORD...: a message and no file.
refuse()
{
	"$LAYER" "$@" >out 2>err && fail "takes $*"
	[ -s err ] || fail "refuses $* without a message"
	[ ! -e never.png ] || fail "$* left a file"
}
refuse
refuse -o never.png p.exr nonsense
refuse -o never.png p.png RGBA
refuse -o never.png missing.exr RGBA
refuse -o never.png --range=3,2 p.exr Z
refuse -o never.png --range=3 p.exr Z
grep -q 'cognac-layer: --range wants LEAST,MOST, not 3' err ||
	fail "a bad range is told as $(cat err)"
refuse -o never.png --exposure=0 p.exr Z
refuse -o never.png p.exr Z N
refuse -o missing/never.png p.exr Z
finish
