#!/bin/sh
# Stopping by a signal: status 2, nothing left; with +C the picture so far, and the next run goes on
# from it to the same picture that an undisturbed run makes.
. "$SOURCES/tests/cli/common.sh"

cat >slow.pov <<'END'
#version 3.7;
camera { location -z * 4 look_at 0 }
light_source { <3, 4, -5> rgb 1 area_light x * 3, y * 3, 12, 12 }
#for (I, 0, 6)
  sphere { <I / 3 - 1, 0, I / 6>, 0.3 pigment { granite } }
#end
plane { z, 3 pigment { marble turbulence 1 } }
END
size='+W320 +H240 +A0.0 +R3'

# signal_after FILE: to $process when the file is there, or after half a minute.
signal_after()
{
	tries=0
	while [ ! -e "$1" ] && [ $tries -lt 300 ]; do
		sleep 0.1
		tries=$((tries + 1))
	done
	kill -TERM "$process"
}

# stopped WORD...: runs in the background, is stopped after the first update, gives the status.
stopped()
{
	# shellcheck disable=SC2086
	"$COGNAC" slow.pov $size +Osoon.png --update=0.02 "$@" >out 2>err &
	process=$!
	signal_after soon.png
	wait "$process"
}

stopped
got=$?
[ $got = 2 ] || fail "status $got after a signal"
[ -z "$(ls | grep '^soon')" ] || fail "left after a signal: $(ls soon*)"

stopped +C
got=$?
[ $got = 2 ] || fail "status $got after a signal with +C"
[ -s soon.png ] && [ -s soon.png.state ] || fail "+C keeps nothing: $(ls)"
"$COMPARE" soon.png soon.png >out 2>&1 || fail "the picture so far is broken"
size='+W320 +H240'
echo '// changed' >>slow.pov
"$COGNAC" slow.pov $size +C +Osoon.png >out 2>err && fail "goes on with the state of another scene"
grep -q 'differ; without +C the picture is begun anew$' err ||
	fail "another scene's state is told as $(cat err)"
# shellcheck disable=SC2086
"$COGNAC" ball.pov $size +Osoon.png >out 2>err || fail "cannot begin anew: $(head -n 1 err)"
[ ! -e soon.png.state ] || fail "a picture that is begun anew leaves the old state"
rm -f soon.png

sed 's/12, 12/4, 4/' slow.pov >quick.pov
mv quick.pov slow.pov
size='+W320 +H240 +A0.0 +R2'
stopped +C
# shellcheck disable=SC2086
"$COGNAC" slow.pov $size +C +Osoon.png >out 2>err || fail "cannot go on: $(head -n 1 err)"
"$COGNAC" slow.pov $size +Owhole.png >out 2>err
"$COMPARE" soon.png whole.png | grep -qx 'MSE 0' || fail "the continued picture is another one"
[ ! -e soon.png.state ] || fail "the state is left behind"

# Relaxation ends soon after a signal, and leaves neither its photons nor a picture.
sed -e 's/#version.*/#version unofficial cognac 1.0;/' \
	-e 's/count 4000/&0 relaxation { iterations 1000, 1000 }/' caustic.pov >restless.pov
"$COGNAC" restless.pov +W8 +H6 +Omoved.png --photons moved.ply --photons-landed landed.ply \
	>out 2>err &
process=$!
signal_after landed.ply
begin=$(date +%s)
wait "$process"
got=$?
[ $got = 2 ] || fail "status $got after a signal to relaxation: $(head -n 1 err)"
[ $(($(date +%s) - begin)) -lt 10 ] || fail "relaxation goes on for long after a signal"
left=$(ls landed* moved* 2>/dev/null)
[ "$left" = landed.ply ] || fail "relaxation left behind: $left"

# Progressive passes keep their state when they are done: more of them later go on from there.
passes()
{
	"$COGNAC" caustic.pov +W64 +H48 +FE +C "$@" >out 2>err || fail "$*: $(head -n 1 err)"
}
passes +Oafter.exr --passes 2
[ -s after.exr.state ] || fail "passes keep no state"
passes +Oafter.exr --passes 5
passes +Oat_once.exr --passes 5
"$COMPARE" --layer caustic after.exr at_once.exr | grep -qx 'MSE 0' ||
	fail "passes go on to another picture"
# header FILE NAME: the number of that name. Names stand right behind the value before.
header()
{
	tr -c '[:print:]' '\n' <"$1" | sed -n "/$2\$/,\$p" | sed 1d | grep -o -m 1 '^[0-9][0-9.e-]*'
}
[ "$(header after.exr passes)" = 5 ] || fail "the header tells of $(header after.exr passes) passes"
passes +Oafter.exr --passes 5
radius=$(header at_once.exr radius)
[ "$radius" ] && [ "$(header after.exr radius)" = "$radius" ] ||
	fail "the header forgets the last radius"
finish
