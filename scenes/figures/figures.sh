#!/bin/sh
# Figures 1, 6, 8 and 9 of Spencer and Jones (2013) with scenes of ours: FOLDER/figure1.png ... A panel is a file; those that are
# there are left alone, so a run that was stopped goes on. Every panel of a scene shows the same photons. Figure 0 is README's.
#
# usage: COGNAC=... LAYER=... SOURCES=... sh figures.sh FOLDER SHARE FIGURE...     SHARE: of the photons, 1 for the paper's counts
set -eu
folder=$1
share=$2
shift 2
here=$(cd "$SOURCES" && pwd)/scenes
mkdir -p "$folder"
cd "$folder"

fine='+A0.1 +R2'

# panel NAME SCENE METHOD PHOTONS WORD...: NAME.exr of a scene, method as in panel.inc, from so many of the scene's paths.
panel()
{
	name=$1
	scene=$here/$2
	method=$3
	photons=$4
	shift 4
	[ ! -f "$name.exr" ] || [ -f "$name.exr.state" ] || return 0
	echo "$name"
	"$COGNAC" "$scene" "+HI$here/figures/panel.inc" "Declare=Method=$method" "Declare=Photons=$photons" "Declare=Share=$share" \
		+FE +C -V "+O$name.exr" --stats "$name.json" "$@"
}

# The same from the photons that landed in an earlier panel of the scene, or for that panel to come.
panel_of()
{
	map=$1.ply
	shift
	if [ -f "$map" ]; then
		panel "$@" --load-photons "$map"
	else
		panel "$@" --photons-landed "$map"
	fi
}

# draw NAME LAYER OUT [WORD...]
draw()
{
	source=$1.exr
	layer=$2
	out=$3.png
	shift 3
	"$LAYER" "$@" -o "$out" "$source" "$layer"
}

# sheet FIGURE WIDTH HEIGHT: the panels with captions that tell how many photons there are, from FIGUREa.json.
sheet()
{
	count=$(sed -n 's/.*"stored": \([0-9]*\).*/\1/p' "$1a.json" | head -n 1)
	rm -f "figure$1.png"
	"$COGNAC" "$here/figures/figure$1.pov" "+L$here/figures" "+W$2" "+H$3" +A0.1 +R3 -V "+Ofigure$1.png" "Declare=Stored=$count"
	echo "$folder/figure$1.png"
}

# A glass with liquid that was shaken: noise, plain relaxation and ours.
figure1()
{
	crop="+W1600 +H1200 +SC641 +EC1120 +SR781 +ER1140 $fine"
	for method in 0 1 3; do
		# shellcheck disable=SC2086
		panel_of 1 1-$method cognac.pov $method 2000000 $crop
		draw 1-$method RGBA 1-$method
	done
	ln -sf 1-0.json 1a.json
	sheet 1 1468 402
}

# A prism: the methods, what relaxation knows of its photons, and a reference.
figure6()
{
	for method in 0 1 2 3; do
		# shellcheck disable=SC2086
		panel_of 6 6-$method figures/prism.pov $method 5850000 +W480 +H360 $fine
		draw 6-$method RGBA 6-$method
	done
	panel 6-4 figures/prism.pov 4 500000 +W480 +H360 Declare=Radius=0.05
	draw 6-4 RGBA 6-4
	draw 6-3 photons.parameter 6-e --exposure=1.5
	draw 6-3 photons.edges 6-f --exposure=1.5 --range=3,6
	draw 6-3 photons.constraint 6-g --exposure=1.5
	ln -sf 6-0.json 6a.json
	sheet 6 1956 788
}

# A lamp with a faceted reflector over a chair.
figure8()
{
	for method in 0 1 2 3; do
		# shellcheck disable=SC2086
		panel_of 8 8-$method figures/lamp.pov $method 1200000 +W480 +H400 $fine
		draw 8-$method RGBA 8-$method
	done
	draw 8-3 photons.parameter 8-d
	draw 8-3 photons.constraint 8-e
	ln -sf 8-0.json 8a.json
	sheet 8 1468 876
}

# Rings and coins, with 134,000, 670,000 and 3.3 million photons.
figure9()
{
	for photons in 466000 2330000 11500000; do
		# shellcheck disable=SC2086
		panel 9-$photons figures/rings.pov 3 $photons +W480 +H360 $fine --photons 9-$photons.ply
		draw 9-$photons RGBA 9-$photons
	done
	# shellcheck disable=SC2086
	panel 9-wide rings.pov 3 2330000 +W480 +H360 $fine --load-photons 9-2330000.ply
	draw 9-wide RGBA 9-wide
	panel 9-4 figures/rings.pov 4 500000 +W480 +H360 Declare=Radius=0.08
	draw 9-4 RGBA 9-4
	ln -sf 9-2330000.json 9a.json
	sheet 9 2444 402
}

# Before and after, small: scenes/relaxation.png is this.
figure0()
{
	for method in 0 3; do
		# shellcheck disable=SC2086
		panel_of 0 0-$method figures/prism.pov $method 250000 +W360 +H270 $fine
		draw 0-$method RGBA 0-$method
	done
	ln -sf 0-0.json 0a.json
	sheet 0 740 308
}

for figure in "$@"; do
	"figure$figure"
done
