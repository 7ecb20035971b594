#!/usr/bin/python3
"""How far estimates of caustics are from the references (references.py), scene by scene and count
by count: RMSE, MRSE and SSIM of the layer caustic on the close-ups of caustic_scenes.py.

All estimators see the same photons: they are traced once a seed, relaxed once by each kind of
relaxation, and loaded. K "best" is searched on a seed of its own, or on that of the row where there
is no time for one more (--search-seed 0); what is printed is the mean over --seeds, but for
estimates of many photons, which hardly depend on the set. All that was measured is remembered in
--folder, so a run that was stopped goes on, and one over more counts costs only what is new. The
columns: K, with * if it is the best; RMSE and its part
of the reference's mean; MRSE; SSIM; RMSE beside that of nearest at its best K; how many photons
nearest at its best K would need for this RMSE (from its RMSE at the counts measured, as a power of
the count between them and beyond); processor seconds of the picture with all its samples, which
are as many a pixel for all methods (--samples): references are means over pixels.

The reference's own noise is in no RMSE or MRSE: its halves a and b are independent, so the mean of
(picture - a)(picture - b) is that of (picture - truth)^2."""

import argparse
import hashlib
import json
import math
import os
import subprocess
import sys

import caustic_scenes
import caustic_sheet
import exr

# Of K, by about the root of 2.
STEPS = (6, 8, 11, 15, 21, 30, 42, 60, 85, 120, 170, 240, 340, 480, 680, 960, 1360, 1920)
MANY = 480  # photons: an estimate from so many is measured on one seed
BEST = "best"

# Name: relaxation or None, estimator ({K} stands for a K), Ks.
METHODS = {
    "nearest": (None, "nearest {{ count {K} }}", (15, 50, 500, BEST)),
    "diffusion": (None, "diffusion {{ count {K} }}", (500,)),
    "plain": ("plain iterations 7, 7", "nearest {{ count {K} }}", (15, BEST)),
    "paper": (
        "constrained iterations 7, 7 range 3 gradient off hues off",
        "nearest {{ count {K} }}",
        (15, BEST),
    ),
    "constrained": ("constrained", "nearest {{ count {K} }}", (15, BEST)),
    "footprint": (None, "footprint", (0,)),
}
# Results that do not change while others are worked on: any program's are remembered.
KEPT = ("nearest", "diffusion", "plain")


def number(text):
    """60k, 3.3M, 134000"""
    factor = {"k": 1e3, "M": 1e6}.get(text[-1])
    return round(float(text[:-1]) * factor) if factor else round(float(text))


def short(count):
    return f"{count / 1e6:.3g}M" if count >= 1e6 else f"{count / 1e3:.3g}k"


def digest(path):
    with open(path, "rb") as file:
        return hashlib.sha256(file.read()).hexdigest()[:12]


