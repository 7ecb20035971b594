#!/bin/sh
# Figures 1, 6, 8 and 9 of Spencer and Jones (2013) with scenes of ours: FOLDER/figure1.png ... A
# panel is a file; those that are there are left alone, so a run that was stopped goes on. Every
# panel of a scene shows the same photons. Figure 0 is README's.
#
# usage: COGNAC=... LAYER=... SOURCES=... sh figures.sh FOLDER SHARE FIGURE...
# SHARE: of the photons, 1 for the paper's counts where it tells them
set -eu
folder=$1
share=$2
shift 2
here=$(cd "$SOURCES" && pwd)/scenes
mkdir -p "$folder"
cd "$folder"

fine='+A0.1 +R2'

# panel NAME SCENE METHOD PHOTONS WORD...: NAME.exr of a scene, method as in panel.inc, from so many
# of the scene's paths.
panel()
{
	name=$1
	scene=$here/$2
	method=$3
	photons=$4
	shift 4
	[ ! -f "$name.exr" ] || [ -f "$name.exr.state" ] || return 0
	echo "$name"
	"$COGNAC" "$scene" "+HI$here/figures/panel.inc" "Declare=Method=$method" \
		"Declare=Photons=$photons" "Declare=Share=$share" +FE +C -V "+O$name.exr" \
		--stats "$name.json" "$@"
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

# panels FIGURE METHODS SCENE PHOTONS WORD...: one by each method, FIGURE-METHOD.png, all from the
# same photons.
panels()
{
	figure=$1
	methods=$2
	shift 2
	first=$1
	paths=$2
	shift 2
	for way in $methods; do
		panel_of "$figure" "$figure-$way" "$first" "$way" "$paths" "$@"
		draw "$figure-$way" RGBA "$figure-$way"
	done
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

# stored NAME: how many photons the panel shows, for captions.
stored()
{
	sed -n 's/.*"stored": \([0-9]*\).*/\1/p' "$1.json" | head -n 1
}

# sheet FIGURE WIDTH HEIGHT WORD...: the panels with captions.
sheet()
{
	figure=$1
	width=$2
	height=$3
	shift 3
	rm -f "figure$figure.png"
	"$COGNAC" "$here/figures/figure$figure.pov" "+L$here/figures" "+W$width" "+H$height" \
		+A0.1 +R3 -V "+Ofigure$figure.png" "$@"
	echo "$folder/figure$figure.png"
}

# A glass with liquid that was shaken: noise, plain relaxation, constrained as the paper has it, and
# ours.
figure1()
{
	# shellcheck disable=SC2086
	panels 1 '0 1 6 3' cognac.pov 2000000 \
		+W1600 +H1200 +SC641 +EC1120 +SR781 +ER1140 $fine
	sheet 1 1956 402 "Declare=Stored=$(stored 1-0)"
}

# A prism: the methods, what relaxation knows of its photons, and a reference.
figure6()
{
	# shellcheck disable=SC2086
	panels 6 '0 1 2 3' figures/prism.pov 2560000 +W480 +H360 $fine
	panel 6-4 figures/prism.pov 4 500000 +W480 +H360 Declare=Radius=0.035
	draw 6-4 RGBA 6-4
	draw 6-3 photons.parameter 6-e --exposure=1.5
	draw 6-3 photons.edges 6-f --exposure=1.5 --range=3,6
	draw 6-3 photons.constraint 6-g --exposure=1.5
	sheet 6 1956 788 "Declare=Stored=$(stored 6-0)"
}

# A lamp with a faceted reflector over a chair. The paper does not tell how many photons it took; of
# fewer than a million the facets' patches are lost.
figure8()
{
	# shellcheck disable=SC2086
	panels 8 '0 1 2 3' figures/lamp.pov 4800000 +W480 +H400 $fine
	draw 8-3 photons.parameter 8-d
	draw 8-3 photons.constraint 8-e
	sheet 8 1468 876 "Declare=Stored=$(stored 8-0)"
}

# paths_of PANEL: so many paths leave 134,000, 670,000 and 3.3 million photons there.
paths_of()
{
	case $1 in
	a) echo 401000 ;;
	b) echo 2006000 ;;
	c) echo 9880000 ;;
	esac
}

# Rings and coins, from few photons to many.
figure9()
{
	for column in a b c; do
		# shellcheck disable=SC2086
		panel 9-$column figures/rings.pov 3 "$(paths_of $column)" +W480 +H360 $fine \
			--photons 9-$column.ply
		draw 9-$column RGBA 9-$column
	done
	# shellcheck disable=SC2086
	panel 9-wide rings.pov 3 "$(paths_of b)" +W480 +H360 $fine --load-photons 9-b.ply
	draw 9-wide RGBA 9-wide
	panel 9-4 figures/rings.pov 4 500000 +W480 +H360 Declare=Radius=0.035
	draw 9-4 RGBA 9-4
	sheet 9 2444 402 "Declare=Stored_A=$(stored 9-a)" "Declare=Stored_B=$(stored 9-b)" \
		"Declare=Stored_C=$(stored 9-c)"
}

# Before and after, small: scenes/relaxation.png is this, at a share of 0.4.
figure0()
{
	# shellcheck disable=SC2086
	panels 0 '0 3 5' figures/prism.pov 250000 +W360 +H270 $fine
	sheet 0 1108 308 "Declare=Stored=$(stored 0-0)"
}

for figure in "$@"; do
	"figure$figure"
done
