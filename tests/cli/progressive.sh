#!/bin/sh
# Progressive passes: the radius starts from the photons' spacing and shrinks as Knaus and Zwicker
# have it, and the picture's error against a closed form falls with it.
. "$SOURCES/tests/cli/common.sh"

# Parallel light through a ball of glass, on a floor 1.3 below its centre; the camera stands
# between.
cat >ball.pov <<'END'
#version unofficial cognac 1.0;
#ifndef (Radius) #declare Radius = 0; #end
#ifndef (Count) #declare Count = 3000; #end
global_settings {
  assumed_gamma 1 max_trace_level 5
  photons { count Count progressive { #if (Radius) radius Radius #end } }
}
camera { orthographic location 0.2 * y look_at 0 right 0.4 * x up 0.4 * z }
light_source { 9 * y, 0.2 parallel point_at 0 photons { refraction on reflection off } }
plane { y, 0 pigment { rgb 1 } finish { ambient 0 diffuse 1 } }
sphere {
  1.3 * y, 1 pigment { rgbt 1 } finish { ambient 0 diffuse 0 } interior { ior 1.05 }
  photons { target refraction on collect off }
}
END
cat >errors.py <<'END'
import json, math, sys

def landing(h):
    turn = 2 * (math.asin(h) - math.asin(h / 1.05))
    return (h - 1.3 * math.sin(turn)) / math.cos(turn)

def brightness(r):
    """Rays land farther out the farther out they meet the ball, as far as the picture goes."""
    low, high = 0, 0.8
    for _ in range(60):
        middle = (low + high) / 2
        low, high = (middle, high) if landing(middle) < r else (low, middle)
    step = 1e-5
    return 0.2 * low / r * 2 * step / (landing(low + step) - landing(low - step))

def error(path):
    values = open(path, "rb").read()[-6 * 24 * 24:]
    total = 0
    for i in range(24 * 24):
        r = math.hypot((i % 24 + 0.5) / 24 - 0.5, (i // 24 + 0.5) / 24 - 0.5) * 0.4
        total += ((values[6 * i] * 256 + values[6 * i + 1]) / 65535 / brightness(r) - 1) ** 2
    return math.sqrt(total / 24 / 24)

def photons(path):
    def find(node):
        if isinstance(node, dict):
            if "first_radius" in node:
                return node
            node = list(node.values())
        for child in node if isinstance(node, list) else []:
            found = find(child)
            if found:
                return found
    return find(json.load(open(path)))

few, many = error("2.ppm"), error("128.ppm")
slope = math.log(many / few) / math.log(128 / 2)
# alpha = 2/3: variance falls with the passes to the power -2/3, noise to -1/3. Passes go on in one
# sequence of low discrepancy, so it may fall faster.
if not (0.02 < few < 0.3 and -1 < slope < -0.3):
    print(f"relative error {few:.4f} after 2 passes, {many:.4f} after 128:",
          f"exponent {slope:.3f}, not -1/3")
first = photons("128.json")
if abs(first["first_radius"] / 0.1 - 1) > 1e-6:
    print(f"the first radius is {first['first_radius']}, not 0.1")
wanted = 0.1 * math.sqrt(math.prod((i + 2 / 3) / (i + 1) for i in range(1, 128)))
if abs(first["radius"] / wanted - 1) > 1e-4:
    print(f"the radius of pass 128 is {first['radius']}, not {wanted}")
small, large = photons("12000.json")["first_radius"], photons("3000.json")["first_radius"]
if abs(large / small / 2 - 1) > 0.1:
    print(f"four times the photons change the first radius from {large} to {small}, not to half")
# The lit disc has the radius of the farthest landing; 50 photons at its mean density, which is not
# its median.
if not 0.5 < large / math.sqrt(50 / 3000) / max(landing(i / 1000) for i in range(900)) < 1.5:
    print(f"the first radius, {large}, does not hold some 50 photons")
END
for passes in 2 128; do
	status 0 ball.pov +W24 +H24 +FP16 File_Gamma=1 "+O$passes.ppm" --passes "$passes" \
		--stats "$passes.json" Declare=Radius=0.1
done
for count in 3000 12000; do
	status 0 ball.pov +W24 +H24 "+O$count.png" --passes 1 --stats "$count.json" \
		"Declare=Count=$count"
done
# Passes look through other places in the pixels: the one pixel that a bright wall covers to 0.3
# becomes 0.3. -J has all look through its middle, which the wall leaves free.
cat >wall.pov <<'END'
#version unofficial cognac 1.0;
global_settings { assumed_gamma 1 photons { count 100 progressive { passes 64 } } }
camera { orthographic location -z direction z right x up y }
light_source { 9 * y, 1 photons { refraction on } }
plane { z, 0 pigment { rgb 1 } finish { ambient 1 diffuse 0 } clipped_by { plane { x, -0.2 } } }
sphere { 9 * x, 1 pigment { rgbt 1 } interior { ior 1.2 } photons { target refraction on } }
END
cat >walls.py <<'END'
moved, still = (int.from_bytes(open(path, "rb").read()[-6:-4], "big") / 65535
                for path in ("moved.ppm", "still.ppm"))
if abs(moved - 0.3) > 0.03 or still != 0:
    print(f"of a pixel 0.3 is lit: its passes' mean is {moved:.3f}, and {still:.3f} with -J")
END
status 0 wall.pov +W1 +H1 -A +FP16 File_Gamma=1 +Omoved.ppm
status 0 wall.pov +W1 +H1 -A -J +FP16 File_Gamma=1 +Ostill.ppm
python3 walls.py >said || fail "walls.py failed"
[ ! -s said ] || fail "$(cat said)"
python3 errors.py >said || fail "errors.py failed"
[ ! -s said ] || fail "$(cat said)"
finish
