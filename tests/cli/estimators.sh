#!/bin/sh
# Every estimator on photons as they landed and relaxed, plain and under constraints, where one
# object among others keeps its own in place: as much light as landed, the same picture.
. "$SOURCES/tests/cli/common.sh"

# A ball's caustic, seen from above on a floor of two halves. A roof leaves a hole for the ball
# alone, and the ball's shadow is the photons'; neither is seen, so the picture is the photons'
# light.
cat >floor.pov <<'END'
#version unofficial cognac 1.0;
#ifndef (Count) #declare Count = 10000; #end
#ifndef (Moved) #declare Moved = 0; #end
#ifndef (Method) #declare Method = 0; #end
#ifndef (Half) #declare Half = 0; #end
#declare Estimators = array[7] {
  estimator { nearest { count 15 kernel uniform } }
  estimator { nearest { count 15 kernel cone } }
  estimator { nearest { count 15 kernel epanechnikov } }
  estimator { nearest { count 15 kernel gaussian } }
  estimator { nearest { radius 0.08 } }
  estimator { diffusion { count 60 } }
  estimator { footprint }
}
global_settings {
  assumed_gamma 1 max_trace_level 5
  photons {
    count Count
    #if (Moved = 1) relaxation { plain } #end
    #if (Moved = 2) relaxation { constrained } #end
    estimator { Estimators[Method] }
  }
}
camera { orthographic location 1.1 * y look_at 0 right 3.2 * x up 3.2 * z }
light_source { 10 * y rgb 0.02 parallel point_at 0 photons { refraction on reflection off } }
sphere {
  1.3 * y, 1
  pigment { rgbt 1 } finish { ambient 0 diffuse 0 } interior { ior 1.2 } no_image
  photons { target refraction on reflection off collect off }
}
difference {
  box { <-9, 6, -9>, <9, 6.1, 9> }
  cylinder { 5 * y, 7 * y, 0.99 }
  pigment { rgb 1 } no_image
  photons { collect off }
}
#macro Floor(From, To)
  box {
    <From, -0.1, -9>, <To, 0, 9>
    pigment { rgb 1 } finish { ambient 0 diffuse 1 } photons { FloorPhotons() }
  }
#end
#macro FloorPhotons() relaxation off #if (Half) estimator { footprint } #end #end
Floor(-9, 0)
#macro FloorPhotons() collect on #end
Floor(0, 9)
END

# shoot WORD...: p.ppm, s.json
shoot()
{
	status 0 floor.pov +W96 +H96 +FP16 File_Gamma=1 +Op.ppm --stats s.json "$@"
}

# How much light is in the picture, over what landed.
balance()
{
	landed=$(sed -n 's/.*"flux": {.*"stored": \([-0-9.e]*\).*/\1/p' "$1")
	tail -c $((96 * 96 * 6)) p.ppm | od -An -v -tu1 -w6 |
		awk -v f="$landed" '{ s += 256 * $1 + $2 }
			END { print s / NR / 65535 * 3.2 * 3.2 / f }'
}

# near WHAT TOLERANCE: the picture holds the light of the map at hand.
near()
{
	share=$(balance "$moved.json")
	awk "BEGIN { d = $share - 1; exit !(d * d < $2 ^ 2) }" || fail "$1: $share of the light"
}

# rmse FILE FILE X: of the columns from X on, 40 of them.
rmse()
{
	"$COMPARE" --crop "$3,0,40,96" "$1" "$2" | awk '$1 == "RMSE" { print $2 }'
}

# A kernel of fixed width, or of each photon, keeps its light; k nearest photons know their own
# density with some bias.
for moved in 0 1 2; do
	shoot Declare=Moved=$moved --photons $moved.ply
	mv s.json $moved.json
	for method in 0 1 2 3 5; do
		shoot Declare=Moved=$moved Declare=Method=$method --load-photons $moved.ply
		near "method $method on map $moved" 0.08
		[ $method != 2 ] || mv p.ppm $moved.ppm
	done
	for method in 4 6; do
		shoot Declare=Moved=$moved Declare=Method=$method --load-photons $moved.ply
		near "method $method on map $moved" 0.01
	done
	shoot Declare=Moved=$moved Declare=Half=1 --load-photons $moved.ply
	near "two methods on map $moved" 0.05
done
# The picture's right half is the floor that keeps its photons. Kernels are no narrower than pixels,
# so what a photon's move within one changes is small, but more than ten times what the other half
# may.
for moved in 1 2; do
	awk "BEGIN { exit !($(rmse 0.ppm $moved.ppm 56) < 1e-5) }" ||
		fail "photons that shall stay have moved"
	awk "BEGIN { exit !($(rmse 0.ppm $moved.ppm 0) > 1e-4) }" || fail "no photon has moved"
done
finish
