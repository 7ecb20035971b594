# What the command line's tests share: a scratch folder with small scenes, and checks that count.
work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT
cd "$work" || exit 1
export HOME="$work"
unset POVINI COGNAC_LIBRARY_PATH
failures=0

cat >ball.pov <<'END'
#version 3.7;
camera { location -z * 4 look_at 0 }
light_source { <3, 4, -5> rgb 1 }
sphere { 0, 1 pigment { rgb <1, 0.5, 0.2> } }
END
# A ball of glass and the light it gathers.
cat >caustic.pov <<'END'
#version 3.7;
global_settings { photons { count 4000 } }
camera { location <0, 3, -5> look_at -y }
light_source { <3, 6, 2> rgb 1 }
sphere { 0, 1 pigment { rgbt 1 } interior { ior 1.5 } photons { target refraction on collect off } }
plane { y, -1.5 pigment { rgb 1 } }
END
cat >tell.pov <<'END'
#version 3.7;
#debug concat("@", str(frame_number, 0, 0), " ", str(initial_frame, 0, 0), " ",
  str(final_frame, 0, 0), " ", str(clock, 0, 5), " ", str(clock_delta, 0, 5), " ",
  str(clock_on, 0, 0), "\n")
END
echo 'sphere { 0, 1 pigment { nonsense } }' >bad.pov

fail()
{
	echo "$0: $*"
	failures=$((failures + 1))
}

# status WANTED WORD...: runs cognac on small pictures and compares its exit status.
status()
{
	wanted=$1
	shift
	"$COGNAC" +W8 +H6 "$@" >out 2>err
	got=$?
	[ "$got" = "$wanted" ] || fail "cognac $*: status $got, not $wanted: $(head -n 1 err)"
}

# leaves FILES WORD...: the run ends well and makes exactly these files in the folder d.
leaves()
{
	files=$1
	shift
	rm -rf d
	mkdir d
	status 0 "$@"
	found=$(ls d | tr '\n' ' ')
	[ "$found" = "$files " ] || fail "cognac $*: left '$found', not '$files'"
}

# tells TEXT WORD...: what tell.pov prints, frames apart by commas.
tells()
{
	text=$1
	shift
	status 0 tell.pov -F "$@"
	told=$(sed -n 's/^@//p' err | tr '\n' ',')
	[ "$told" = "$text," ] || fail "cognac $*: tells '$told', not '$text'"
}

same()
{
	cmp -s "$1" "$2" || fail "$1 and $2 differ${3:+: $3}"
}

finish()
{
	[ "$failures" = 0 ]
	exit
}
