#!/bin/sh
# Measures noise, turbulence, warps and patterns with POV-Ray at a few points, and prints the lines
# of tests/unit/pattern_data.h. Needs povray and its includes; no part of `make check`.
#
#   sh tests/measure_patterns.sh > tests/unit/pattern_data.h
set -e
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
points='<0.31,0.42,0.53> <-1.27,0.88,2.41> <3.19,-2.63,-0.77> <-7.3,5.9,11.7>'

# One row of the table: number of the case, then the value at each point. $1 name, $2 the pattern's
# words.
row() {
	{
		echo '#version 3.7; global_settings { assumed_gamma 1 }'
		echo "#declare T = function { pattern { $2 } }"
		echo '#fopen F "out" write'
		for p in $points; do
			v=$(echo "$p" | tr -d '<>')
			echo "#write (F, str(T($v), 0, 15), \", \")"
		done
		echo '#fclose F'
	} > "$dir/scene.pov"
	(cd "$dir" && povray +Iscene.pov -F -D +W1 +H1 > log 2>&1) ||
		{ cat "$dir/log" >&2; exit 1; }
	printf '\t{"%s", "%s",\n\t\t{%s}},\n' "$1" "$2" "$(sed 's/, $//' "$dir/out")"
}

# Three components of vturbulence(lambda, omega, octaves, p).
vector_row() {
	{
		echo '#version 3.7; global_settings { assumed_gamma 1 }'
		echo '#fopen F "out" write'
		for p in $points; do
			echo "#write (F, \"\\t{\"," \
				"vstr(3, vturbulence($1, $p), \", \", 0, 15), \"},\\n\")"
		done
		echo '#fclose F'
	} > "$dir/scene.pov"
	(cd "$dir" && povray +Iscene.pov -F -D +W1 +H1 > log 2>&1) ||
		{ cat "$dir/log" >&2; exit 1; }
	cat "$dir/out"
}

echo '/* Written by tests/measure_patterns.sh with POV-Ray 3.7.0.10: values at the four points of' \
	'test_pattern.c. */'
echo 'static const MeasuredPattern measured[] = {'
while IFS='|' read -r name words; do
	[ -z "$name" ] || row "$name" "$words"
done <<'CASES'
bozo|bozo noise_generator 1
bozo|bozo
bozo|bozo noise_generator 3
bozo|bozo turbulence 0.5
dents|dents
wrinkles|wrinkles
granite|granite
granite|granite noise_generator 1
agate|agate
agate|agate agate_turb 0.4 turbulence 0.3
marble|marble turbulence 0.7
wood|wood turbulence <0.1,0.05,0.2>
onion|onion
leopard|leopard
radial|radial
gradient|gradient <1,2,3>
planar|planar scale 20
spherical|spherical scale 20
cylindrical|cylindrical scale 20
boxed|boxed scale 20
quilted|quilted
spiral1|spiral1 3
spiral2|spiral2 5
ripples|ripples
waves|waves
checker|checker
brick|brick brick_size 1 mortar 0.2
hexagon|hexagon
cubic|cubic
cells|cells
crackle|crackle
crackle|crackle metric 1
crackle|crackle form <1,0,0> metric 3 offset 0.3
crackle|crackle solid
mandel|mandel 20 scale 5
mandel|mandel 20 exponent 4 interior 1,1 scale 5
julia|julia <0.353,0.288>, 30 scale 5
magnet1m|magnet 1 mandel 30
magnet2m|magnet 2 mandel 30
gradient|gradient y sine_wave
gradient|gradient y scallop_wave
gradient|gradient y cubic_wave
gradient|gradient y poly_wave 2
gradient|gradient y triangle_wave
gradient|gradient y frequency 3 phase 0.7
bozo|bozo warp { repeat 2*x flip <1,1,0> offset <0.1,0.2,0.3> }
bozo|bozo warp { planar <1,0.3,0.2>, 0.4 }
bozo|bozo warp { cylindrical orientation y dist_exp 0.5 }
bozo|bozo warp { spherical dist_exp 1 }
bozo|bozo warp { toroidal major_radius 0.8 dist_exp 1 }
bozo|bozo warp { cubic }
bozo|bozo warp { black_hole 0, 2 falloff 3 }
bozo|bozo turbulence 0.4 scale 2 warp { turbulence <0.1,0.2,0.3> lambda 3 }
CASES
echo '};'
echo
echo '/* vturbulence(2.3, 0.6, octaves 1 and 6) */'
echo 'static const double measured_vectors[2][4][3] = {{'
vector_row '2.3, 0.6, 1'
echo '}, {'
vector_row '2.3, 0.6, 6'
echo '}};'
