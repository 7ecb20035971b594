#!/bin/sh
# Which words are taken and which refused, as POV-Ray takes and refuses them.
. "$SOURCES/tests/cli/common.sh"

for word in +D -D +D0G +P -P +X -X +X5 +UA -UA +UR +RVP +BM2 +HR +SP256 +EP4 -GR +GF -GD \
	-GS -GW +Q11 +R9 +AM1 -F +a0.300 +j1.000 +fn8 -d -v +RF'"x.rad"' +RFO +RFI +B -B +FC +FB \
	+FE +FN +F +STP2 +MI128 -THfs +THb2 +WT0 +wt2 +MV3.1 +AM3 +R12 +Q20 +SU +RP9 +MB5 -UV \
	+UL +UD +UF +UO +WL0 +A -A +J -J0.5 +AG2 +SR0.5 +SC0.25 +EC1.0 +K3 +KI2 +KF3 +C -KC \
	Width=9 Height=10.7 Clock=18.1 Clock=-.5 +K.3 +J.5 +AG.8 Quality=11 Antialias=on Antialias=maybe Verbose=off \
	Display=false Output_File_Type=N Declare=Pass=1 Declare=x Declare=x=1+1 \
	Grayscale_Output=on All_File=false Real_Time_Raytracing=on Render_Block_Step=2 \
	File_Gamma=sRGB File_Gamma=1.8 Display_Gamma=2.2 Compression=50 BSP_MaxDepth=10 \
	Post_Frame_Return=I WORK_THREADS=1 Frame_Step=2 Jitter_Amount=-1 Quality=-3 \
	Bits_Per_Color=20 --threads=2 --seed=7 --width=9 --quiet --output=x.png \
	--declare=Pass=1; do
	status 0 ball.pov "$word"
done

for word in +TP +b640 /x:32 s.inc ball ++W4 /W4 +0 + - +Z +P5 +UA5 +KCx +C5 +V5 +Q +R \
	+AM +AG +WT +BM +BS +BS3 +MV +L +HI +Wabc +A=3 +A0,3 +QR +Kx +KFFx +FX +FS +FG \
	+FN8g +HTN +E5 +S5 +UB +ER7 +EC9 +SC9 +SR7 +EC0 Width=abc Width= Foo=3 Buffer_Output=on \
	Histogram_Name=x File_Gamma=abc File_Gamma=-1 Final_Frame=x Dither_Method=zz \
	Output_File_Type=Q +THzz missing.ini --nonsense --threads --quiet=3 --seed=-3 \
	--update=0; do
	status 1 ball.pov "$word"
	[ -s err ] || fail "$word is refused without a message"
done
status 1 +I ball.pov
status 1 -visual DirectColor ball.pov
status 1
status 1 missing.pov
status 1 ball.pov +Onowhere/x.png
status 1 ball.pov +W0
"$COGNAC" --help >out 2>err && grep -q '^usage' out && [ ! -s err ] || fail "--help"
"$COGNAC" --version >out 2>err && grep -q '^cognac [0-9]' out || fail "--version"
finish
