#!/bin/sh
# Pictures: formats, standard output and input, parts, statistics, nothing left after an error, the
# same for any threads.
. "$SOURCES/tests/cli/common.sh"

for type in N8 N16 T C P P16 B J E; do
	status 0 ball.pov +F$type +W32 +H24 +Oformat_$type
done
status 0 ball.pov +W32 +H24 +Oplain.png
for file in format_N8.png format_T.tga format_C.tga format_P.ppm format_B.bmp; do
	"$COMPARE" "$file" plain.png | grep -qx 'MSE 0' || fail "$file is not the PNG's picture"
done
"$COMPARE" --layer Z format_E.exr format_E.exr >out || fail "no layer Z"
"$COMPARE" --layer albedo format_E.exr format_E.exr >out || fail "no layer albedo"
! "$COMPARE" --layer nonsense format_E.exr format_E.exr >out 2>&1 ||
	fail "a layer that is not there"
! "$COMPARE" plain.png missing.png >out 2>&1 || fail "comparing with nothing"
"$COMPARE" --json --crop 4,4,8,8 --halve --map map.png format_J.jpg plain.png >out ||
	fail "cognac-compare's options"
! "$COMPARE" --crop 4,4,8 format_J.jpg plain.png >never 2>err || fail "a crop of three numbers"
grep -q 'cognac-compare: --crop wants X,Y,W,H, not 4,4,8' err ||
	fail "a bad crop is told as $(cat err)"
grep -q '"SSIM": 0.9' out || fail "JPEG is not close: $(cat out)"
[ -s map.png ] || fail "no map"

status 0 ball.pov +W32 +H24 +FP +O-
same out format_P.ppm "standard output"
"$COGNAC" +I- +W32 +H24 +FP +O- <ball.pov >out 2>err || fail "standard input: $(head -n 1 err)"
same out format_P.ppm "standard input"
"$COGNAC" +I- +W32 +H24 +FP <ball.pov 2>err &&
	same stdin.ppm format_P.ppm "a name for standard input"

status 0 ball.pov +W32 +H24 +FP +WT1 +Oone
status 0 ball.pov +W32 +H24 +FP +WT3 +Othree
same one.ppm three.ppm "one and three threads"

# A part: its own pixels as in the whole, the rest black.
status 0 ball.pov +W32 +H24 +SC9 +EC24 +SR0.25 +ER0.75 +Opart.png
"$COMPARE" --crop 8,6,16,12 part.png plain.png | grep -qx 'MSE 0' ||
	fail "the part differs from the whole"
status 0 ball.pov +W32 +H24 +SC9 +EC8 +Oempty.png
"$COMPARE" --crop 0,0,8,24 part.png empty.png | grep -qx 'MSE 0' || fail "not black beside the part"

# What a background's transmit lets through is lost to the picture, what its filter does is not.
cat >back.pov <<'END'
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location -z * 4 look_at 0 }
background { color rgbft <1, 1, 1, 0.25, 0.5> }
END
status 0 back.pov +W1 +H1 +FP +Oback
[ "$(tail -c 3 back.ppm | od -An -tu1 | tr -d ' ')" = 188188188 ] ||
	fail "the background shines through wrongly"

status 1 bad.pov +Obad
status 1 bad.pov +Obad --stats bad.json
[ ! -e bad.png ] && [ -z "$(ls | grep 'bad\.png')" ] ||
	fail "a picture is left after an error: $(ls)"
grep -q '"status": "failed"' bad.json || fail "no statistics of a failed run"
mkdir ro && chmod 555 ro
[ "$(id -u)" = 0 ] || status 1 ball.pov +Oro/x
status 0 ball.pov -F --stats st.json
for name in parse build trace rays peak_memory; do
	grep -q "\"$name\"" st.json || fail "no $name in the statistics"
done
[ ! -e ball.png ] || fail "-F wrote a file"

# What is already there stays until the new one is whole; +C leaves it alone.
cp plain.png keep.png
status 1 bad.pov +Okeep
same keep.png plain.png "the old picture after an error"
status 0 ball.pov +W8 +C +Okeep
same keep.png plain.png "the old picture with +C"

# A scene without #version has the gamma of scenes before 3.7; one with only the unofficial version
# that of 3.7.
sed 1d ball.pov >unsaid.pov
{ echo '#version 3.6;'; cat unsaid.pov; } >older.pov
{ echo '#version unofficial cognac 1.0;'; cat unsaid.pov; } >cognac.pov
for name in unsaid older cognac ball; do status 0 $name.pov +Ov_$name; done
same v_unsaid.png v_older.png "the picture without #version"
same v_cognac.png v_ball.png "the picture of the unofficial version"
! cmp -s v_unsaid.png v_ball.png || fail "no gamma of old scenes without #version"

# Up to +Q5 pigments are of their quick_color, and +Q1 shows the bottom layer.
sed '$d' ball.pov >flat.pov
cp flat.pov quick.pov
cat >>flat.pov <<'END'
sphere { 0, 1 pigment { rgb <0, 0.5, 0.2> } finish { ambient 1 diffuse 0 } }
END
cat >>quick.pov <<'END'
#declare Quick = pigment { rgb 1 quick_color rgb <0, 0.5, 0.2> }
sphere { 0, 1
  texture { pigment { Quick checker rgb 0 rgb 1 } }
  texture { pigment { rgbt 0.5 } }
}
END
for quality in 0 1; do
	status 0 quick.pov +Q$quality +Oq_quick
	status 0 flat.pov +Oq_flat
	same q_quick.png q_flat.png "quick colours at +Q$quality"
done
sed 's/texture { pigment { rgbt .*//' quick.pov >lit.pov
sed 's/pigment.*finish.*/pigment { rgb <0, 0.5, 0.2> } }/' flat.pov >told.pov
status 0 told.pov +Oq_told
for quality in 5 6; do status 0 lit.pov +Q$quality +Oq_$quality; done
same q_5.png q_told.png "quick colours at +Q5"
! cmp -s q_5.png q_6.png || fail "quick colours at +Q6"
finish
