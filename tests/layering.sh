#!/bin/sh
# Arrows between rooms only go down (README, Architecture): fails on an include that runs up, on
# Embree outside the accelerator, and on C++ outside src/volume. A room may look into itself and
# into what the table names.
cd "${srcdir:-.}" || exit 1

# room: rooms it may look into, besides itself. Only the rooms that exist are checked.
allowed()
{
	engine="src/base src/geom src/surface src/volume src/light src/scene"
	case $1 in
	src/base) echo ;;
	src/geom | src/surface | src/volume | src/light | src/network | src/image) echo src/base ;;
	src/scene) echo src/base src/geom src/surface src/volume src/light ;;
	src/photon) echo "$engine" ;;
	src/density) echo "$engine" src/photon src/network ;;
	src/render) echo "$engine" src/photon src/network src/density ;;
	lang) echo "$engine" src/image ;;
	parser) echo "$engine" src/image lang ;;
	src/cli) echo "$engine" src/photon src/network src/density src/render src/image lang \
		parser ;;
	esac
}

# The room that a quoted include belongs to, seen from the include path (src and the top).
room_of()
{
	case $1 in
	lang/* | parser/*) echo "${1%%/*}" ;;
	*/*) echo "src/${1%%/*}" ;;
	esac
}

status=0
complain()
{
	echo "$*"
	status=1
}

for file in src/*/*.[ch] lang/*.[chly] parser/*.[chly]; do
	[ -f "$file" ] || continue
	room=${file%/*}
	may=" $room $(allowed "$room") "
	for include in $(sed -n 's/^# *include *"\([^"]*\)".*/\1/p' "$file"); do
		target=$(room_of "$include")
		[ -n "$target" ] || continue
		case $may in
		*" $target "*) ;;
		*) complain "$file looks up into $include" ;;
		esac
	done
	case $file in
	src/scene/accel*.[ch]) ;;
	*) ! grep -q '^# *include *<embree' "$file" ||
		complain "$file includes Embree: only the accelerator may" ;;
	esac
done
for file in $(find src lang parser -name '*.cc' -o -name '*.cpp' -o -name '*.hpp'); do
	case $file in
	src/volume/*) ;;
	*) complain "$file is C++: only OpenVDB's reader may be" ;;
	esac
done
exit $status
