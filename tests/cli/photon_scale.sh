#!/bin/sh
# Nothing hides in absolute units: a scene a thousand times as large or as small, its fading with
# it, is the same picture, by every estimator and after relaxation. Photons' places are single
# precision numbers, so a few of them go another way at an edge.
. "$SOURCES/tests/cli/common.sh"

cat >ball.pov <<'END'
#version unofficial cognac 1.0;
#ifndef (Unit) #declare Unit = 1; #end
#ifndef (Method) #declare Method = 0; #end
global_settings {
  assumed_gamma 1 max_trace_level 5
  photons {
    count 8000
    #switch (Method)
      #case (1) estimator { nearest { count 30 } } #break
      #case (2) estimator { nearest { radius 0.06 * Unit } } #break
      #case (3) estimator { diffusion { count 60 } } #break
      #case (4) estimator { footprint } #break
      #case (5) estimator { nearest { count 15 } } relaxation { plain } #break
      #case (6) estimator { nearest { count 15 } } relaxation { constrained } #break
      #case (7) progressive { passes 2 } #break
    #end
  }
}
camera { orthographic location 0.2 * Unit * y look_at 0 right 2 * Unit * x up 2 * Unit * z }
light_source { <-4, 8, 1> * Unit, 0.3 fade_distance 5 * Unit fade_power 2 }
plane { y, 0 pigment { rgb 1 } finish { ambient 0 diffuse 1 } }
sphere {
  1.3 * Unit * y, Unit
  pigment { rgbt 1 } finish { ambient 0 diffuse 0 reflection { 0, 1 fresnel } conserve_energy }
  interior { ior 1.2 fade_distance Unit fade_power 1 fade_color <0.5, 0.8, 1> }
  photons { target refraction on reflection on collect off }
}
END

for method in 0 1 2 3 4 5 6 7; do
	status 0 ball.pov +W64 +H64 +Oone.exr +FE "Declare=Method=$method"
	[ "$method" = 0 ] && cp one.exr first.exr
	for unit in 1000 0.001; do
		status 0 ball.pov +W64 +H64 +Oother.exr +FE "Declare=Method=$method" \
			"Declare=Unit=$unit"
		"$COMPARE" one.exr other.exr --layer caustic >compared
		awk '$1 == "SSIM" && $2 > 0.995 { good = 1 } END { exit !good }' compared ||
			fail "method $method in units of $unit: $(tr '\n' ' ' <compared)"
	done
done
# Pictures that differ are told apart.
"$COMPARE" first.exr one.exr --layer caustic | awk '$1 == "SSIM" { exit !($2 < 0.99) }' ||
	fail "the comparison sees nothing"
finish
