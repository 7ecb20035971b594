#!/bin/sh
# Frames, their names and clocks, as POV-Ray counts them.
. "$SOURCES/tests/cli/common.sh"

tells '0 0 0 0.00000 0.00000 0'
tells '0 0 0 3.50000 0.00000 1' +K3.5
tells '1 1 3 0.00000 0.50000 1,2 1 3 0.50000 0.50000 1,3 1 3 1.00000 0.50000 1' +KFF3
tells '1 1 2 0.00000 1.00000 1,2 1 2 1.00000 1.00000 1' +KFF2 +K7
tells '1 1 3 2.00000 2.00000 1,2 1 3 4.00000 2.00000 1' +KFF2 +KI2 +KF6 +KC
tells '5 0 20 0.25000 0.05000 1' +KFI0 +KFF20 +SF5 +EF5
tells '3 1 13 0.16667 0.08333 1,4 1 13 0.25000 0.08333 1' +KFI1 +KFF12 Cyclic_Animation=on +SF3 +EF4
tells '4 4 4 0.00000 0.00000 1' +KFI4
tells '0 0 0 0.00000 0.00000 0' +SF2 +EF3

leaves 'ball.png' ball.pov +Od/
leaves 'a.png' ball.pov +Od/a
leaves 'a.txt.png' ball.pov +Od/a.txt
leaves 'q.pnm.ppm' ball.pov +Fp +Od/q.pnm
leaves 'a.tga' ball.pov +FC +Od/a.tga
leaves 'a1.png a2.png' ball.pov +Od/a +KFF2
leaves 'a.b1.png a.b2.png' ball.pov +Od/a.b.png +KFF2
leaves 'a91.png a92.png' ball.pov +Od/a9.png +KFF2
leaves 's00.png s01.png' ball.pov +Od/s +KFI0 +KFF11 +EF1
leaves 'scene00005.png scene00006.png' ball.pov +Od/scene.png +KFI1 +KFF12724 +SF5 +EF6
leaves 'ball03.png ball04.png ball05.png' ball.pov +Od/ +KFF10 +SF0.3 +EF0.5
leaves 'ball01.png ball05.png ball09.png' ball.pov +Od/ +KFF10 +STP4
leaves 'ball06.png ball07.png' ball.pov +Od/ +KFI0 +KFF20 +SF0.33 +EF0.34
leaves 'ball2.png' ball.pov +Od/ +KFF3 +SF2 +EF1
leaves 'ball01.png' ball.pov +Od/ +KFF9 +KC +EF1
leaves 'ball.png' ball.pov +Od/ +KFF0

mkdir -p sub && cp ball.pov sub/other.pov
status 0 sub/other.pov
[ -f sub/other.png ] || fail "without +O the picture stands beside the scene"
finish
