#!/bin/sh
# Parts of one picture, rendered by several runs, make the bits of the whole.
. "$SOURCES/tests/cli/common.sh"

size='+W32 +H24 +A0.1'
# shellcheck disable=SC2086
parts() # TYPE EXTENSION WORD...: whole and two parts
{
	type=$1 extension=$2
	shift 2
	status 0 ball.pov $size +F$type +Owhole.$extension "$@"
	status 0 ball.pov $size +F$type +Oupper.$extension +ER10 "$@"
	status 0 ball.pov $size +F$type +Olower.$extension +SR11 "$@"
}

merge()
{
	wanted=$1
	shift
	"$MERGE" "$@" >out 2>err
	got=$?
	[ "$got" = "$wanted" ] || fail "cognac-merge $*: status $got, not $wanted: $(head -n 1 err)"
}

parts N8 png
merge 0 -o merged.png upper.png lower.png
same merged.png whole.png "parts of a PNG"
merge 0 --output=merged.png lower.png upper.png upper.png
same merged.png whole.png "parts in another order, one of them twice"
merge 0 -o - upper.png lower.png
same out whole.png "merged to standard output"
for words in '+FN16' '+FN8 +UA' '+FN16 +UA' '+FN16 Grayscale_Output=on' '+FN8 File_Gamma=1.8'; do
	# shellcheck disable=SC2086
	parts N png $words
	merge 0 -o merged.png upper.png lower.png
	same merged.png whole.png "$words"
done
status 0 ball.pov $size +SR0.25 +ER0.75 +SC0.5 +Ocorner.png
status 0 ball.pov $size +Owhole.png
merge 1 -o none.png corner.png
grep -q 'no part holds the pixel 0, 0' err || fail "the gap is not named: $(cat err)"

parts E exr +UA
merge 0 -o merged.exr lower.exr upper.exr
for layer in RGBA albedo N; do
	"$COMPARE" --layer $layer merged.exr whole.exr | grep -qx 'MSE 0' ||
		fail "layer $layer differs"
done
! grep -q region merged.exr || fail "the merged picture says that it is a part"

# What is no part of the same picture is refused, and nothing is left.
merge 1 -o none.png whole.png corner.png
merge 1 -o none.png upper.exr lower.png
status 0 ball.pov +W16 +H12 +SR7 +Osmall.png
merge 1 -o none.png corner.png small.png
sed 's/0.5, 0.2/0.6, 0.2/' ball.pov >other.pov
status 0 other.pov $size +SR5 +Oother.png
status 0 ball.pov $size +ER10 +Oupper.png
merge 1 -o none.png upper.png other.png
grep -q 'holds another pixel' err || fail "another picture's part is taken"
merge 1 -o none.png missing.png
merge 1 upper.png lower.png
grep -q -- "no --output=FILE" err || fail "a missing output is told as $(cat err)"
merge 1 -o none.png
[ ! -e none.png ] || fail "a picture is left after a failure"
merge 0 --help
merge 0 --version
finish
