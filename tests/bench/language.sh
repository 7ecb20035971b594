# Times the reading of text against POV-Ray's: a loop of a million cheap iterations, and a mesh2 of
# 200,000 triangles. COGNAC names the program to measure, POVRAY (default povray) the other.
: "${COGNAC:=./cognac}" "${POVRAY:=povray}"
work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT

cat >"$work/loop.pov" <<'SCENE'
#version 3.7;
#local i = 0;
#local s = 0;
#while (i < 1000000)
	#local s = s + i*2 - 1;
	#local i = i + 1;
#end
SCENE
awk 'BEGIN {
	n = 317
	printf "#version 3.7;\nmesh2 {\n\tvertex_vectors {\n\t\t%d", n * n
	for (i = 0; i < n; i++)
		for (j = 0; j < n; j++)
			printf ",\n\t\t<%.6f, %.6f, %.6f>",
				i / n - 0.5, sin(i / 10) * cos(j / 10) / 10, j / n - 0.5
	printf "\n\t}\n\tface_indices {\n\t\t%d", 2 * (n - 1) * (n - 1)
	for (i = 0; i < n - 1; i++)
		for (j = 0; j < n - 1; j++) {
			a = i * n + j
			printf ",\n\t\t<%d,%d,%d>, <%d,%d,%d>",
				a, a + 1, a + n, a + 1, a + n + 1, a + n
		}
	printf "\n\t}\n}\n"
}' >"$work/mesh.pov"

# The seconds each program says its parse took, the best of five.
ours() {
	for run in 1 2 3 4 5; do
		"$COGNAC" "+I$1" -F +W16 +H12 +WT1 --quiet --stats "$work/stats.json" \
			>/dev/null 2>&1
		sed -n 's/.*"parse": \([0-9.]*\).*/\1/p' "$work/stats.json"
	done | sort -n | head -n 1
}
theirs() {
	for run in 1 2 3 4 5; do
		"$POVRAY" "+I$1" -F -D +W16 +H12 +WT1 2>&1 |
			sed -n 's/.*Parse Time:.*(\([0-9.]*\) seconds).*/\1/p'
	done | sort -n | head -n 1
}

for scene in loop mesh; do
	echo "$scene $(ours "$work/$scene.pov") $(theirs "$work/$scene.pov")" |
		awk '{ printf "%s: cognac %.3f s, POV-Ray %.3f s, ratio %.1f\n",
			$1, $2, $3, $3 / $2 }'
done
