# Golden tests of what the reader says about mistakes: each errors/NAME.pov must give exactly
# errors/NAME.err on standard error. `COGNAC=... SOURCES=... sh errors.sh --regenerate` writes the
# .err files anew: read the difference before committing it.
cd "$SOURCES/tests/errors" || exit 1
failures=0
for scene in *.pov; do
	name=${scene%.pov}
	if test "$1" = --regenerate; then
		"$COGNAC" "+I$scene" -F -V +W8 +H6 +WT1 2>"$name.err" >/dev/null
		continue
	fi
	said=$("$COGNAC" "+I$scene" -F -V +W8 +H6 +WT1 2>&1 >/dev/null; echo "status $?")
	if test -s "$name.err" && grep -q 'error: ' "$name.err"; then wanted=1; else wanted=0; fi
	expected=$(cat "$name.err"; echo "status $wanted")
	if test "$said" != "$expected"; then
		failures=$((failures + 1))
		printf '%s\n' "errors/$scene: expected" "$expected" "got" "$said"
	fi
done
test $failures = 0
