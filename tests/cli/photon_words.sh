#!/bin/sh
# What each of POV-Ray's words about photons does, on a scene of its own: a small clear pane or ball
# over a white floor.
. "$SOURCES/tests/cli/common.sh"

# scene GLOBAL LIGHT OBJECT [MORE]: writes words.pov with these words in the three photons blocks,
# and more items.
scene()
{
	cat >words.pov <<-END_OF_SCENE
	#version unofficial cognac 1.0;
	global_settings { assumed_gamma 1 max_trace_level 10 photons { $1 } }
	camera { orthographic location 3 * y look_at 0 right 3 * x up 3 * z }
	light_source { 20 * y, 0.5 photons { $2 } }
	plane { y, 0 pigment { rgb 1 } finish { ambient 0 diffuse 1 } }
	object {
	  #ifdef (Thing) Thing #else box { <-1, 4, -1>, <1, 4.1, 1> } #end
	  pigment { rgbt 1 } finish { ambient 0 diffuse 0 reflection 0.2 conserve_energy }
	  interior { ior 1.5 }
	  photons { $3 }
	}
	$4
	END_OF_SCENE
	shoot
}

# shoot WORD...: renders words.pov; statistics in s.json, picture in p.ppm.
shoot()
{
	status 0 words.pov +W32 +H32 +FP16 File_Gamma=1 +Op.ppm --stats s.json "$@"
}

# statistic NAME: a count of photons.
statistic()
{
	tr ',{}' '\n\n\n' <s.json | sed -n "s/^ *\"$1\": *//p" | head -n 1
}

# flux NAME: in grey.
flux()
{
	sed -n 's/.*"flux": {\(.*\)}}.*/\1/p' s.json | tr ',' '\n' | sed -n "s/^ *\"$1\": *//p"
}

# near WHAT GOT WANTED [TOLERANCE]: within one part in a hundred.
near()
{
	awk "BEGIN { d = ($2 + 0) - ($3); exit !(d * d <= (${4:-0.01} * ($3)) ^ 2) }" ||
		fail "$1 is $2, not $3"
}

# holds WHAT CONDITION
holds()
{
	awk "BEGIN { exit !($2) }" || fail "$1: not $2"
}

# The picture's mean, 0 to 1; that of its middle, where no border is near; how much pixels differ
# there.
mean()
{
	tail -c 6144 "${1:-p.ppm}" |
		od -An -v -tu1 -w6 | awk '{ s += 256 * $1 + $2 } END { print s / NR / 65535 }'
}
middle()
{
	tail -c 6144 "${1:-p.ppm}" | od -An -v -tu1 -w6 | awk '
		int(NR / 32) >= 11 && int(NR / 32) < 20 && NR % 32 >= 11 && NR % 32 < 20 {
			n++; s += 256 * $1 + $2 }
		END { print s / n / 65535 }'
}
noise()
{
	tail -c 6144 "${1:-p.ppm}" | od -An -v -tu1 -w6 | awk '
		int(NR / 32) >= 11 && int(NR / 32) < 20 && NR % 32 >= 11 && NR % 32 < 20 {
			v = (256 * $1 + $2) / 65535; n++; s += v; q += v * v }
		END { print sqrt(q / n - s / n * s / n) / (s / n) }'
}

both='refraction on reflection on'
target="target $both collect off"

# ---- how many ----
scene 'count 20000' "$both" "$target"
near "paths at the pane's box, for a count of 20000" \
	"$(statistic absorbed) + $(statistic escaped)" 20000 0.1
bright=$(mean)
holds "the pane's light" "$bright > 0.05"
scene 'spacing 0.02' "$both" "$target"; coarse=$(statistic paths)
near "one photon in each square of the spacing" "$(statistic absorbed) + $(statistic escaped)" \
	'4 / 0.02 ^ 2' 0.1
near "brightness with spacing" "$(mean)" "$bright"
scene 'spacing 0.01' "$both" "$target"
near "paths with half the spacing" "$(statistic paths)" "4 * $coarse"
scene 'spacing 0.02' "$both" "target 0.5 $both collect off"
near "paths with target 0.5" "$(statistic paths)" "4 * $coarse"
near "brightness with target 0.5" "$(mean)" "$bright"
scene 'spacing 0.02' "$both" "target 0 $both"
[ "$(statistic paths)" = 0 ] || fail "target 0 is a target"

