"""The scenes that caustics are measured on: for each a camera close to its caustic, so that this
fills the picture, and what references and tests share.
"""

import hashlib
import json
import math
import os
import subprocess
import tempfile
from typing import NamedTuple

SIZE = 256  # pixels, both ways


class Close(NamedTuple):
    """A camera, and the crop that is shown large: its name, x, y, width and height in pixels."""

    location: tuple
    look_at: tuple
    angle: float  # degrees
    crop: tuple


CAMERAS = {
    "prism": Close((6.5, 12, -11.5), (5.1, 0, -2.3), 28, ("folds", 90, 70, 96, 96)),
    "cognac": Close((14, 15, -15), (5.6, 0, -4.7), 27, ("crossing", 64, 56, 96, 96)),
    "halogen": Close((-13, 15, -20), (-2.5, 0, -3.5), 40, ("facets", 60, 110, 96, 96)),
    "rings": Close((0.8, 12, -7), (-0.35, 0, 0.15), 24, ("cusp", 48, 32, 96, 96)),
    "egg": Close((6, 10, -8), (2.7, 0, -1.2), 26, ("focus", 76, 64, 96, 96)),
    "pool": Close((-0.6, 3, -2.9), (0.1, -1.5, -0.3), 34, ("knot", 130, 40, 96, 96)),
    "pool_night": Close((-1.5, 1.4, -3), (0.3, 1.9, 5), 46, ("band", 48, 80, 96, 96)),
    "wine": Close((10, 12, -12), (6.6, 0, -2.8), 22, ("focus", 64, 64, 96, 96)),
    "ring": Close((0.8, 15, -9), (1.2, 0, 0), 18, ("cusp", 112, 80, 96, 96)),
    "crab": Close((-5, 9, -9.5), (-1.4, 0, -2), 28, ("wall", 96, 150, 96, 96)),
    "dragon": Close((1, 10, -9), (0.6, 0, -2.6), 34, ("scales", 120, 100, 96, 96)),
}
SCENES = tuple(CAMERAS)

# Lines across filaments where sheets lie over each other: x, y from, to, in pixels.
FILAMENTS = {
    "prism": {"middle band": (95, 111, 92, 120), "lower fold": (148.5, 149, 145, 156)},
    "cognac": {"left ray": (106, 70, 121, 73.5)},
    "rings": {"inner cusp": (112, 86.5, 124, 96)},
}


def vector(v):
    return "<%.9g, %.9g, %.9g>" % v


def footprint(name):
    """Width of a pixel where the camera looks, scene units."""
    close = CAMERAS[name]
    half = math.tan(math.radians(close.angle / 2))
    return 2 * math.dist(close.location, close.look_at) * half / SIZE


def digest(path):
    """Of a scene but for its default count, which all calls here override."""
    with open(path, "rb") as file:
        lines = [line for line in file if b"#declare Photon_Count" not in line]
    return hashlib.sha256(b"".join(lines)).hexdigest()


def text(name, folder, settings=""):
    """A scene with the close camera around NAME.pov of a folder; settings go into photons { }."""
    close = CAMERAS[name]
    camera = (
        f"  location {vector(close.location)}\n  look_at {vector(close.look_at)}\n"
        f"  right x\n  angle {close.angle}\n"
    )
    return (
        f"#version unofficial cognac 1.0;\n// {digest(os.path.join(folder, name + '.pov'))}\n"
        f'#include "{name}.pov"\n'
        f"camera {{\n{camera}}}\nglobal_settings {{ photons {{ {settings} }} }}\n"
    )


def add_arguments(parser, threads):
    """What tells a Program where things are."""
    parser.add_argument("--cognac", default="./cognac")
    parser.add_argument("--compare", default="./cognac-compare")
    parser.add_argument("--scenes", default="scenes", help="the folder of the scenes")
    parser.add_argument("--library", action="append", default=[], help="more folders with includes")
    parser.add_argument("--threads", type=int, default=threads)


class Program:
    """Calls cognac on close-ups; words that are the same for all calls."""

    def __init__(self, cognac, scenes, threads=0, library=()):
        self.cognac, self.scenes = os.path.abspath(cognac), os.path.abspath(scenes)
        self.words = ["-V", f"+W{SIZE}", f"+H{SIZE}", "-A", f"+WT{threads}"]
        self.words += [f"+L{folder}" for folder in map(os.path.abspath, library)]

    def run(self, scene, *words):
        """Waits for it; it ends with us. Raises CalledProcessError. Paths are absolute: it runs
        where the scenes are, so that no others of their names are found before them."""
        process = subprocess.Popen([self.cognac, *self.words, *words, scene], cwd=self.scenes)
        try:
            status = process.wait()
        finally:
            if process.poll() is None:
                process.terminate()
                process.wait()
        if status != 0:
            raise subprocess.CalledProcessError(status, process.args)

    def trace(self, name, settings, count, seed, *words):
        """The statistics of photons for a count, without a picture."""
        with tempfile.TemporaryDirectory() as folder:
            scene, stats = os.path.join(folder, "close.pov"), os.path.join(folder, "stats.json")
            with open(scene, "w") as file:
                file.write(text(name, self.scenes, settings))
            self.run(
                scene,
                "-F",
                "+W8",
                "+H8",
                f"Declare=Photon_Count={count}",
                f"--seed={seed}",
                f"--stats={stats}",
                *words,
            )
            with open(stats) as file:
                return json.load(file)["photons"]

    def count_for(self, name, stored):
        """The Photon_Count that stores about so many photons."""
        trial = 200000
        return max(1, round(trial * stored / self.trace(name, "", trial, 0)["stored"]))