def average(path, samples):
    """Makes one pixel of each square of samples. Kernels may be smaller than pixels are: one sample
    would add to their error what the reference has not."""
    planes, texts = exr.read(path)
    for name, plane in planes.items():
        height, width = (size // samples for size in plane.shape)
        planes[name] = plane.reshape(height, samples, width, samples).mean(axis=(1, 3))
    exr.write(path, planes, texts)


class Results:
    """Measurements by key, remembered between runs: a line of a file each, so that several runs may
    add to it at once."""

    def __init__(self, path):
        self.path, self.rows = path, {}
        if os.path.exists(path):
            with open(path) as file:
                self.rows = dict(json.loads(line) for line in file)

    def keep(self, key, row):
        self.rows[key] = row
        with open(self.path, "a") as file:
            file.write(json.dumps([key, row]) + "\n")


class Bench:
    """One scene at one count."""

    def __init__(self, options, name, count, seeds):
        self.options, self.name, self.count, self.seeds = options, name, count, seeds
        self.results = Results(os.path.join(options.folder, "kept.jsonl"))
        self.program = caustic_scenes.Program(
            options.cognac, options.scenes, options.threads, options.library
        )
        self.reference = os.path.join(options.references, name + ".exr")
        self.digest, self.build = digest(self.reference), digest(options.cognac)
        planes, self.texts = exr.read(self.reference)
        self.truth = exr.layer(planes, "caustic")
        self.halves = [
            exr.layer(exr.read(self.reference[: -len("exr")] + f"{half}.exr")[0], "caustic")
            for half in "ab"
        ]
        self.mean = float(self.truth.mean())
        self.paths = 0
        self.stored = set()  # files

    def path(self, *parts):
        return os.path.join(
            os.path.abspath(self.options.folder),
            ".".join(str(part) for part in (self.name, short(self.count), *parts)),
        )

    def write_scene(self, settings):
        path = self.path("close", "pov")
        with open(path, "w") as file:
            file.write(caustic_scenes.text(self.name, self.options.scenes, settings))
        return path

    def photons(self, relaxation, seed):
        """The file with the photons of a seed, traced once and relaxed from there; removed by
        forget()."""
        kind = hashlib.sha256(relaxation.encode()).hexdigest()[:8] if relaxation else "landed"
        path = self.path(seed, kind, "ply")
        if not os.path.exists(path):
            words, settings = [f"--photons={path}.new"], ""
            if relaxation:
                words.append(f"--load-photons={self.photons(None, seed)}")
                settings = f"relaxation {{ {relaxation} }}"
            self.program.trace(self.name, settings, self.emitted(), seed, *words)
            os.replace(path + ".new", path)
            self.stored.add(path)
        return path

    def emitted(self):
        self.paths = self.paths or self.program.count_for(self.name, self.count)
        return self.paths

    def forget(self):
        for path in self.stored:
            if os.path.exists(path):
                os.remove(path)
        self.stored = set()

    def picture(self, method, k):
        return self.path(method, k, "exr") if k else self.path(method, "exr")

    def measure(self, method, k, seed):
        relaxation, estimator, _ = METHODS[method]
        estimator = estimator.format(K=k)
        samples = self.options.samples
        key = f"{self.name} {self.count} {seed} {relaxation} {estimator} {samples} {self.digest}"
        key += "" if method in KEPT else " " + self.build
        out = self.picture(method, k)
        known = self.results.rows.get(key)
        if known and not (self.options.sheet and not os.path.exists(out)):
            return known
        stats = self.path("stats", "json")
        self.program.run(
            self.write_scene(f"estimator {{ {estimator} }}"),
            f"--load-photons={self.photons(relaxation, seed)}",
            f"+W{samples * caustic_scenes.SIZE}",
            f"+H{samples * caustic_scenes.SIZE}",
            "+FE",
            f"+O{out}",
            f"--stats={stats}",
        )
        average(out, samples)
        run = subprocess.run(
            [self.options.compare, "--json", "--layer", "caustic", out, self.reference],
            check=True,
            capture_output=True,
            text=True,
        )
        row = {"ssim": json.loads(run.stdout)["SSIM"], **self.errors(out)}
        with open(stats) as file:
            row["seconds"] = json.load(file)["seconds"]["processor"]
        self.results.keep(key, row)
        return row

    def errors(self, path):
        """RMSE and MRSE (as cognac-compare(1) has it) without the reference's noise."""
        picture = exr.layer(exr.read(path)[0], "caustic")
        square = (picture - self.halves[0]) * (picture - self.halves[1])
        relative = square / (self.truth**2 + 1e-2)
        return {"rmse": math.sqrt(max(0, square.mean())), "mrse": float(relative.mean())}

    def best(self, method):
        """The K of STEPS with the least RMSE: downhill by two steps from a guess that grows with
        the count, then by one."""
        seed = self.options.search_seed or self.options.first_seed
        tried = {}

        def at(i):
            if i not in tried:
                inside = 0 <= i < len(STEPS)
                tried[i] = self.measure(method, STEPS[i], seed)["rmse"] if inside else math.inf
            return tried[i]

        guess = (40 if METHODS[method][0] is None else 20) * math.sqrt(self.count / 134e3)
        i = min(range(1, len(STEPS), 2), key=lambda i: abs(math.log(STEPS[i] / guess)))
        way = 2 if at(i + 2) < at(i) else -2
        while at(i + way) < at(i):
            i += way
        return STEPS[min((i - 1, i, i + 1), key=at)]

    def row(self, method, k):
        first = self.options.first_seed
        seeds = range(first, first + (self.seeds if k < MANY else 1))
        rows = [self.measure(method, k, seed) for seed in reversed(seeds)]
        row = {
            key: sum(r[key] for r in rows) / len(rows)
            for key in ("rmse", "mrse", "ssim", "seconds")
        }
        spread = math.sqrt(
            sum((r["rmse"] - row["rmse"]) ** 2 for r in rows) / max(1, len(rows) - 1)
        )
        return dict(
            row,
            scene=self.name,
            count=self.count,
            method=method,
            k=k,
            spread=spread,
            mean=self.mean,
        )

    def rows(self, methods):
        for method in methods:
            for k in METHODS[method][2]:
                found = self.best(method) if k == BEST else k
                yield dict(self.row(method, found), best=k == BEST)
        if not self.options.keep:
            self.forget()


# ---- tables ----


def find_best(rows, scene, count):
    for row in rows:
        if (row["scene"], row["count"], row["method"], row["best"]) == (
            scene,
            count,
            "nearest",
            True,
        ):
            return row["rmse"]
    return None


def photons_needed(rows, row):
    """By nearest at its best K, from the line through two counts in logarithms: those around the
    RMSE, or the last two."""
    counts = sorted({r["count"] for r in rows if r["scene"] == row["scene"]})
    points = [
        (math.log(c), math.log(find_best(rows, row["scene"], c)))
        for c in counts
        if find_best(rows, row["scene"], c)
    ]
    if len(points) < 2:
        return None
    goal = math.log(row["rmse"])
    i = 0
    while i + 2 < len(points) and points[i + 1][1] > goal:
        i += 1
    (x0, y0), (x1, y1) = points[i], points[i + 1]
    return math.exp(x0 + (goal - y0) * (x1 - x0) / (y1 - y0)) if y1 < y0 else None


def print_row(row, base, needed):
    beside = f"{row['rmse'] / base:.3f}" if base else ""
    k = f"{row['k'] or ''}" + ("*" if row["best"] else " ")
    print(
        f"{row['method']:11} {k:>5} {row['rmse']:8.5f}  {row['rmse'] / row['mean']:7.4f}",
        f"{row['mrse']:8.5f} {row['ssim']:7.4f} {beside:>11}",
        f"{short(needed) if needed else '':>14} {row['seconds']:8.2f}",
    )


def print_table(rows, scene, count, texts):
    chosen = [row for row in rows if (row["scene"], row["count"]) == (scene, count)]
    mean = chosen[0]["mean"]
    error = float(texts.get("error", "nan"))
    print(
        f"\n{scene}, {short(count)} photons; reference of {short(int(texts['photons']))} photons,",
        f"its error {error:.3g}, {100 * error / mean:.1f}% of the mean {mean:.4g}",
    )
    print("method         K     RMSE  of mean     MRSE    SSIM  of nearest  nearest needs  seconds")
    base = find_best(rows, scene, count)
    for row in chosen:
        print_row(row, base, photons_needed(rows, row))
    sys.stdout.flush()


# ---- the whole ----


def add_method(text):
    """NAME:RELAXATION:ESTIMATOR[:K,K...]; nothing for no relaxation."""
    parts = text.split(":")
    ks = (
        tuple(BEST if k == BEST else int(k) for k in parts[3].split(","))
        if len(parts) > 3
        else (0,)
    )
    METHODS[parts[0]] = (
        parts[1] or None,
        parts[2].replace("{", "{{").replace("}", "}}").replace("%K", "{K}"),
        ks,
    )
    return parts[0]


def arguments():
    parser = argparse.ArgumentParser(description=__doc__)
    caustic_scenes.add_arguments(parser, threads=1)
    parser.add_argument("--references", default="references", help="the folder of the references")
    parser.add_argument("--folder", default="caustics-bench", help="for pictures and what is kept")
    parser.add_argument("--scene", default=",".join(caustic_scenes.SCENES[:4]))
    parser.add_argument("--counts", default="60k,134k,670k")
    parser.add_argument("--methods", default=",".join(METHODS))
    parser.add_argument(
        "--method",
        action="append",
        default=[],
        metavar="NAME:RELAXATION:ESTIMATOR[:K,K]",
        help="one more; %%K stands for a K, and a K may be 'best'",
    )
    parser.add_argument(
        "--seeds", default="3", help="how many sets of photons; or for each count, as 3,1"
    )
    parser.add_argument("--first-seed", type=int, default=1)
    parser.add_argument("--search-seed", type=int, default=100, help="0: the first seed")
    parser.add_argument(
        "--samples", type=int, default=2, help="of a pixel, both ways: all methods' alike"
    )
    parser.add_argument("--json", help="the rows also to this file")
    parser.add_argument(
        "--sheet", action="store_true", help="crops side by side in FOLDER/SCENE.COUNT.png"
    )
    parser.add_argument(
        "--keep", action="store_true", help="keep the photons' files for the next call"
    )
    return parser.parse_args()


def main():
    options = arguments()
    extra = [add_method(text) for text in options.method]
    methods = [m for m in options.methods.split(",") if m] + extra
    os.makedirs(options.folder, exist_ok=True)
    counts = [number(count) for count in options.counts.split(",")]
    seeds = [int(count) for count in options.seeds.split(",")]
    rows = []
    for scene in options.scene.split(","):
        for i, count in enumerate(counts):
            bench = Bench(options, scene, count, seeds[min(i, len(seeds) - 1)])
            new = list(bench.rows(methods))
            rows += new
            print_table(rows, scene, count, bench.texts)
            if options.sheet:
                pictures = [
                    (f"{r['method']} {r['k'] or ''}".strip(), bench.picture(r["method"], r["k"]))
                    for r in new
                ]
                caustic_sheet.write(
                    bench.path("png"),
                    caustic_scenes.CAMERAS[scene].crop,
                    [("reference", bench.reference)] + pictures,
                )
    if options.json:
        with open(options.json, "w") as file:
            json.dump(rows, file, indent=1)


if __name__ == "__main__":
    main()