# ---- where they go ----
scene 'count 20000' 'refraction off reflection off' "$target"
[ "$(statistic paths)" = 0 ] || fail "a light without photons sends photons"
scene 'count 20000' "$both" 'target'
[ "$(statistic paths)" = 0 ] || fail "a target that neither refracts nor reflects is shot at"
scene 'count 20000' 'refraction on reflection off' "$target"; through=$(flux stored)
scene 'count 20000' "$both" 'target refraction on reflection off collect off'
[ "$(flux stored)" = "$through" ] ||
	fail "reflection off means something else for lights and objects"
near "light through two faces without reflection" "$through / ($(flux emitted))" '0.8 * 0.8' 0.02
scene 'count 20000' 'refraction off reflection on' "$target"
[ "$(statistic stored)" = 0 ] || fail "refraction off refracts"
near "light that the upper face reflects" "$(flux escaped)" "0.2 * $(flux emitted)" 0.02

# ---- how far along the path ----
for levels in 1 2 3 4 5; do
	scene "count 20000 max_trace_level $levels" "$both" "$target"
	[ "$levels" -lt 3 ] &&
		holds "$levels levels do not come through" \
		"$(flux stored) < 0.001 * $(flux emitted)"
	[ "$levels" = 3 ] && near "light of three levels" "$(flux stored) / $(flux emitted)" \
		'0.8 * 0.8' 0.02
	[ "$levels" = 5 ] && near "light of five levels" "$(flux stored) / $(flux emitted)" \
		'0.8 * 0.8 * 1.04' 0.02
done
scene 'count 20000 adc_bailout 0.5' "$both" "$target"; few=$(statistic segments)
near "light with adc_bailout 0.5" "$(flux stored) / $(flux emitted)" '0.8 / 1.2' 0.03
scene 'count 20000 adc_bailout 0.0001' "$both" "$target"
holds "paths with a small adc_bailout are longer" "$(statistic segments) >= $few"

# ---- how they start ----
scene 'count 20000 jitter 0' "$both" "$target"; cp p.ppm even.ppm
scene 'count 20000' "$both" "$target"; same p.ppm even.ppm "jitter 0 is the default"
scene 'count 20000 jitter 1' "$both" "$target"
cmp -s p.ppm even.ppm && fail "jitter does nothing"
near "brightness with jitter" "$(mean)" "$bright"
# A ring with a wide box; POV-Ray 3.7 shoots so many photons, and stores as many each time.
ring='#declare Thing = difference {
	cylinder { 4 * y, 4.1 * y, 2 } cylinder { 3.9 * y, 4.2 * y, 1.5 } }'
for case in '1 63625' '0 31689' '0.9 51763'; do
	cat >ring.pov <<-END_OF_SCENE
	$ring
	#include "words.pov"
	END_OF_SCENE
	scene "spacing 0.02 autostop ${case% *}" 'refraction on reflection off' \
		'target refraction on collect off'
	status 0 ring.pov +W32 +H32 +FP16 File_Gamma=1 +Op.ppm --stats s.json
	near "paths with autostop ${case% *}" "$(statistic paths)" "${case#* }" 0.03
	[ "${case% *}" = 1 ] && whole=$(flux emitted)
	near "light that meets the ring with autostop ${case% *}" "$(flux emitted)" "$whole"
done

# ---- how they are gathered ----
scene 'count 20000 gather 20, 400' "$both" "$target"; wide=$(noise)
scene 'count 20000 gather 20, 25' "$both" "$target"; narrow=$(noise)
holds "fewer photons are noisier" "$narrow > 2 * $wide"
scene 'count 20000 gather 1, 9000 radius 0.02' "$both" "$target"; narrow=$(noise)
scene 'count 20000 gather 1, 9000 radius 0.02, 3' "$both" "$target"
holds "three times the radius has a third of the noise" \
	"$(noise) < 0.5 * $narrow && $(noise) > 0.15 * $narrow"
near "brightness with a radius" "$(mean)" "$bright" 0.02
# Beyond the pane's edge the first disc is empty; the second is as dense as allowed, or has too few
# photons to be believed.
scene 'count 20000 gather 20, 9000 radius 0.1 expand_thresholds 0.2, 100000' "$both" "$target"
spread=$(mean)
scene 'count 20000 gather 20, 9000 radius 0.1 expand_thresholds 0.2, 0' "$both" "$target"
holds "expand_thresholds keeps the light in its borders" "$(mean) < 0.99 * $spread"

# ---- lights ----
scene 'count 20000' "$both share 3" "$target" \
	'light_source { <5, 20, 0>, 0.5 photons { refraction on } }'
