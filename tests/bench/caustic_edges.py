#!/usr/bin/python3
"""How well filaments of a caustic are kept where sheets of light lie over each other: profiles of
the layer caustic across the lines of caustic_scenes.py, each the mean over some pixels along the
filament. Prints for the reference and every picture:

contrast   Michelson's: (peak - base) / (peak + base), base being the darkest on the darker side
width      from a tenth to nine tenths of the way from that base up to the peak, in pixels
shape      RMSE of the profile beside the reference's, of the reference's peak"""

import argparse
import os

import numpy

import caustic_scenes
import exr

STEP = 0.25  # of a profile, in pixels
BREADTH = 5  # pixels along the filament that are averaged
LINES = 9  # parallel ones, over the breadth


def bilinear(picture, x, y):
    """At coordinates whose pixels' middles are at halves."""
    x, y = x - 0.5, y - 0.5
    column, row = numpy.floor(x).astype(int), numpy.floor(y).astype(int)
    right, down = x - column, y - row
    top = picture[row, column] * (1 - right) + picture[row, column + 1] * right
    bottom = picture[row + 1, column] * (1 - right) + picture[row + 1, column + 1] * right
    return top * (1 - down) + bottom * down


def profile(picture, line):
    start, end = numpy.array(line[:2], float), numpy.array(line[2:], float)
    length = numpy.hypot(*(end - start))
    along = (end - start) / length
    steps = numpy.arange(0, length, STEP)
    rows = []
    for aside in numpy.linspace(-BREADTH / 2, BREADTH / 2, LINES):
        place = start + aside * numpy.array([-along[1], along[0]])
        rows.append(bilinear(picture, place[0] + steps * along[0], place[1] + steps * along[1]))
    return numpy.mean(rows, axis=0)


def crossing(values, level):
    """Where values, from the peak outwards, first fall below a level; in steps."""
    below = int(numpy.argmax(values < level))
    if values[below] >= level:
        return float("nan")
    return below - (level - values[below]) / (values[below - 1] - values[below])


def measure(values):
    """(contrast, width)"""
    peak = int(numpy.argmax(values))
    sides = [values[peak:], values[peak::-1]]
    side = min(sides, key=min)
    base, top = float(side.min()), float(values[peak])
    rise = top - base
    width = crossing(side, base + 0.1 * rise) - crossing(side, base + 0.9 * rise)
    return (top - base) / (top + base), STEP * width


def picture_of(path):
    return exr.layer(exr.read(path)[0], "caustic").mean(axis=2)


def print_filament(name, line, reference, paths):
    truth = profile(reference, line)
    print(f"\n{name}\n{'':24} contrast    width    shape")
    for path, picture in [("reference", reference)] + [(p, picture_of(p)) for p in paths]:
        values = profile(picture, line)
        contrast, width = measure(values)
        shape = numpy.sqrt(((values - truth) ** 2).mean()) / truth.max()
        title = os.path.basename(path).removesuffix(".exr")
        print(f"{title:24} {contrast:8.3f} {width:8.2f} {shape:8.4f}")


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("scene", choices=sorted(caustic_scenes.FILAMENTS))
    parser.add_argument("reference")
    parser.add_argument("pictures", nargs="+", help="of caustics.py's folder")
    options = parser.parse_args()
    reference = picture_of(options.reference)
    for name, line in caustic_scenes.FILAMENTS[options.scene].items():
        print_filament(f"{options.scene}, {name}", line, reference, options.pictures)


if __name__ == "__main__":
    main()
