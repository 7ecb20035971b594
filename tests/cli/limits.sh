#!/bin/sh
# Numbers that ask for more memory than there is are refused at once, with what they would take.
. "$SOURCES/tests/cli/common.sh"

# refused TEXT WORD...: status 1 at once, no picture, and these words.
refused()
{
	text=$1
	shift
	rm -f never.png
	timeout 20 "$COGNAC" "$@" +Onever.png >out 2>err
	got=$?
	[ "$got" = 1 ] || fail "cognac $*: status $got, not 1"
	grep -q "$text" err || fail "cognac $*: '$text' is not told: $(cat err)"
	[ ! -e never.png ] || fail "cognac $*: a picture is left"
}

refused '^cognac: error: a picture of 1000000 x 1000000 pixels takes [0-9]* GB of memory; here' \
	ball.pov +W1000000 +H1000000
refused '^cognac: error: a picture of 0 x 5 pixels cannot be rendered' ball.pov +W0 +H5
refused '^cognac: error: --passes wants a whole number from 1 to 1000000000, not 0' \
	caustic.pov --passes 0
refused '^cognac: error: --passes wants a whole number from 1 to 1000000000, not 2000000000' \
	caustic.pov --passes 2000000000

# Whole numbers that no option can hold are not cut without a word.
for option in +W3000000000 +KFF5000000000 Height=1e300 Subset_End_Frame=nan; do
	refused "^cognac: error: the option [A-Z_a-z]* does not take \"[0-9a-z]*\"" \
		ball.pov $option
done
refused '^cognac: error: --seed wants a whole number of at most 64 bits' \
	ball.pov --seed 99999999999999999999
refused '^cognac: error: the columns or rows to render lie outside' ball.pov +SC3000000000
echo 'Final_Frame=5000000000' >long.ini
refused '^cognac: error: in long.ini, line 1$' long.ini ball.pov

# Of the paths at the ball nearly all leave a photon. The place is where the scene asks for them.
sed 's/count 4000/count 2000000000 relaxation { constrained }/
	1s/$/ #version unofficial cognac 1.0;/' caustic.pov >many.pov
refused '^many.pov:2:29: error: 2000 million paths would leave about 19[0-9][0-9] million photons' \
	many.pov +W8 +H6
grep -q 'which take 7[0-9][0-9] GB of memory; here are [0-9.]* GB, for [0-9]* million$' err ||
	fail "memory is told as $(cat err)"
refused '^many.pov:2:29: error: 2000 million paths' many.pov +W8 +H6 --passes 3
sed 's/count 4000/count 3000000000/' caustic.pov >many.pov
refused '^many.pov:2:29: error: 3000 million paths' many.pov +W8 +H6
sed 's/count 4000/spacing 1e-200/' caustic.pov >many.pov
refused '^many.pov:2:29: error: 1000000000 million paths' many.pov +W8 +H6

# Where they leave few, they are traced: it is told how long that takes, and a signal ends it.
sed 's/^plane.*/disc { <20, -20, 0>, y, 1e-4 pigment { rgb 1 } }/' many.pov >long.pov
"$COGNAC" long.pov +W8 +H6 +Onever.png >out 2>err &
process=$!
tries=0
until grep -q '^long.pov:2:29: warning: 1000000000 million paths take about [0-9]* hours' err; do
	tries=$((tries + 1))
	[ $tries -lt 200 ] || break
	sleep 0.1
done
kill -TERM "$process"
wait "$process"
got=$?
[ $tries -lt 200 ] || fail "no word of how long it takes: $(cat err)"
[ "$got" = 2 ] || fail "photons that are traced for long are stopped with status $got"
[ ! -e never.png ] || fail "a picture is left of a stopped run"
finish
