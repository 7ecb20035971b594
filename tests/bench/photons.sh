# Photon benchmarks: the photon stage beside POV-Ray's where it is installed, the paths' rays beside
# bare rtcIntersect1, and the search tree beside nanoflann and FLANN (Debian: libnanoflann-dev,
# libflann-dev, liblz4-dev, g++, for this only). Run by `make bench-photons` in the build directory.
set -e
python3 "$SOURCES/tests/bench/photon_stage.py" --cognac "$COGNAC" --rays tests/bench/photon-rays \
	--runs "${RUNS:-5}"

program=tests/bench/photon_tree
missing=
for header in nanoflann.hpp flann/flann.hpp lz4.h; do
	echo "#include <$header>" | ${CXX:-c++} -fsyntax-only -x c++ - 2>/dev/null ||
		missing="$missing $header"
done
if [ -n "$missing" ]; then
	echo "bench-photons: these headers are missing:$missing"
	echo "install libnanoflann-dev, libflann-dev and liblz4-dev for the search tree's table"
	exit 1
fi
mkdir -p tests/bench
${CXX:-c++} -O3 -fopenmp -I"$SOURCES/src" "$SOURCES/tests/bench/photon_tree.cc" libphoton.a \
	libbase.a -llz4 -lm -o "$program"
"$program" "${RUNS:-5}"
rm -f "$program"
