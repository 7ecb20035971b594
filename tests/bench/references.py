#!/usr/bin/python3
"""Reference pictures of the caustics' close-ups (caustic_scenes.py): many progressive passes of
the plainest estimator, all photons within a radius that shrinks (apa), through other places in the
pixels each, so that these are the pixels' means but for that radius; in two halves NAME.a.exr
and NAME.b.exr with seeds that no test uses, and their mean NAME.exr. Half the RMSE between the
halves is the error bar of the mean. Stopped in any way and called again it goes on where it was;
with more --photons it adds to what is there."""

import argparse
import hashlib
import json
import os
import signal
import subprocess
import sys

import caustic_scenes
import exr

SEEDS = {"a": 900001, "b": 900002}
# Of the first pass, in pixels: adds half of a pixel's own variance, a tenth at the end.
RADIUS = 0.5
UPDATE = 60  # seconds between safeguards of what is done


def put(path, text):
    with open(path + ".new", "w") as file:
        file.write(text)
    os.replace(path + ".new", path)


def settle(path, text, half_paths):
    """The scene in its place. When it is another one than last time what was made of that is
    useless."""
    old = open(path).read() if os.path.exists(path) else text
    if old != text:
        print(f"{path}: the scene has changed, beginning anew")
        for half in half_paths:
            for name in (half, half + ".state"):
                if os.path.exists(name):
                    os.remove(name)
    put(path, text)


def passes_in(path):
    """Whole passes; a run that was stopped in its first leaves a picture of no photons."""
    texts = exr.read(path)[1] if os.path.exists(path) else {}
    return int(texts["passes"]) if int(texts.get("photons", 0)) > 0 else 0


def combine(name, a, b, out, compare):
    """Writes the mean and says how good it is."""
    (planes, texts), (others, other_texts) = exr.read(a), exr.read(b)
    photons = [int(t["photons"]) for t in (texts, other_texts)]
    weight = photons[0] / sum(photons)
    mean = {key: weight * planes[key] + (1 - weight) * others[key] for key in planes if key != "Z"}
    run = subprocess.run(
        [compare, "--json", "--layer", "caustic", a, b], check=True, capture_output=True, text=True
    )
    level = float(exr.layer(mean, "caustic").mean())
    error = json.loads(run.stdout)["RMSE"] / 2
    pixel = caustic_scenes.footprint(name)
    texts.update(
        photons=str(sum(photons)),
        passes=f"{texts['passes']} and {other_texts['passes']}",
        seed=f"{texts['seed']} and {other_texts['seed']}",
        error=f"{error:.6g}",
        mean=f"{level:.6g}",
        pixel=f"{pixel:.6g}",
    )
    exr.write(out, mean, texts)
    return (
        f"{name}: {sum(photons) / 1e6:.1f} million photons, {texts['passes']} passes, "
        f"last radius {float(texts['radius']) / pixel:.2f} pixels; "
        f"error {error:.3g}, {100 * error / level:.2f}% of the mean {level:.4g}"
    )


class Maker:
    def __init__(self, options):
        self.options = options
        self.program = caustic_scenes.Program(
            options.cognac, options.scenes, options.threads, options.library
        )
        os.makedirs(options.folder, exist_ok=True)

    def path(self, *parts):
        return os.path.join(os.path.abspath(self.options.folder), ".".join(parts))

    def half(self, scene, name, letter, count, passes):
        """Into NAME.LETTER.exr, which holds whole passes at every moment."""
        self.program.run(
            scene,
            "+C",
            "+FE",
            f"+O{self.path(name, letter, 'exr')}",
            f"--seed={SEEDS[letter]}",
            f"--passes={passes}",
            f"--update={UPDATE}",
            f"Declare=Photon_Count={count}",
            "-GA",
        )

    def make(self, name):
        o = self.options
        halves = {letter: self.path(name, letter, "exr") for letter in SEEDS}
        radius = RADIUS * caustic_scenes.footprint(name)
        estimator = "estimator { nearest { kernel epanechnikov } }"
        settings = f"{estimator} progressive {{ radius {radius:.9g} }}"
        scene = self.path(name, "close.pov")
        settle(scene, caustic_scenes.text(name, o.scenes, settings), halves.values())
        count = self.count(name, scene)
        passes = max(1, round(o.photons / 2 / o.per_pass))
        for letter, path in halves.items():
            if passes_in(path) < passes:
                self.half(scene, name, letter, count, passes)
        line = combine(name, halves["a"], halves["b"], self.path(name, "exr"), o.compare)
        put(self.path(name, "txt"), line + "\n")
        print(line, flush=True)

    def count(self, name, scene):
        """Photon_Count, the same each time: a run that goes on must not change it."""
        path = self.path(name, "count")
        with open(scene, "rb") as file:
            key = f"{self.options.per_pass:.0f} {hashlib.sha256(file.read()).hexdigest()}"
        if os.path.exists(path) and open(path).read().split("\n")[0] == key:
            return int(open(path).read().split("\n")[1])
        count = self.program.count_for(name, self.options.per_pass)
        put(path, f"{key}\n{count}\n")
        return count


def arguments():
    parser = argparse.ArgumentParser(description=__doc__)
    caustic_scenes.add_arguments(parser, threads=0)
    parser.add_argument("--folder", default="references", help="where the pictures go")
    parser.add_argument(
        "--photons", type=float, default=134e6, help="stored photons of both halves together"
    )
    parser.add_argument("--per-pass", type=float, default=1e6, help="stored photons of a pass")
    parser.add_argument("names", nargs="*", default=[], metavar="scene")
    return parser.parse_args()


def main():
    options = arguments()
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(2))
    maker = Maker(options)
    for name in options.names or caustic_scenes.SCENES:
        maker.make(name)


if __name__ == "__main__":
    main()
