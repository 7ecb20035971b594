#!/usr/bin/env python3
"""Measures the figures of src/surface/noise_tables_make.c with POV-Ray and prints them as they
stand there.

Needs povray and its includes; no part of `make check`. Lattice points show what hangs on them: the
value of the noise is half an entry of the table, the slopes are the next three; the vector noise
shows the entries beyond 255. Generator 3 has no values, only unit gradients; measuring them along y
shows the order in which lattice points use them.
"""

import math
import os
import subprocess
import tempfile

SHIFT = 12432434 / 2**29  # how far generator 3's lattice lies below the whole numbers
STATE = 1 << 32


def evaluate(expressions):
    """The values of scene-language expressions, one or more numbers a line."""
    with tempfile.TemporaryDirectory() as folder:
        with open(os.path.join(folder, "scene.pov"), "w") as scene:
            scene.write('#version 3.7;\n#include "functions.inc"\n#fopen F "out" write\n')
            for e in expressions:
                scene.write('#write(F, %s, "\\n")\n' % e)
            scene.write("#fclose F\n")
        subprocess.run(
            ["povray", "+Iscene.pov", "-F", "-D", "+W1", "+H1"],
            cwd=folder,
            check=True,
            capture_output=True,
        )
        with open(os.path.join(folder, "out")) as out:
            return [[float(x) for x in line.split()] for line in out]


def noise(generator, x, y, z):
    return "str(f_noise_generator(%r,%r,%r,%d),0,17)" % (x, y, z, generator)


def vector(x, y, z):
    return 'vstr(3,vturbulence(2,0.5,1,<%r,%r,%r>)," ",0,17)' % (x, y, z)


def draws(state):
    while True:
        state = (state * 1812433253 + 12345) % STATE
        yield state >> 16 & 0x7FFF


def shuffled():
    table = list(range(4096))
    random = draws(0)
    for i in range(4095, -1, -1):
        j = next(random) % 4096
        table[i], table[j] = table[j], table[i]
    return table


TABLE = shuffled()


def lattice_hash(x, y, z):
    h = TABLE[x + 10000 & 4095]
    h = TABLE[h ^ y + 10000 & 4095]
    return TABLE[h ^ z + 10000 & 4095] & 255


def fade(t):
    return t * t * (3 - 2 * t)


def measure_entries():
    place = {}
    for z in range(4096):
        place.setdefault(lattice_hash(0, 0, z), z)
    values = evaluate([noise(1, 0, 0, place[h]) for h in range(256)])
    entries = [2 * (v[0] - 0.5) for v in values] + [0.0] * 11
    last = evaluate([vector(0, 0, place[255])])[0]
    entries[259], entries[263] = 2 * last[1], 2 * last[2]
    step = 0.125
    for axis in range(3):  # the slopes at a point of hash 255 whose neighbour is known
        for z in range(4096):
            neighbour = [int(k == axis) + (z if k == 2 else 0) for k in range(3)]
            if lattice_hash(0, 0, z) == 255 and lattice_hash(*neighbour) < 240:
                break
        at = [step * (k == axis) + (z if k == 2 else 0) for k in range(3)]
        for part, measured in enumerate(evaluate([vector(*at)])[0]):
            other = lattice_hash(*neighbour) + 4 * part
            far = entries[other] / 2 + entries[other + 1 + axis] * (step - 1)
            near = (measured - fade(step) * far) / (1 - fade(step))
            entries[255 + 4 * part + 1 + axis] = (near - entries[255 + 4 * part] / 2) / step
    return ["%.6g" % e for e in entries]


def gradients():
    random = draws(1)
    found = []
    while len(found) < 2048:
        v = [next(random) % 4096 - 2048 for _ in range(3)]
        length = math.sqrt(sum(k * k for k in v))
        if 0 < length <= 2048:
            found.append([k / length for k in v])
    return found


def slope(a, b, ta=0.25, tb=0.5):
    """The slope at a lattice point from the noise at two places on the edge to its neighbour."""
    (g1, q1), (g2, q2) = ((t * (1 - fade(t)), (t - 1) * fade(t)) for t in (ta, tb))
    a, b = a - 0.4925, b - 0.4925
    return (a * q2 - b * q1) / (g1 * q2 - g2 * q1) / 0.795


def measure_order():
    index = {tuple(round(k, 6) for k in g): i for i, g in enumerate(gradients())}
    expressions = []
    for y in range(2048):
        for axis in range(3):
            for t in (0.25, 0.5):
                at = [-SHIFT, y - SHIFT, -SHIFT]
                at[axis] += t
                expressions.append(noise(3, *at))
    v = [line[0] for line in evaluate(expressions)]
    order = []
    for y in range(2048):
        g = tuple(round(slope(*v[6 * y + 2 * axis : 6 * y + 2 * axis + 2]), 6) for axis in range(3))
        order.append(str(index[g]))
    return order


def print_table(name, items):
    print(name + " = {")
    line = "\t"
    for item in items:
        if len(line.expandtabs(8)) + len(item) + 2 > 98:
            print(line.rstrip())
            line = "\t"
        line += item + ", "
    print(line.rstrip() + "\n};")


print_table("static const double entries[267]", measure_entries())
print_table("static const uint16_t perlin_hash[PERLIN_COUNT]", measure_order())
