#!/bin/sh
# References and the bench beside them, in small: they go on where they were, and the table's best K
# is the best.
. "$SOURCES/tests/cli/common.sh"
python=/usr/bin/python3
"$python" -c 'import numpy' 2>/dev/null || exit 77
bench=$SOURCES/tests/bench
words="--cognac $COGNAC --compare $COMPARE --scenes $SOURCES/scenes --threads 1"

# references PHOTONS: of the ring, 1000 photons a pass
references()
{
	# shellcheck disable=SC2086
	"$python" "$bench/references.py" $words --folder refs --per-pass 1000 --photons "$1" ring \
		>out 2>err || fail "references: $(tail -n 1 err)"
}
references 4000
grep -q ' 2 and 2 passes' out || fail "passes of two halves: $(cat out)"
[ -s refs/ring.exr ] && [ -s refs/ring.a.exr ] && [ -s refs/ring.b.exr ] ||
	fail "a picture is missing"
"$COMPARE" --layer caustic refs/ring.a.exr refs/ring.b.exr | grep -qx 'MSE 0' &&
	fail "the halves are one"
cp refs/ring.a.exr before.exr
references 4000
"$COMPARE" refs/ring.a.exr before.exr | grep -qx 'MSE 0' || fail "what is done is made again"
references 8000
grep -q ' 4 and 4 passes' out || fail "more passes: $(cat out)"

# The mean's error against much better halves is what the error bar says, within a factor of two.
rm -rf refs
references 40000
cp refs/ring.exr better.exr
bar=$(sed 's/.*error \([^,]*\),.*/\1/' out)
rm -rf refs
references 8000
bar=$(sed 's/.*error \([^,]*\),.*/\1/' out)
"$COMPARE" --layer caustic refs/ring.exr better.exr |
	awk -v bar="$bar" '$1 == "RMSE" { exit !($2 > bar / 2 && $2 < bar * 2) }' ||
	fail "the error bar is $bar, the error
		$("$COMPARE" --layer caustic refs/ring.exr better.exr | grep ^RMSE)"

cp better.exr refs/ring.exr
# shellcheck disable=SC2086
"$python" "$bench/caustics.py" $words --references refs --scene ring --counts 2k --seeds 1 \
	--methods nearest --method 'wide::nearest { count %K kernel cone }:15' --json rows.json \
	--sheet >out 2>err ||
	fail "caustics.py: $(tail -n 1 err)"
[ "$(grep -c '^nearest' out)" = 4 ] && [ "$(grep -c '^wide' out)" = 1 ] ||
	fail "rows are missing: $(cat out)"
awk '$1 == "nearest" { k[$2] = $3 } END { for (i in k) if (i ~ /[*]/) best = k[i]
	for (i in k) if (k[i] < 0.97 * best) exit 1 }' out ||
		fail "the best K is not the best: $(cat out)"
"$COMPARE" caustics-bench/ring.2k.png caustics-bench/ring.2k.png >out 2>&1 ||
	fail "the sheet: $(cat out)"
finish
