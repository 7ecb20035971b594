#!/usr/bin/env python3
"""Writes the dragon of dragon.pov: one closed tube of scales, knotted like a serpent, as POV-Ray
mesh2 text.

dragon.py [ALONG [AROUND]] > dragon.inc: so many quadrilaterals along the body and around it."""

import math
import sys


def add(a, b, s=1.0):
    return (a[0] + s * b[0], a[1] + s * b[1], a[2] + s * b[2])


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def unit(a):
    length = math.sqrt(sum(x * x for x in a)) or 1.0
    return (a[0] / length, a[1] / length, a[2] / length)


def spine(t):
    """The middle of the body, t from 0 (tail) to 1 (nose): two coils that widen and rise a little,
    then the neck stands up from the middle and bends forward to the head."""
    turn = 2 * math.pi * (0.30 + 1.75 * t)
    neck = max(0.0, (t - 0.70) / 0.30)
    bend = max(0.0, (t - 0.88) / 0.12)
    wide = 3.1 - 0.9 * t - 1.3 * neck * neck * (3 - 2 * neck) + 1.7 * bend * bend
    rise = 0.42 + 0.75 * t * t + 3.3 * neck * neck * (3 - 2 * neck) - 0.75 * bend * bend
    return (wide * math.cos(turn), rise, wide * math.sin(turn))


def thickness(t):
    """Thin at the tail, thick in the middle, a neck, a head with brows that ends in a muzzle."""
    body = 0.46 * math.sin(math.pi * min(1.0, 0.05 + 0.80 * t)) ** 1.1
    head = 0.30 * math.exp(-(((t - 0.945) / 0.020) ** 2)) + 0.15 * math.exp(
        -(((t - 0.983) / 0.014) ** 2)
    )
    close = min(1.0, t / 0.04, (1.0 - t) / 0.006)
    return (body + head) * math.sqrt(max(close, 0.0))


def relief(t, a):
    """What scales, belly and comb add to the radius; a is the angle around, 0 on the back."""
    u, v = 52 * t, 7 * a / math.pi
    scale = abs(math.sin(math.pi * (u + v))) * abs(math.sin(math.pi * (u - v)))
    belly = 0.5 - 0.5 * math.cos(a)
    saw = (34 * t) % 1.0
    comb = math.exp(-((math.sin(a / 2) / 0.12) ** 2)) * (1 - saw) ** 1.5 if 0.06 < t < 0.92 else 0.0
    return (
        0.07 * scale * (1 - belly**3)
        + 0.04 * belly**3 * math.cos(2 * math.pi * 44 * t)
        + 0.85 * comb
    )


def frames(along):
    """Points of the spine with two unit vectors across it; the first points to the back, upwards as
    far as it can.
    """
    points = [spine(i / along) for i in range(along + 1)]
    for i, point in enumerate(points):
        ahead = unit(add(points[min(i + 1, along)], points[max(i - 1, 0)], -1))
        side = unit(cross(ahead, (0, 1, 0)))
        yield i / along, point, cross(side, ahead), side


def skin(along, around):
    rows = []
    for t, point, back, side in frames(along):
        row = []
        for j in range(around):
            a = 2 * math.pi * j / around
            r = thickness(t) * (1 + relief(t, a if a <= math.pi else 2 * math.pi - a))
            row.append(add(add(point, back, r * math.cos(a)), side, r * math.sin(a)))
        rows.append(row)
    return rows


def normals(rows):
    along, around = len(rows), len(rows[0])
    for i, row in enumerate(rows):
        for j in range(around):
            du = add(rows[min(i + 1, along - 1)][j], rows[max(i - 1, 0)][j], -1)
            dv = add(row[(j + 1) % around], row[j - 1], -1)
            yield unit(cross(dv, du))


def faces(along, around):
    for i in range(along - 1):
        for j in range(around):
            a, b = i * around + j, i * around + (j + 1) % around
            yield a, b, b + around
            yield a, b + around, a + around


def write(name, items, form):
    items = list(items)
    print(f"  {name} {{\n    {len(items)}")
    for item in items:
        print("    , <" + ", ".join(form % x for x in item) + ">")
    print("  }")


def main():
    along = int(sys.argv[1]) if len(sys.argv) > 1 else 1200
    around = int(sys.argv[2]) if len(sys.argv) > 2 else 48
    rows = skin(along, around)
    print("#declare Dragon = mesh2 {")
    write("vertex_vectors", (p for row in rows for p in row), "%.5g")
    write("normal_vectors", normals(rows), "%.4g")
    write("face_indices", faces(along + 1, around), "%d")
    print("  inside_vector y\n};")


main()