cp s.json three.json
shoot --photons share.ply
python3 - share.ply <<'END_OF_PYTHON' || fail "share 3 does not mean three times the paths"
import sys
text = open(sys.argv[1], "rb").read()
head, body = text.split(b"end_header\n", 1)
lights = body[-2 * (len(body) // 1):]
kinds = {b"float": 4, b"uchar": 1, b"uint": 4, b"ushort": 2, b"double": 8, b"int": 4,
         b"float32": 4, b"uint8": 1, b"uint16": 2,
         b"uint32": 4, b"float64": 8}
elements = []
for line in head.splitlines():
    words = line.split()
    if words[0] == b"element":
        elements.append([words[1], int(words[2]), []])
    elif words[0] == b"property":
        elements[-1][2].append((words[2], words[1]))
at, paths = 0, []
import struct
for name, count, properties in elements:
    size = sum(kinds[kind] for _, kind in properties)
    for i in range(count):
        offset = at + i * size
        for word, kind in properties:
            if name == b"light" and word == b"paths":
                paths.append(struct.unpack_from({4: "<I", 8: "<d"}[kinds[kind]], body, offset)[0])
            offset += kinds[kind]
    at += size * count
sys.exit(not (len(paths) == 2 and abs(paths[0] / paths[1] / 3 - 1) < 0.1))
END_OF_PYTHON
shared=$(mean)
scene 'count 20000' "$both" "$target" 'light_source { <5, 20, 0>, 0.5 photons { refraction on } }'
near "brightness of two lights with shares" "$shared" "$(mean)"
scene 'count 20000' "$both share 0" "$target"
[ "$(statistic paths)" = 0 ] || fail "share 0 shares"
# An area light's photons blur the pane's edge.
sed 's/0\.5 photons/0.5 area_light 6 * x, 6 * z, 9, 9 photons/' words.pov >area.pov
for word in '' 'area_light'; do
	scene 'count 20000' "$both $word" "$target"
	sed 's/0\.5 photons/0.5 area_light 6 * x, 6 * z, 9, 9 photons/' words.pov >area.pov
	status 0 area.pov +W32 +H32 +FP16 File_Gamma=1 "+Oarea$word.ppm" --photons "area$word.ply"
done
cmp -s area.ppm areaarea_light.ppm && fail "area_light in a light's photons does nothing"

# ---- files ----
scene 'count 20000 save_file "map.ply"' "$both" "$target"; cp p.ppm saved.ppm
[ "$(head -n 1 map.ply)" = ply ] || fail "save_file writes no PLY"
scene 'count 5 load_file "map.ply"' "$both" "$target"
same saved.ppm p.ppm "a map that the scene loads"
scene 'count 5' "$both" "$target"
shoot --load-photons map.ply
same saved.ppm p.ppm "a map that the command line loads"

# ---- without the extension its words are names, with it POV-Ray's stay what they are ----
cat >names.pov <<'END_OF_SCENE'
#version 3.7;
#declare nearest = 1; #declare diffusion = 2; #declare footprint = 3; #declare estimator = 4;
#declare relaxation = 5;
#declare progressive = 6; #declare kernel = 7; #declare share = 8; #declare passes = 9;
#declare constrained = 11; #declare emitter_coordinates = 12; #declare reduction = 13;
#declare neighbors = 14;
#declare Sum = nearest + diffusion + footprint + estimator + relaxation + progressive +
  kernel + share + passes +
  constrained + emitter_coordinates + reduction + neighbors;
#if (Sum != 95) #error "the names are not numbers" #end
global_settings { photons { count 1000 } }
END_OF_SCENE
status 0 names.pov -F
sed 's/3\.7/unofficial cognac 1.0/' names.pov >words_on.pov
status 1 words_on.pov -F

# ---- estimators of the scene and of an object, by name as well ----
for estimator in 'nearest { count 30 kernel cone }' 'diffusion { count 100 diffusivity 1 }' \
	'footprint'; do
	scene "count 20000 estimator { $estimator }" "$both" "$target"; cp p.ppm global.ppm
	near "brightness with $estimator" "$(middle)" '0.5 * 0.8 * 0.8 * 1.04' 0.04
	scene 'count 20000' "$both" "$target"
	cmp -s global.ppm p.ppm && fail "the scene's $estimator does nothing"
	sed "s/diffuse 1 }/& photons { estimator { $estimator } }/" words.pov >object.pov
	status 0 object.pov +W32 +H32 +FP16 File_Gamma=1 +Op.ppm
	same global.ppm p.ppm "$estimator of the only receiver"
	sed "1a #declare Mine = estimator { $estimator };
s/diffuse 1 }/& photons { estimator { Mine } }/" words.pov >declared.pov
	status 0 declared.pov +W32 +H32 +FP16 File_Gamma=1 +Op.ppm
	same global.ppm p.ppm "$estimator, declared"
done
finish
