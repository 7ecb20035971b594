# Times the reading of text against POV-Ray's: a loop of a million cheap iterations, and a mesh2 of 200,000 triangles. The time
# of an empty scene is taken off both. Prints seconds of processor time and the ratio; the best of three runs counts.
# COGNAC names the program to measure, POVRAY (default povray) the other.
: "${COGNAC:=./cognac}" "${POVRAY:=povray}"
work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT

printf '#version 3.7;\n' >"$work/empty.pov"
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
			printf ",\n\t\t<%.6f, %.6f, %.6f>", i / n - 0.5, sin(i / 10) * cos(j / 10) / 10, j / n - 0.5
	printf "\n\t}\n\tface_indices {\n\t\t%d", 2 * (n - 1) * (n - 1)
	for (i = 0; i < n - 1; i++)
		for (j = 0; j < n - 1; j++) {
			a = i * n + j
			printf ",\n\t\t<%d,%d,%d>, <%d,%d,%d>", a, a + 1, a + n, a + 1, a + n + 1, a + n
		}
	printf "\n\t}\n}\n"
}' >"$work/mesh.pov"

# Processor seconds of a command, the best of three.
seconds() {
	for run in 1 2 3; do
		( time -p "$@" >/dev/null 2>&1 ) 2>&1 | awk '/user|sys/ { sum += $2 } END { print sum }'
	done | sort -n | head -n 1
}

ours_empty=$(seconds "$COGNAC" "+I$work/empty.pov" -F +W16 +H12 +WT1)
theirs_empty=$(seconds "$POVRAY" "+I$work/empty.pov" -F -D +W16 +H12 +WT1)
for scene in loop mesh; do
	ours=$(seconds "$COGNAC" "+I$work/$scene.pov" -F +W16 +H12 +WT1)
	theirs=$(seconds "$POVRAY" "+I$work/$scene.pov" -F -D +W16 +H12 +WT1)
	echo "$scene $ours $ours_empty $theirs $theirs_empty" | awk '{
		ours = $2 - $3; theirs = $4 - $5
		if (ours < 0.01) ours = 0.01
		printf "%s: cognac %.2f s, POV-Ray %.2f s, ratio %.1f\n", $1, ours, theirs, theirs / ours
	}'
done
