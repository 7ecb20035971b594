#!/bin/sh
# Photons: how much light lands and where, against closed forms; who gets photons; map files;
# passes; the same for any threads.
. "$SOURCES/tests/cli/common.sh"

# A pane of 2 x 2 over a white floor, light at <0, 10, 0>; each part can be replaced from the
# command line.
cat >pane.pov <<'END'
#version unofficial cognac 1.0;
#ifndef (Kind) #declare Kind = 0; #end
#ifndef (Ior) #declare Ior = 1.0001; #end
#ifndef (Fade) #declare Fade = 0; #end
#ifndef (Unit) #declare Unit = 1; #end
#ifndef (Levels) #declare Levels = 10; #end
#ifndef (Share) #declare Share = 1; #end
#ifndef (Case) #declare Case = 0; #end
#ifndef (Dispersion) #declare Dispersion = 1; #end
global_settings {
  assumed_gamma 1 max_trace_level 10
  photons { count 100000 max_trace_level Levels }
}
camera { orthographic location Unit * y look_at 0 right 1.6 * Unit * x up 1.6 * Unit * z }
#macro Lamp(Power)
  light_source {
    10 * Unit * y, Power
    #switch (Kind)
      #case (1) parallel point_at 0 #break
      #case (2) spotlight point_at 0 radius 3 falloff 3 tightness 0 #break
    #end
    #if (Fade) fade_distance Fade * Unit fade_power 2 #end
    photons { refraction on reflection off share Share }
  }
#end
#macro Pane()
  box {
    <-1, 5, -1> * Unit, <1, 5.01, 1> * Unit
    pigment { rgbt 1 } finish { ambient 0 diffuse 0 }
    interior { ior Ior dispersion Dispersion }
    #if (Case = 2) no_image #end
    photons { target refraction on reflection off collect off }
  }
#end
#if (Case = 1)
  light_group { Lamp(0.5) Pane() global_lights off }
#else
  Lamp(0.5) Pane()
#end
#if (Case = 3)
  box { <-3, 7, -3>, <3, 7.1, 3> pigment { rgb 1 } }
#end
#if (Case = 4)
  box { <-3, 7, -3>, <3, 7.1, 3> pigment { rgb 1 } no_shadow }
#end
#if (Case = 6)
  box { <-3, 7, -3>, <3, 7.1, 3> pigment { rgbt 0.5 } interior { ior 2 } photons { pass_through } }
#end
#if (Case = 7)
  box { <-3, 7, -3>, <3, 7.1, 3> pigment { rgb 1 } no_shadow photons { pass_through off } }
#end
plane { y, 0 pigment { rgb 1 } finish { ambient 0 diffuse 1 } photons { collect (Case != 5) } }
END

# shoot WORD...: renders pane.pov; statistics in s.json, picture in p.ppm.
shoot()
{
	status 0 pane.pov +W32 +H32 +FP16 File_Gamma=1 +Op.ppm --stats s.json "$@"
}

# statistic NAME: a count of photons.
statistic()
{
	tr ',{}' '\n\n\n' <s.json | sed -n "s/^ *\"$1\": *//p" | head -n 1
}

# near WHAT GOT WANTED [TOLERANCE]: within one part in a hundred.
near()
{
	awk "BEGIN { d = ($2 + 0) - ($3); exit !(d * d <= (${4:-0.01} * ($3)) ^ 2) }" ||
		fail "$1 is $2, not $3"
}

# The mean of a 16-bit picture's channel, 0 to 2, in 0 to 1.
channel()
{
	tail -c 6144 "${2:-p.ppm}" | od -An -v -tu1 -w6 |
		awk -v c="$1" '{ s += 256 * $(2 * c + 1) + $(2 * c + 2) }
			END { print s / NR / 65535 }'
}

balance()
{
	sum=$(awk "BEGIN { print $(flux stored) + $(flux absorbed) + $(flux escaped) }")
	near "$1: stored + absorbed + escaped" "$sum" "$(flux emitted)" 1e-5
}

# flux NAME: of the last line's object.
flux()
{
	sed -n 's/.*"flux": {\(.*\)}}.*/\1/p' s.json | tr ',' '\n' | sed -n "s/^ *\"$1\": *//p"
}

# ---- energy: the pane's share of the sphere, the disc or the plane, at the first surface, 4.99
# from a point light ----
side=$(awk 'BEGIN { h = 4.99; n = 400; for (i = 0; i < n; i++) for (j = 0; j < n; j++) {
	x = -1 + (i + 0.5) * 2 / n; z = -1 + (j + 0.5) * 2 / n
	s += h / sqrt(x * x + h * h + z * z) }
	print s * 4 / n / n }')
