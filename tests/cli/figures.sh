#!/bin/sh
# The script of make figures-relaxation: panels and sheet come out, and a second run makes only what
# is missing.
. "$SOURCES/tests/cli/common.sh"

# Pictures so small that the test is quick.
printf '#!/bin/sh\nexec "%s" "$@" -A +W36 +H27\n' "$COGNAC" >small
chmod +x small
draw()
{
	COGNAC=$work/small sh "$SOURCES/scenes/figures/figures.sh" f 0.002 "$@" >out 2>err ||
		fail "figures $*: $(cat err)"
}

draw 0
for file in 0-0.exr 0-3.exr 0-0.png 0-3.png 0.ply figure0.png; do
	[ -s "f/$file" ] || fail "no $file"
done
grep -q '"relaxation"' f/0-3.json || fail "nothing was relaxed"
grep -q '"relaxation"' f/0-0.json && fail "relaxed where it should not"
cp -p f/0-0.exr kept.exr
rm f/0-3.exr
draw 0
[ "$(head -n 1 out)" = 0-3 ] || fail "made other panels: $(cat out)"
[ -s f/0-3.exr ] || fail "a missing panel was not made"
[ "$(stat -c %y f/0-0.exr)" = "$(stat -c %y kept.exr)" ] || fail "a panel was made again"
finish
