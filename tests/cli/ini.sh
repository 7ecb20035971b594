#!/bin/sh
# INI files: sections, comments, quotes, order, POVINI, Create_Ini, shell commands.
. "$SOURCES/tests/cli/common.sh"

cat >size.ini <<'END'
; a comment
Width=9 ; another
HEIGHT = "7.9"   # and one more
+A0.1 -D
Declare=a=1
[big]
Width=16
Height=12
[other]
+W3 +H2
[big]
Output_File_Name="d/a;b"
END

# size WANTED WORD...: the picture has this many columns and rows.
size()
{
	wanted=$1
	shift
	"$COGNAC" ball.pov +FP +O- "$@" >picture 2>err || fail "cognac $*: $(head -n 1 err)"
	got=$(sed -n 2p picture)
	[ "$got" = "$wanted" ] || fail "cognac $*: $got pixels, not $wanted"
}
size '9 7' size.ini +O-
size '16 12' 'size.ini[big]' +O-
size '16 12' 'size.ini[BIG]' +O-
size '9 7' 'size.ini[none]'
grep -qx 'cognac: warning: size.ini has no section \[none\]' err ||
	fail "no word of a missing section: $(cat err)"
size '3 2' 'size.ini[other]'
size '5 7' size.ini +W5
size '9 7' +W5 size.ini
size '16 12' 'size.ini[other]' 'size.ini[big]' +O-
POVINI=size.ini && export POVINI
size '9 7'
size '4 7' +W4
unset POVINI
echo '+W6 +H5' >povray.ini
size '6 5'
rm povray.ini
mkdir lib && echo 'Width=11 ' >lib/far.ini && echo '+H4' >>lib/far.ini
size '11 4' +Llib far.ini
leaves 'a;b.png' ball.pov 'size.ini[big]'

echo 'Wdith=3' >wrong.ini
status 1 ball.pov wrong.ini
grep -q 'wrong.ini, line 1' err || fail "no line of the INI file in: $(cat err)"
echo 'Include_Ini=loop.ini' >loop.ini
status 1 ball.pov loop.ini

status 0 ball.pov +W9 +H8 +A0.2 Declare=q=3 +GIagain.ini
status 0 again.ini
grep -q '^Width=9' again.ini && grep -q '^Declare=q=3' again.ini ||
	fail "again.ini lacks what was said"

cat >shell.ini <<'END'
Pre_Scene_Command=echo pre %s %w >>log
Post_Frame_Command=echo frame %n %o %k %% >>log
Post_Scene_Command=echo post >>log
END
status 0 ball.pov shell.ini +KFF2
[ ! -f log ] || fail "shell commands ran without leave"
status 0 ball.pov shell.ini +KFF2 --allow-shell
printf 'pre ball 8\nframe 1 ball1.png 0 %%\nframe 2 ball2.png 1 %%\npost\n' >wanted
same log wanted "shell commands"
echo 'Pre_Frame_Command=false' >stop.ini
echo 'Pre_Frame_Return=F' >>stop.ini
status 1 ball.pov stop.ini --allow-shell
finish