for ior in 1.0001 1.5; do
	shoot Declare=Ior=$ior
	near "point light, flux, ior $ior" "$(flux emitted)" "0.5 * $side"
	balance "point light, ior $ior"
	near "point light, brightness, ior $ior" "$(channel 0)" 0.5 0.02
	shoot Declare=Kind=1 Declare=Ior=$ior
	near "parallel light, flux, ior $ior" "$(flux emitted)" "0.5 * 4"
	near "parallel light, landed, ior $ior" "$(flux stored)" "0.5 * 4"
	near "parallel light, brightness, ior $ior" "$(channel 0)" 0.5
	shoot Declare=Kind=2 Declare=Ior=$ior
	near "spotlight, flux, ior $ior" "$(flux emitted)" \
		"0.5 * 6.283185 * 4.99 ^ 2 * (1 / cos(0.05235988) - 1)"
	balance "spotlight, ior $ior"
done
# As bright as without the pane, for lights that fade with the square of the distance as well.
shoot Declare=Fade=2
near "fading light, brightness" "$(channel 0)" "0.5 * 2 / (1 + 25)" 0.02

# ---- the same bits, the same picture ----
shoot +WT1 --photons one.ply && mv p.ppm one.ppm
shoot +WT3 --photons three.ply
same one.ppm p.ppm "threads"
same one.ply three.ply "threads"
shoot --load-photons one.ply
same one.ppm p.ppm "a map from a file"
shoot --passes 3 +WT1 && mv p.ppm three_passes.ppm
shoot --passes 3 +WT2
same three_passes.ppm p.ppm "threads and passes"
shoot Declare=Fade=4
mv p.ppm unit.ppm
for unit in 1000 0.001; do
	shoot Declare=Fade=4 Declare=Unit=$unit
	near "brightness in units of $unit" "$(channel 0)" "$(channel 0 unit.ppm)" 0.001
	"$COMPARE" unit.ppm p.ppm | awk '$1 == "SSIM" { exit !($2 > 0.98) }' ||
		fail "in units of $unit the picture differs"
done

# ---- who gets photons ----
shoot; all=$(statistic stored)
shoot Declare=Case=1; near "photons with light_group" "$(flux emitted)" "0.5 * $side"
[ "$(statistic stored)" = 0 ] ||
	fail "photons of a light_group lie on what the group does not light"
shoot Declare=Case=2; [ "$(statistic stored)" = "$all" ] || fail "no_image changes the photons"
shoot Declare=Case=3; [ "$(statistic stored)" = 0 ] || fail "photons pass an opaque roof"
shoot Declare=Case=4; [ "$(statistic stored)" = "$all" ] ||
	fail "photons do not pass a roof with no_shadow"
# POV-Ray tints what passes, once for each surface: 0.1245 was measured.
shoot Declare=Case=6
near "brightness below a grey roof with pass_through" "$(channel 0)" "0.5 * 0.5 ^ 2"
[ "$(statistic stored)" = "$all" ] || fail "pass_through bends photons"
shoot Declare=Case=7; [ "$(statistic stored)" = 0 ] ||
	fail "photons pass a roof with pass_through off"
shoot Declare=Case=5; [ "$(statistic stored)" = 0 ] || fail "collect off collects"
shoot Declare=Share=3; near "brightness with a share" "$(channel 0)" 0.5 0.02
shoot Declare=Levels=1 Declare=Ior=1.5
[ $(($(statistic stored) * 1000)) -lt "$all" ] || fail "more levels than max_trace_level"

# Light of all hues together is white.
shoot Declare=Kind=1 Declare=Ior=1.5 Declare=Dispersion=1.1
near "dispersed light, green" "$(channel 1)" "$(channel 0)" 0.02
near "dispersed light, blue" "$(channel 2)" "$(channel 0)" 0.02

# ---- files that are none ----
echo nonsense >bad.ply
status 1 pane.pov +Onever.png --load-photons bad.ply
grep -q "bad.ply" err || fail "no word about the map: $(cat err)"
head -c 5000 one.ply >short.ply
status 1 pane.pov +Onever.png --load-photons short.ply
status 1 pane.pov +Onever.png --load-photons missing.ply
status 1 pane.pov +Onever.png --photons missing/map.ply
status 1 pane.pov +Onever.png --passes 2 --photons never.ply
status 1 pane.pov +Onever.png --passes 2 --load-photons one.ply
status 1 ball.pov +Onever.png --photons never.ply
status 1 ball.pov +Onever.png --photons-landed never.ply
grep -q "no photons" err || fail "no word about photons that are not there: $(cat err)"
status 1 pane.pov +Onever.png --estimator nonsense
status 1 pane.pov +Onever.png --passes 0
[ -z "$(ls | grep -e never -e '\.part')" ] || fail "left after an error: $(ls)"
finish
