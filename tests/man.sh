#!/bin/sh
# The manual pages: clean for mandoc's lint, and their examples run as they stand.
. "$SOURCES/tests/cli/common.sh"

pages="cognac.1 cognac-compare.1 cognac-layer.1 cognac-merge.1 cognac-language.5 cognac-photons.7"
if command -v mandoc >/dev/null; then
	for page in $pages; do
		# Whether other pages are installed here is not this page's fault.
		mandoc -T lint "$SOURCES/man/$page" 2>&1 |
			grep -v 'referenced manual not found\|mandoc.db' >lint
		[ ! -s lint ] || fail "$(cat lint)"
	done
fi

# The literal blocks below EXAMPLES, apart by lines of ---.
examples()
{
	sed -n '/^\.Sh EXAMPLES/,/^\.Sh SEE/p' "$SOURCES/man/$1" |
		sed -n '/^\.Bd/,/^\.Ed/{/^\.Bd/d;s/^\.Ed/---/;p;}'
}

# Every word of the language's extension and every long option has its place.
for word in $(sed -n 's/^WORD(.*, "\(.*\)", WORD_EXTENSION)$/\1/p' "$SOURCES/lang/words.def"); do
	grep -q "^\.\(Ic\|It Ic\) \(.* \)*$word\b" "$SOURCES/man/cognac-language.5" ||
		fail "cognac-language.5 does not know $word"
done
options=$(sed -n 's/^\t{"\([a-z-]*\)", .*, \(true\|false\)},$/\1/p' "$SOURCES/src/cli/words.c")
for option in $options; do
	grep -q "^\.It.* Fl -$option\b" "$SOURCES/man/cognac.1" ||
		fail "cognac.1 does not know --$option"
done

# Each line of the examples of a page is a command.
run_examples()
{
	examples "$1" | grep -v '^---' >commands
	[ -s commands ] || fail "$1 has no examples"
	while read -r line; do
		sh -c "$line" >out 2>err </dev/null || fail "$1: $line: $(head -n 1 err)"
	done <commands
}

mkdir bin
ln -s "$COGNAC" bin/cognac
ln -s "$COMPARE" bin/cognac-compare
ln -s "$LAYER" bin/cognac-layer
ln -s "$MERGE" bin/cognac-merge
PATH=$work/bin:$PATH
export PATH
cp ball.pov scene.pov
run_examples cognac.1
cp scene.png a.png
"$COGNAC" scene.pov +W160 +H120 +Q3 +Ob.png >out 2>err
run_examples cognac-compare.1
run_examples cognac-layer.1
run_examples cognac-merge.1
run_examples cognac-photons.7
# Each example of the language is a scene.
examples cognac-language.5 |
	awk 'BEGIN { n = 1 } /^---/ { n++; next } { print >("language" n ".pov") }'
[ -f language2.pov ] || fail "cognac-language.5 has too few examples"
for scene in language*.pov; do
	status 0 "$scene"
done
finish
