#!/bin/sh
# Dispersion as the eye sees it: colours part at edges and add up to white where there are none.
. "$SOURCES/tests/cli/common.sh"

# scene BACKGROUND DISPERSION: a ball of glass before a wall.
scene()
{
	cat <<END
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 8 }
camera { location -z * 4 look_at 0 }
plane { -z, -3 pigment { $1 } finish { ambient 0 diffuse 0 emission 0.6 } }
sphere { 0, 1 pigment { rgbt 1 } interior { ior 1.2 dispersion $2 dispersion_samples 9 } }
END
}

# The mean squared difference that dispersion makes before a background.
difference()
{
	scene "$1" 1 >plain.pov
	scene "$1" 1.1 >parted.pov
	status 0 plain.pov +FE +W64 +H48
	status 0 parted.pov +FE +W64 +H48
	"$COMPARE" plain.exr parted.exr | sed -n 's/^MSE //p'
}

white=$(difference "rgb 1")
edges=$(difference "checker rgb 0 rgb 1 scale 0.4")
awk "BEGIN { exit !($white < 1e-6) }" || fail "hues do not add up to white: MSE $white"
awk "BEGIN { exit !($edges > 1e-3) }" || fail "no colours at edges: MSE $edges"
finish
