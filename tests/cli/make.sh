#!/bin/sh
# How makefiles and scripts call it: rules, a target a frame, processes side by side, INI files of
# programs.
. "$SOURCES/tests/cli/common.sh"

unset MAKEFLAGS MFLAGS
mkdir bin
ln -s "$COGNAC" bin/cognac
PATH=$work/bin:$PATH
export PATH
cat >turn.pov <<'END'
#version 3.7;
camera { location -z * 4 look_at 0 }
light_source { <3, 4, -5> rgb 1 }
box { -1, 1 pigment { rgb <1, 0.5, clock> } rotate y * 90 * clock }
END

cat >Makefile <<'END'
RENDER = cognac +W16 +H12 -D -V
FRAMES = turn1.png turn2.png turn3.png turn4.png
all: ball.png whole
%.png: %.pov
	$(RENDER) +I$< +O$@
whole: $(FRAMES)
turn%.png: turn.pov
	$(RENDER) turn.pov +KFI1 +KFF4 +SF$* +EF$*
END
make -j3 >out 2>err || fail "make: $(tail -n 1 err)"
[ "$(ls ./*.png | tr '\n' ' ')" = './ball.png ./turn1.png ./turn2.png ./turn3.png ./turn4.png ' ] ||
	fail "make leaves $(ls)"
make -q || fail "make wants to render again"
mkdir alone
status 0 turn.pov +W16 +H12 +KFF4 +Oalone/turn
for n in 1 2 3 4; do
	same turn$n.png alone/turn$n.png "a target a frame"
done

# A target that fails leaves no file which make would take for done.
cp bad.pov wrong.pov
! make wrong.png >out 2>&1 || fail "make takes a scene error for success"
[ ! -e wrong.png ] || fail "a wrong scene's picture is left"

mkdir sides
cognac turn.pov +W16 +H12 +KFF4 +SF1 +EF2 +Osides/turn >out1 2>&1 &
first=$!
cognac turn.pov +W16 +H12 +KFF4 Subset_Start_Frame=3 Subset_End_Frame=4 +Osides/turn >out2 2>&1 &
second=$!
wait $first && wait $second || fail "two processes side by side: $(cat out1 out2)"
for n in 1 2 3 4; do
	same sides/turn$n.png alone/turn$n.png "two processes side by side"
done

# One process a frame, its clock from a script.
status 0 turn.pov +W16 +H12 +K0.666666666666667 +Oclock.ppm +FP
status 0 turn.pov +W16 +H12 +KFF4 +SF3 +EF3 +FP +Oloop
same clock.ppm loop3.ppm "a clock of one's own"

# As the Atomic Simulation Environment writes it.
cat >ase.ini <<'END'
Input_File_Name="ball.pov"
Output_To_File=True
Output_File_Type=N
Output_Alpha=True
; if you adjust Height, and width, you must preserve the ratio
; Width / Height = 0.9
Width=20
Height=22.0023
Antialias=True
Antialias_Threshold=0.1
Display=False
Pause_When_Done=False
Verbose=False
END
rm ball.png
cognac ase.ini >out 2>err || fail "an INI file of a program: $(cat err)"
[ -s ball.png ] && [ ! -s out ] ||
	fail "an INI file of a program: no picture, or words on standard output"
POVINI=nowhere.ini cognac ball.pov +W8 +H6 >out 2>err ||
	fail "a POVINI that is not there stops the render"
grep -q nowhere.ini err || fail "a POVINI that is not there is not named"

# A part keeps the picture's full size.
status 0 ball.pov +W16 +H12 +SR0.25 +ER0.75 +FP +Opart
[ "$(sed -n 2p part.ppm)" = '16 12' ] || fail "a part has another size"
finish
