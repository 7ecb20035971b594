# Photon benchmarks: paths per second, beside POV-Ray's where it is installed, and the search tree beside nanoflann
# and FLANN (Debian: libnanoflann-dev, libflann-dev, liblz4-dev, g++, for this only). Run by `make bench-photons`
# in the build directory.
set -e
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cat > "$scratch/slab.pov" <<'SCENE'
#version 3.7;
global_settings { assumed_gamma 1 photons { spacing 0.005 } }
camera { orthographic location <0, 1, 0> direction <0, -1, 0> right x*6 up z*6 }
light_source { <0, 1000, 0> rgb 1 parallel point_at 0 }
plane { y, 0 pigment { rgb 1 } }
box { <-2, 2, -2>, <2, 2.1, 2> pigment { rgbt 1 } interior { ior 1.5 } photons { target refraction on collect off } }
SCENE

# The value of a key in the statistics' photons block.
value() { sed -n '/"photons"/,/}/s/.*"'"$2"'": \([0-9.]*\).*/\1/p' "$1" | head -n 1; }

for threads in 1 2; do
	"$COGNAC" +I"$scratch/slab.pov" +O"$scratch/slab.png" +W4 +H4 -A -D --threads $threads \
		--stats "$scratch/$threads.json" > "$scratch/log" 2>&1
done
one=$(awk -v p="$(value "$scratch/1.json" paths)" -v t="$(value "$scratch/1.json" processor)" 'BEGIN { print p / t }')
two=$(awk -v p="$(value "$scratch/2.json" paths)" -v t="$(value "$scratch/2.json" seconds)" 'BEGIN { print p / t }')
printf 'photon paths/s, a slab over a plane: one thread (processor time) %.0f, two threads %.0f\n' "$one" "$two"

if command -v povray > /dev/null; then
	TIMEFORMAT=%U
	user=$({ time povray -D +WT1 +I"$scratch/slab.pov" +O"$scratch/pov.png" +W4 +H4 -A 2> "$scratch/pov.log"; } 2>&1)
	awk -v t="$user" -v stored="$(sed -n 's/^Surface photons stored: *//p' "$scratch/pov.log")" \
		-v ours="$(value "$scratch/1.json" stored)" -v ourt="$(value "$scratch/1.json" processor)" \
		'BEGIN { printf "stored photons/s of processor time: ours %.0f, POV-Ray %.0f, ratio %.2f\n",
		ours / ourt, stored / t, ours / ourt / (stored / t) }'
fi

program=tests/bench/photon_tree
missing=
for header in nanoflann.hpp flann/flann.hpp lz4.h; do
	echo "#include <$header>" | ${CXX:-c++} -fsyntax-only -x c++ - 2>/dev/null || missing="$missing $header"
done
if [ -n "$missing" ]; then
	echo "bench-photons: these headers are missing:$missing"
	echo "install libnanoflann-dev, libflann-dev and liblz4-dev for the search tree's table"
	exit 1
fi
mkdir -p tests/bench
${CXX:-c++} -O3 -fopenmp -I"$SOURCES/src" "$SOURCES/tests/bench/photon_tree.cc" libphoton.a libbase.a \
	-llz4 -lm -o "$program"
"$program" "${RUNS:-5}"
rm -f "$program"
