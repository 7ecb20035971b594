#!/bin/sh
# What the refusal for lack of memory counts for a photon is what a photon takes.
. "$SOURCES/tests/cli/common.sh"

grep -q __asan_init "$COGNAC" && exit 77 # its own memory is counted as well

# A fixed threshold gives back what is freed, and so shows little maps as large ones are.
MALLOC_MMAP_THRESHOLD_=131072
export MALLOC_MMAP_THRESHOLD_

# settle SETTINGS COUNT: room.pov with so many photons.
settle()
{
	sed -e '1s/.*/#version unofficial cognac 1.0;/' -e "s/count 4000/count $2 $1/" \
		caustic.pov >room.pov
}

# takes COUNT SETTINGS: stored photons and the peak of memory.
takes()
{
	settle "$2" "$1"
	status 0 room.pov -F --stats room.json
	sed -n -e 's/.*"stored": \([0-9]*\),.*/\1/p' -e 's/.*"peak_memory": //p' \
		room.json
}

# check SETTINGS: bytes a photon more, between few and many, beside what is told of far more.
check()
{
	settle "$1" 2000000000
	"$COGNAC" room.pov -F +W8 +H6 >out 2>err && fail "$1: not refused"
	number='\([0-9]*\)'
	told=$(sed -n "s/.*about $number million photons, which take $number GB.*/\1 \2/p" err)
	few=$(takes 40000 "$1")
	many=$(takes 240000 "$1")
	# shellcheck disable=SC2086
	echo $few $many $told | awk '
		{ took = ($4 - $2) / ($3 - $1); told = 1000 * $6 / $5; print took, told }
		NF != 6 || took > 1.1 * told || took < 0.85 * told { exit 1 }' >ratio ||
		fail "$1: a photon takes, and is told to take, $(cat ratio) bytes"
}

check ''
check 'relaxation { plain iterations 2, 0 }'
check 'relaxation { constrained iterations 2, 0 }'
check 'relaxation { constrained iterations 1, 1 repulsion_neighbors 64 }'
finish
